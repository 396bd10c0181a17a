// SPDX-License-Identifier: Apache-2.0
// Two skeletons of one performer: how the frames of the second one's segments lie to those of the first.
// Rest poses and joint axes differ between systems (T, A, arms down, all bones along X), so rotations compare
// only after a constant rotation per segment. Zero poses tell it where the second one stands or sits in its
// own. Else bones tell it in their joints' frames, and the mean over both motions tells what bones do not
// show; constant errors of that part cannot be seen any more.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/body/skeleton.h"
#include "core/motion/common_joints.h"

namespace noctule {

enum class FrameFrom {
    kSame,      ///< both zero poses agree: no rotation
    kZeroPose,  ///< from the bones in both zero poses
    kMotion,    ///< from the motions; a constant difference is taken off
};

struct SegmentMatch {
    Quaterniond q_second_first = Quaterniond::Identity();  ///< q_world_first = q_world_second * this
    FrameFrom from = FrameFrom::kSame;
    double taken_off_rad = 0;  ///< kMotion: constant difference beyond what the zero poses tell
};

/// By the zero poses, one per common joint; nothing when the second one's zero pose is no body: trunk upright
/// over the hips, limbs that mirror each other, legs that do not point up. Figures without all four limbs in
/// common are taken to have the same axes.
std::optional<std::vector<SegmentMatch>> matchZeroPoses(const Skeleton& first, const Skeleton& second,
                                                        const std::vector<CommonJoint>& common);

/// True when all zero poses agree: nothing is left to find.
bool isSameFigure(const std::vector<SegmentMatch>& matches);

/// Both performers at the same instants, on any two worlds whose verticals agree.
using PosePairs = std::vector<std::pair<GlobalPose, GlobalPose>>;

/// Keeps of `known` what the motions agree with within kBelievable_rad, and finds the rest.
std::vector<SegmentMatch> matchMotions(const Skeleton& first, const Skeleton& second,
                                       const std::vector<CommonJoint>& common, const PosePairs& pairs,
                                       std::optional<std::vector<SegmentMatch>> known);

/// Larger than the errors of a rest pose calibration, smaller than differences of convention. 15 degrees.
constexpr double kBelievable_rad = 0.26;

}  // namespace noctule
