// SPDX-License-Identifier: Apache-2.0
// Where the root goes: the lowest point of the feet stands still on a level floor at y = 0. A body that
// jumps stays on the floor here, for attitudes alone do not tell of flight.
#pragma once

#include "core/body/actor.h"
#include "core/motion/foot_contacts.h"
#include "core/motion/timed_poses.h"

namespace noctule::posing {

/// Sets the root of every pose; the first one's root stands above the origin.
void placeRoot(const Skeleton& skeleton, std::vector<TimedPose>& poses);

}  // namespace noctule::posing
