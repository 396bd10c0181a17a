// SPDX-License-Identifier: Apache-2.0
// The first trajectory of a calibration from motion: the rest pose as asked for, every board levelled in it
// by its accelerometer, then carried on by its gyroscope and slowly held upright by gravity. Needs no filter,
// which a badly mounted suit could lead astray.
#pragma once

#include "core/calibration/motion/motion_evidence.h"
#include "core/calibration/motion/motion_model.h"
#include "core/calibration/motion/motion_priors.h"

namespace noctule {

/// Appends the take's nodes. `q_segment_board` per board: how boards sit if the rest pose is held exactly;
/// filled in when it is empty, else used as it is.
void appendFirstNodes(const MotionBody& body, const MotionModel& model, const MotionEvidence& evidence,
                      const ExpectedConstants& expected, std::vector<Quaterniond>& q_segment_board,
                      std::vector<MotionNode>& nodes);

}  // namespace noctule
