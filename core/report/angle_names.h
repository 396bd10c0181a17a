// SPDX-License-Identifier: Apache-2.0
// Anatomical names of the three Cardan angles of a joint, in the words of the ISB (Wu et al. 2002 and 2005).
// The angles themselves are those of motion/joint_angles.h, order Z, X, Y from the T pose; the ISB's order
// begins with flexion, so values differ where two angles are large.
#pragma once

#include <string>

namespace noctule {

/// Which way the angle is positive: "abduction" of ("LeftUpLeg", 0). `angle` 0: Z, 1: X, 2: Y. Empty: the
/// joint has no such name.
std::string anatomicalAngle(const std::string& joint, size_t angle);

}  // namespace noctule
