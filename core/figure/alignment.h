// SPDX-License-Identifier: Apache-2.0
// How the frames of a file's joints lie to those of our segments. A segment's frame may lie in any way to
// ours; the constant rotation between them is found from the zero pose where the trunk stands upright in it,
// else from the directions of the bones in their own frames and from how the figure moves: limbs along their
// bones, their twist from the plane in which elbow or knee bends, feet from soles and toes. Metres, Y up.
#pragma once

#include "core/figure/joint_mapping.h"

namespace noctule::figure {

struct Alignment {
    /// Per mapped canonical joint: q_world_canonical = q_world_source * q_source_canonical.
    std::map<std::string, Quaterniond> q_source_canonical;
    bool zero_trunk_stands = false;  ///< the zero pose's trunk was believed
};

/// `target`: the canonical skeleton whose bones and hinges are met.
Alignment alignFigure(const MotionClip& clip, const SeenMotion& seen, const JointMapping& mapping,
                      const Skeleton& target);

/// The bone of a skeleton from one joint to the next, or to its tip; zero without.
Vector3d boneOf(const Skeleton& skeleton, const std::string& joint, const std::string& child);

}  // namespace noctule::figure
