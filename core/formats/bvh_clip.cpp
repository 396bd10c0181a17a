// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "core/formats/bvh.h"
#include "core/formats/bvh_words.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

/// Where position channels differ from the OFFSET by less they only repeat it.

/// Place (file's unit) and rotation of one joint in its parent.
struct LocalPose {
    Vector3d place;
    Quaterniond q_parent_joint;
};

LocalPose localPose(const BvhJoint& joint, const double* row) {
    LocalPose local{joint.offset, Quaterniond::Identity()};
    for (size_t n = 0; n < joint.channels.size(); ++n) {
        const BvhChannel channel = joint.channels[n];
        const double value = row[joint.first_channel + n];
        if (isRotation(channel))
            local.q_parent_joint =
                local.q_parent_joint * axisAngle(Vector3d::Unit(axisOf(channel)), radians(value));
        else
            local.place[axisOf(channel)] = value;
    }
    return local;
}

/// Largest side of the box around all joints and end sites, in the file's unit; of the zero pose without a
/// row.
double extent(const BvhDocument& document, const double* row) {
    std::vector<LocalPose> world;
    Eigen::AlignedBox3d box;
    for (const BvhJoint& joint : document.joints) {
        LocalPose local = row ? localPose(joint, row) : LocalPose{joint.offset, Quaterniond::Identity()};
        if (joint.parent >= 0) {
            const LocalPose& parent = world[static_cast<size_t>(joint.parent)];
            local = {parent.place + parent.q_parent_joint * local.place,
                     parent.q_parent_joint * local.q_parent_joint};
        }
        world.push_back(local);
        box.extend(local.place);
        if (joint.end_site)
            box.extend(local.place + local.q_parent_joint * *joint.end_site);
    }
    return box.sizes().maxCoeff();
}

BvhUnitChoice nearestUnit(double height) {
    constexpr double kSmallest_m = 1.2, kTallest_m = 2.3;
    constexpr double kUnusual = 0.3;  // how much further off centimetres and metres may be, as a logarithm
    BvhUnitChoice best;
    double least = std::numeric_limits<double>::infinity();
    for (const BvhUnit unit : {BvhUnit::kCentimetre, BvhUnit::kMetre, BvhUnit::kCmu, BvhUnit::kInch,
                               BvhUnit::kMillimetre, BvhUnit::kDecimetre}) {
        const double height_m = height * metresPer(unit);
        const bool plausible = height_m >= kSmallest_m && height_m <= kTallest_m;
        const bool usual = unit == BvhUnit::kCentimetre || unit == BvhUnit::kMetre;
        const double off = std::max(std::log(kSmallest_m / height_m), std::log(height_m / kTallest_m));
        const double cost = plausible ? 0 : off + (usual ? 0 : kUnusual);
        if (cost < least) {
            least = cost;
            best = {unit, height_m, plausible};
        }
    }
    return best;
}

Joint jointFrom(const BvhJoint& read, double metres_per_unit) {
    Joint joint;
    joint.name = read.name;
    joint.parent = read.parent;
    joint.offset_m = read.offset * metres_per_unit;
    joint.type = read.parent < 0 ? JointType::kFree : JointType::kBall;
    if (joint.type == JointType::kBall)
        for (int axis = 0; axis < 3; ++axis)
            joint.dof.push_back({std::string("rotation_") + "xyz"[axis], Vector3d::Unit(axis)});
    if (read.end_site)
        joint.end_m = *read.end_site * metres_per_unit;
    return joint;
}

bool movesInParent(const BvhDocument& document, double metres_per_unit) {
    const double same_place = kSamePlace_m / metres_per_unit;
    return std::any_of(document.joints.begin() + 1, document.joints.end(), [&](const BvhJoint& joint) {
        for (size_t n = 0; n < joint.channels.size(); ++n)
            if (!isRotation(joint.channels[n])) {
                const double offset = joint.offset[axisOf(joint.channels[n])];
                for (size_t v = joint.first_channel + n; v < document.values.size();
                     v += document.channel_count)
                    if (!(std::abs(document.values[v] - offset) <= same_place))
                        return true;
            }
        return false;
    });
}

}  // namespace

/// The zero pose stands upright in most files. Where it is crumpled (all bones along one axis, or places
/// given by position channels only) the first frame is larger and tells more.
BvhUnitChoice chooseUnit(const BvhDocument& document) {
    const double zero_pose = extent(document, nullptr);
    const BvhUnitChoice choice = nearestUnit(zero_pose);
    if (document.frameCount() == 0)
        return choice;
    const double first_frame = extent(document, document.values.data());
    return first_frame > (choice.plausible ? 2 : 1) * zero_pose ? nearestUnit(first_frame) : choice;
}

Result<MotionClip> toClip(const BvhDocument& document, BvhUnit unit) {
    if (document.frameCount() == 0)
        return Error{ErrorKind::kUnusable, document.name + ": the motion has no frames",
                     "Choose a file with motion"};
    const double scale = metresPer(unit == BvhUnit::kAuto ? chooseUnit(document).unit : unit);
    std::vector<Joint> joints;
    for (const BvhJoint& joint : document.joints)
        joints.push_back(jointFrom(joint, scale));
    Result<Skeleton> skeleton = Skeleton::make(std::move(joints));
    if (!skeleton)
        return skeleton.error();

    const bool translations = movesInParent(document, scale);
    MotionClip clip{document.name, std::move(*skeleton), document.frame_time_s, {}, {}};
    clip.frames.resize(document.frameCount());
    clip.p_parent_joint_m.resize(translations ? document.frameCount() : 0);
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        const double* row = document.values.data() + f * document.channel_count;
        for (size_t j = 0; j < document.joints.size(); ++j) {
            const LocalPose local = localPose(document.joints[j], row);
            clip.frames[f].q_parent_joint.push_back(local.q_parent_joint);
            if (j == 0)
                clip.frames[f].p_world_root = local.place * scale;
            if (translations)
                clip.p_parent_joint_m[f].push_back(local.place * scale);
        }
    }
    return clip;
}

}  // namespace noctule
