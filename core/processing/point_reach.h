// SPDX-License-Identifier: Apache-2.0
// How far points that a body wears can be from each other, whatever its pose: the joints between them turn,
// the bones keep their lengths.
#pragma once

#include <string>
#include <vector>

#include "core/body/actor.h"
#include "core/cooperative/lost_points.h"

namespace noctule {

/// A point in the rest pose and the segment that carries it.
struct WornPoint {
    std::string segment;
    Vector3d rest_m = Vector3d::Zero();
};

/// Per pair of points. A segment that the skeleton lacks is bound by nothing.
std::vector<std::vector<cooperative::Reach>> pointReaches(const Actor& actor,
                                                          const std::vector<WornPoint>& points);

}  // namespace noctule
