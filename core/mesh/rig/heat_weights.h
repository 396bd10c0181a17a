// SPDX-License-Identifier: Apache-2.0
// How a skin hangs on bones that lie in it, by heat that spreads over the surface (Baran & Popovic 2007,
// "Automatic rigging and animation of 3D characters", section 4): every bone in turn is hot, all others are
// cold, every point is warmed by its nearest bone that it sees, and the temperature is the weight.
#pragma once

#include <Eigen/Core>

#include "core/job/job.h"
#include "core/mesh/triangle_mesh.h"

namespace noctule {

/// A piece of a bone, a straight line; several may belong to one.
struct BoneLine {
    int bone = 0;
    Vector3d from_m, to_m;
};

struct HeatSettings {
    /// How strongly a bone warms against what the skin spreads; larger: harder borders. The paper's is 1; on
    /// MakeHuman's figure 1, 3, 5 and 10 differ from the artists' weights by 16, 13, 13 and 13 %.
    double warmth = 5;
};

/// One row per point, one column per bone (0 to `bones` - 1); rows sum to 1. Every bone that has no line
/// stays cold. kUnusable when the surface cannot be solved (no area); kCancelled.
Result<Eigen::MatrixXd> heatWeights(const TriangleMesh& mesh, const std::vector<BoneLine>& lines, int bones,
                                    const HeatSettings& settings = {}, const JobContext& job = {});

}  // namespace noctule
