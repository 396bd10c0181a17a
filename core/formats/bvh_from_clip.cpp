// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "core/formats/bvh.h"
#include "core/formats/bvh_words.h"

namespace noctule {
namespace {

constexpr double kShortTip_m = 0.05;

/// Blanks and braces end a name in some readers; names stay different from each other.
std::string nameInFile(const std::string& joint_name, std::unordered_set<std::string>& taken) {
    std::string plain = joint_name;
    for (char& c : plain)
        if (c == '{' || c == '}' || static_cast<unsigned char>(c) <= ' ')
            c = '_';
    std::string unique = plain;
    for (int n = 2; !taken.insert(unique).second; ++n)
        unique = plain + "_" + std::to_string(n);
    return unique;
}

std::vector<std::vector<size_t>> childrenOf(const std::vector<Joint>& joints) {
    std::vector<std::vector<size_t>> children(joints.size());
    for (size_t j = 1; j < joints.size(); ++j)
        children[static_cast<size_t>(joints[j].parent)].push_back(j);
    return children;
}

/// A file lists every joint directly among its parent's descendants; skeletons need not.
std::vector<size_t> depthFirst(const std::vector<std::vector<size_t>>& children) {
    std::vector<size_t> order, waiting{0};
    while (!waiting.empty()) {
        const size_t joint = waiting.back();
        waiting.pop_back();
        order.push_back(joint);
        waiting.insert(waiting.end(), children[joint].rbegin(), children[joint].rend());
    }
    return order;
}

/// Not a number counts as moving, so that the check of the values meets it.
bool movesInParent(const MotionClip& clip, size_t joint) {
    const Vector3d& offset_m = clip.skeleton.joints()[joint].offset_m;
    return std::any_of(
        clip.p_parent_joint_m.begin(), clip.p_parent_joint_m.end(),
        [&](const std::vector<Vector3d>& p_m) { return !((p_m[joint] - offset_m).norm() <= kSamePlace_m); });
}

/// A leaf needs an end site; without a known tip the segment goes on for a little.
Vector3d tipOf(const Joint& joint) {
    if (joint.end_m)
        return *joint.end_m;
    const double length_m = joint.offset_m.norm();
    return length_m > 0 ? Vector3d(joint.offset_m * (kShortTip_m / length_m)) : Vector3d(0, kShortTip_m, 0);
}

std::vector<BvhChannel> channelsOf(bool positions, const EulerOrder& rotation_order) {
    std::vector<BvhChannel> channels;
    for (int axis = 0; positions && axis < 3; ++axis)
        channels.push_back(positionChannel(axis));
    for (const int axis : rotation_order)
        channels.push_back(rotationChannel(axis));
    return channels;
}

void addJoints(const MotionClip& clip, const BvhOptions& options, const std::vector<size_t>& order,
               const std::vector<std::vector<size_t>>& children, BvhDocument& document) {
    std::unordered_set<std::string> names;
    std::vector<int> place(order.size());  // of a clip's joint in the document
    for (const size_t j : order) {
        const Joint& from = clip.skeleton.joints()[j];
        place[j] = static_cast<int>(document.joints.size());
        BvhJoint joint;
        joint.name = nameInFile(from.name, names);
        joint.parent = j == 0 ? -1 : place[static_cast<size_t>(from.parent)];
        joint.offset = from.offset_m / options.metres_per_unit;
        joint.channels = channelsOf(j == 0 || movesInParent(clip, j), options.rotation_order);
        joint.first_channel = document.channel_count;
        document.channel_count += joint.channels.size();
        if (children[j].empty())
            joint.end_site = tipOf(from) / options.metres_per_unit;
        document.joints.push_back(std::move(joint));
    }
}

/// `angles_rad` are those of the row before, per joint of the document.
void addRow(const MotionClip& clip, size_t frame, const BvhOptions& options, const std::vector<size_t>& order,
            std::vector<Vector3d>& angles_rad, BvhDocument& document) {
    const Pose& pose = clip.frames[frame];
    for (size_t n = 0; n < order.size(); ++n) {
        const size_t j = order[n];
        if (!isRotation(document.joints[n].channels.front())) {
            const Vector3d p_m = j == 0 ? pose.p_world_root : clip.p_parent_joint_m[frame][j];
            for (int axis = 0; axis < 3; ++axis)
                document.values.push_back(p_m[axis] / options.metres_per_unit);
        }
        angles_rad[n] = eulerFromRotation(options.rotation_order, pose.q_parent_joint[j], angles_rad[n]);
        for (int axis = 0; axis < 3; ++axis)
            document.values.push_back(degrees(angles_rad[n][axis]));
    }
}

Status checkFinite(const BvhDocument& document) {
    const auto wrong = std::find_if_not(document.values.begin(), document.values.end(),
                                        [](double v) { return std::isfinite(v); });
    if (wrong == document.values.end())
        return Done{};
    const size_t index = static_cast<size_t>(wrong - document.values.begin());
    const size_t channel = index % document.channel_count;
    const auto after = std::find_if(document.joints.begin(), document.joints.end(),
                                    [&](const BvhJoint& j) { return j.first_channel > channel; });
    return Error{ErrorKind::kUnusable,
                 document.name + ": frame " + std::to_string(index / document.channel_count + 1) +
                     " of joint " + std::prev(after)->name + " is not a finite number",
                 "Process the take again or leave this part out"};
}

}  // namespace

Result<BvhDocument> toDocument(const MotionClip& clip, const BvhOptions& options) {
    require(options.metres_per_unit > 0, "a unit of length is positive");
    if (clip.frames.empty())
        return Error{ErrorKind::kUnusable, clip.name + ": the motion has no frames",
                     "Choose a longer part of it"};
    BvhDocument document;
    document.name = clip.name;
    document.frame_time_s = clip.frame_time_s;
    document.declared_frames = clip.frames.size();
    const std::vector<std::vector<size_t>> children = childrenOf(clip.skeleton.joints());
    const std::vector<size_t> order = depthFirst(children);
    addJoints(clip, options, order, children, document);
    document.values.reserve(clip.frames.size() * document.channel_count);
    std::vector<Vector3d> angles_rad(order.size(), Vector3d::Zero());
    for (size_t frame = 0; frame < clip.frames.size(); ++frame)
        addRow(clip, frame, options, order, angles_rad, document);
    if (Status finite = checkFinite(document); !finite)
        return finite.error();
    return document;
}

}  // namespace noctule
