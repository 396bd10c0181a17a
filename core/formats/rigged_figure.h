// SPDX-License-Identifier: Apache-2.0
// A motion of ours on the body of another program, as scene files hold it: its skin, and its own bones by
// their names in their own rest pose, from the hips down. Bones beside the hips that hold skin hang on the
// hips, with which they go; what stands above them and holds none is left out. The body keeps its size.
// `at_rest`: as the performer's feet lie flat. `feet`: per frame, as from lockFeet(); empty: legs turn as
// ours.
#pragma once

#include "core/formats/figure.h"
#include "core/mesh/retarget/foot_lock.h"
#include "core/mesh/rig/wearable.h"

namespace noctule {

/// Upright and facing +Z whatever the file's own axes. `confidence` per frame and joint of the clip, or
/// empty: every bone has that of the joint that turns it or a bone above it. Bones that were made here
/// (WearableBody::landmarks) get their names by `names`, those of a file keep them; of two alike the second
/// gets a number. kUnusable as makeFigure() and Retargeter::make().
Result<Figure> riggedFigure(const MotionClip& clip, const std::vector<std::vector<float>>& confidence,
                            const WearableBody& body, JointNames names, const FeetAtRest& at_rest,
                            const std::vector<FootCorrections>& feet = {});

/// Index of the figure's joint for each mapped joint of ours, by canonical name.
std::map<std::string, int> figureJoints(const WearableBody& body);

/// The same motion with all joint frames parallel to the world in the rest pose, which becomes the zero pose.
MotionClip restParallel(const MotionClip& clip, const std::vector<Quaterniond>& q_world_rest);

}  // namespace noctule
