// SPDX-License-Identifier: Apache-2.0
// What contacts of feet say to bodies that wear a motion: when feet stand, and how they lie flat.
#pragma once

#include <vector>

#include "core/mesh/retarget/feet_at_rest.h"
#include "core/motion/foot_contacts.h"
#include "core/motion/timed_poses.h"

namespace noctule {

/// When feet stand, in seconds from `begin_s` of the take's clock; what overlaps is one stand.
FootPlants footPlants(const std::vector<FootContacts>& feet, double begin_s);

/// As feetAtRest() of mesh/feet_at_rest.h; `feet` are contacts of the motion.
FeetAtRest feetAtRest(const TimedMotion& motion, const std::vector<FootContacts>& feet);

}  // namespace noctule
