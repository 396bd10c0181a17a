// SPDX-License-Identifier: Apache-2.0
#include "core/render/instance_batch.h"

#include <numeric>

namespace noctule {

InstanceBatch::InstanceBatch(const std::vector<int>& layout)
    : vertex_array_(makeVertexArray()),
      buffer_(makeBuffer()),
      stride_(static_cast<size_t>(std::accumulate(layout.begin(), layout.end(), 0))) {
    glBindVertexArray(vertex_array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    size_t offset = 0;
    for (size_t i = 0; i < layout.size(); ++i) {
        const auto location = static_cast<GLuint>(i);
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, layout[i], GL_FLOAT, GL_FALSE,
                              static_cast<GLsizei>(stride_ * sizeof(float)),
                              reinterpret_cast<const void*>(offset * sizeof(float)));
        glVertexAttribDivisor(location, 1);
        offset += static_cast<size_t>(layout[i]);
    }
}

void InstanceBatch::draw(const std::vector<float>& values) {
    count_ = static_cast<GLsizei>(values.size() / stride_);
    if (count_ == 0)
        return;
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data(),
                 GL_STREAM_DRAW);
    drawAgain();
}

void InstanceBatch::drawAgain() const {
    if (count_ == 0)
        return;
    glBindVertexArray(vertex_array_);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

}  // namespace noctule
