// SPDX-License-Identifier: Apache-2.0
// Points and triangles, nothing else: what the mannequin's surface is while it is being made. Metres,
// triangles counter-clockwise seen from outside.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

struct TriangleMesh {
    std::vector<Vector3d> points;
    std::vector<std::array<uint32_t, 3>> triangles;
};

}  // namespace noctule
