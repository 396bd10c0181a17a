// SPDX-License-Identifier: Apache-2.0
// What speaks against a calibration from motion, by name, with the remedy.
#pragma once

#include "core/calibration/motion/motion_calibration.h"
#include "core/calibration/motion/motion_evidence.h"
#include "core/calibration/motion/motion_unknowns.h"
#include "core/calibration/still_stretch.h"

namespace noctule {

/// Of one take, before anything is fitted.
void addEvidenceFindings(const Observations& take, const StillStretch& still, const MotionEvidence& evidence,
                         std::vector<Finding>& into);
/// Too short, or joints that moved too little to show how the boards below them sit; from the first
/// trajectory of all takes. `board_segments`: of each board.
void addMovementFindings(const MotionSettings& settings, const MotionBody& body,
                         const std::vector<int>& board_segments, const std::vector<MotionNode>& nodes,
                         double moved_s, std::vector<Finding>& into);
/// Which movement shows how the board on a segment sits: one sentence without its full stop.
std::string howToMove(const BodySegment& segment);
/// Of what was found.
void addResultFindings(const Observations& take, const MotionReport& report, std::vector<Finding>& into);

}  // namespace noctule
