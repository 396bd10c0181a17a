// SPDX-License-Identifier: Apache-2.0
// Draws many rectangles at once, each with a few vectors of its own: the shader makes the corners from
// gl_VertexID 0..3 (a triangle strip) and reads the vectors at locations 0, 1, ...
#pragma once

#include <vector>

#include "core/render/gl_objects.h"

namespace noctule {

class InstanceBatch {
public:
    /// Numbers per location, each 1..4.
    explicit InstanceBatch(const std::vector<int>& layout);
    /// The program must be in use. `values` holds whole instances.
    void draw(const std::vector<float>& values);
    /// The values of the last draw() once more.
    void drawAgain() const;

private:
    GlVertexArray vertex_array_;
    GlBuffer buffer_;
    size_t stride_ = 0;  ///< floats per instance
    GLsizei count_ = 0;
};

}  // namespace noctule
