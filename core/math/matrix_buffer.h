// SPDX-License-Identifier: Apache-2.0
// Room for a matrix that is made again and again: it grows to the largest that was asked for and then is
// allocated no more. A copy is another room, empty.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace noctule {

class MatrixBuffer {
public:
    MatrixBuffer() = default;
    MatrixBuffer(const MatrixBuffer&) {}
    MatrixBuffer& operator=(const MatrixBuffer&) { return *this; }

    /// A matrix with anything in it; the one given before is gone.
    Eigen::Map<Eigen::MatrixXd> shaped(Eigen::Index rows, Eigen::Index columns) {
        const auto size = static_cast<size_t>(rows * columns);
        if (values_.size() < size)
            values_.resize(size);
        return {values_.data(), rows, columns};
    }

private:
    std::vector<double> values_;
};

}  // namespace noctule
