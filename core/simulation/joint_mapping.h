// SPDX-License-Identifier: Apache-2.0
// Which joint of a motion file is which canonical joint. Knows the names of CMU, HumanIK and Mixamo,
// Biovision (Collar, Elbow, Wrist, Knee, ...), MakeHuman, VRM and Poser; hips and trunk are found from the
// tree itself.
#pragma once

#include <map>
#include <string>

#include "core/body/skeleton.h"

namespace noctule::simulation {

/// Canonical name -> joint index in the source. Shoulders, Spine, Chest, Neck, Head, hands, feet and toes may
/// be absent; hips, thighs, shins, upper arms and forearms are always there.
using JointMapping = std::map<std::string, int>;

/// Fails (kUnusable) and names the canonical joints that could not be found.
Result<JointMapping> mapJoints(const Skeleton& source, const std::string& where);

}  // namespace noctule::simulation
