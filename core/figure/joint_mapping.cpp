// SPDX-License-Identifier: Apache-2.0
#include "core/figure/joint_mapping.h"

#include <algorithm>
#include <cmath>

#include "core/body/actor.h"
#include "core/body/bone_names.h"
#include "core/body/joint_names.h"
#include "core/figure/joint_shape.h"

namespace noctule::figure {
namespace {

constexpr const char* kRequired[] = {"Arm", "ForeArm", "UpLeg", "Leg"};
constexpr const char* kMapRemedy =
    "Say which joint is which with --bones MAP.json, or rename the file's joints after HumanIK, for example "
    "LeftUpLeg, LeftLeg, LeftArm, LeftForeArm";

std::vector<std::string> missingLimbs(const JointMapping& mapping) {
    std::vector<std::string> missing;
    for (const std::string side : {"Left", "Right"})
        for (const char* joint : kRequired)
            if (!mapping.contains(side + joint))
                missing.push_back(side + joint);
    return missing;
}

JointMapping byNames(const Skeleton& skeleton) {
    std::vector<NamedBone> bones;
    for (const Joint& joint : skeleton.joints())
        bones.push_back({joint.name, joint.parent, true});
    return jointsByName(bones).bone_of_joint;
}

bool plays(const JointMapping& mapping, int joint) {
    return std::any_of(mapping.begin(), mapping.end(), [&](const auto& m) { return m.second == joint; });
}

/// Joints that the figure's shape shows and no name gives. Where both speak of a limb with different sides,
/// the names say which side it is.
void completeByShape(const MotionClip& clip, const SeenMotion& seen, MappedJoints& mapped) {
    JointMapping shape = jointsByShape(clip, seen);
    int same = 0, crossed = 0;
    for (const auto& [name, joint] : mapped.joints) {
        const auto found = shape.find(name);
        same += found != shape.end() && found->second == joint;
        const auto other = shape.find(mirroredSegment(name));
        crossed += other != shape.end() && other->second == joint && mirroredSegment(name) != name;
    }
    if (crossed > same) {
        JointMapping turned;
        for (const auto& [name, joint] : shape)
            turned[mirroredSegment(name)] = joint;
        shape = std::move(turned);
    }
    for (const auto& [name, joint] : shape)
        if (!mapped.joints.contains(name) && !plays(mapped.joints, joint)) {
            mapped.joints[name] = joint;
            mapped.by_shape.push_back(name);
        }
}

/// Where a file calls the middle of the hand "hand" or the ball of the foot "foot", the wrist and the ankle
/// are the joints above: a forearm is about as long as its upper arm, a shin as its thigh.
void takeEndOfLimb(const Skeleton& skeleton, const SeenMotion& seen, JointMapping& mapping,
                   const std::string& upper, const std::string& lower, const std::string& end,
                   const std::string& beyond) {
    if (!mapping.contains(end))
        return;
    const int last = mapping.at(end);
    const double first_length = seen.distance(mapping.at(upper), mapping.at(lower));
    const double length = seen.distance(mapping.at(lower), last);
    if (length < 1.15 * first_length)
        return;
    const auto unlike = [&](double other) { return std::abs(std::log(other / first_length)); };
    int best = last;
    double least = unlike(length);
    for (const int joint : chainBetween(skeleton, mapping.at(lower), last))
        if (const double other = seen.distance(mapping.at(lower), joint);
            other > 0.6 * first_length && unlike(other) < least) {
            best = joint;
            least = unlike(other);
        }
    if (best == last)
        return;
    mapping[end] = best;
    if (!beyond.empty() && !mapping.contains(beyond))
        mapping[beyond] = last;
}

/// Hips carry both thighs, the chest carries both arms, the spine is half way between.
void mapTrunk(const Skeleton& source, JointMapping& mapping) {
    const int hips = commonAncestor(source, mapping.at("LeftUpLeg"), mapping.at("RightUpLeg"));
    const int chest = commonAncestor(source, mapping.at("LeftArm"), mapping.at("RightArm"));
    mapping["Hips"] = hips;
    if (chest == hips)
        return;
    mapping["Chest"] = chest;
    const std::vector<int> trunk = chainBetween(source, commonAncestor(source, hips, chest), chest);
    if (trunk.size() > 1)
        mapping["Spine"] = trunk[(trunk.size() - 1) / 2];
}

Result<JointMapping> readByHand(const Skeleton& source, const JointsByHand& by_hand,
                                const std::string& where) {
    JointMapping mapping;
    for (const auto& [joint, name] : by_hand) {
        const auto& known = canonicalJointNames();
        if (std::find(known.begin(), known.end(), joint) == known.end())
            return Error{ErrorKind::kUnusable, where + ": the bone map speaks of a joint " + joint,
                         "Take one of LeftUpLeg, LeftLeg, LeftFoot, LeftArm, LeftForeArm, LeftHand, Hips, "
                         "Spine, Chest, Neck, Head and the like"};
        const int found = source.find(name);
        if (found < 0)
            return Error{ErrorKind::kUnusable,
                         where + ": the bone map says that " + joint + " is " + name +
                             ", and the file has no such joint",
                         "Write the joint's name as the file has it"};
        if (plays(mapping, found))
            return Error{ErrorKind::kUnusable, where + ": the bone map gives " + name + " to two joints",
                         "Give every joint another one of the file"};
        mapping[joint] = found;
    }
    return mapping;
}

}  // namespace

Result<MappedJoints> mapJoints(const MotionClip& clip, const SeenMotion& seen, const JointsByHand& by_hand,
                               const std::string& where) {
    Result<JointMapping> corrected = readByHand(clip.skeleton, by_hand, where);
    if (!corrected)
        return corrected.error();
    MappedJoints mapped;
    for (const auto& [name, joint] : byNames(clip.skeleton))
        if (!corrected->contains(name) && !plays(*corrected, joint))
            mapped.joints[name] = joint;
    for (const auto& [name, joint] : *corrected) {
        mapped.joints[name] = joint;
        mapped.by_hand.push_back(name);
    }
    completeByShape(clip, seen, mapped);
    std::string missing;
    for (const std::string& joint : missingLimbs(mapped.joints))
        missing += (missing.empty() ? "" : ", ") + joint;
    if (!missing.empty())
        return Error{ErrorKind::kUnusable, where + ": no joint was recognised as " + missing, kMapRemedy};

    JointMapping& joints = mapped.joints;
    for (const std::string side : {"Left", "Right"}) {
        const auto free = [&](const std::string& joint) {
            return corrected->contains(side + joint) ? std::string() : side + joint;
        };
        takeEndOfLimb(clip.skeleton, seen, joints, side + "Arm", side + "ForeArm", free("Hand"), "");
        takeEndOfLimb(clip.skeleton, seen, joints, side + "UpLeg", side + "Leg", free("Foot"),
                      free("ToeBase"));
    }
    for (const char* joint : {"Hips", "Spine", "Chest"})
        joints.erase(joint);
    mapTrunk(clip.skeleton, joints);
    for (const auto& [name, joint] : *corrected)
        joints[name] = joint;
    return mapped;
}

Result<JointMapping> mapJoints(const MotionClip& clip) {
    Result<MappedJoints> mapped = mapJoints(clip, SeenMotion(clip, 200), {}, clip.name);
    if (!mapped)
        return mapped.error();
    return mapped->joints;
}

}  // namespace noctule::figure
