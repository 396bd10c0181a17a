// SPDX-License-Identifier: Apache-2.0
// Our skeleton in a figure that has none: joints at its landmarks, weights by heat.
#pragma once

#include "core/job/job.h"
#include "core/mesh/rig/body_landmarks.h"
#include "core/mesh/rig/heat_weights.h"
#include "core/mesh/rigged_mesh.h"

namespace noctule {

/// Nodes are the canonical joints, frames parallel to the world, rest pose as the figure stands; its own
/// nodes, bones and clips are dropped. A missing landmark is kUsage; else as heatWeights(), with `where`
/// before it.
Result<RiggedMesh> autoRigged(const RiggedMesh& figure, const Landmarks& landmarks, const std::string& where,
                              const HeatSettings& settings = {}, const JobContext& job = {});

}  // namespace noctule
