// SPDX-License-Identifier: Apache-2.0
// Which joint of a motion file is which canonical joint: by the table of names (core/body/bone_names.h),
// completed by the shape of the figure (joint_shape.h), corrected by hand. Hips and trunk are found from the
// tree itself.
#pragma once

#include <map>
#include <string>

#include "core/figure/seen_motion.h"

namespace noctule::figure {

/// Canonical name -> joint index in the source. Shoulders, Spine, Chest, Neck, Head, hands, feet and toes may
/// be absent; hips, thighs, shins, upper arms and forearms are always there.
using JointMapping = std::map<std::string, int>;

/// Canonical joint -> name of the file's joint, as a bone map gives it.
using JointsByHand = std::map<std::string, std::string>;

struct MappedJoints {
    JointMapping joints;
    std::vector<std::string> by_shape;  ///< canonical joints that no name gave
    std::vector<std::string> by_hand;
};

/// Fails (kUnusable) and names the canonical joints that could not be found, or a joint by hand that the file
/// or our skeleton does not have. `where` names the file.
Result<MappedJoints> mapJoints(const MotionClip& clip, const SeenMotion& seen, const JointsByHand& by_hand,
                               const std::string& where);
/// The same without corrections.
Result<JointMapping> mapJoints(const MotionClip& clip);

}  // namespace noctule::figure
