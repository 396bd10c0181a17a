// SPDX-License-Identifier: Apache-2.0
// The matrix and zero that bring readings of a constant vector to one length: |matrix * (reading - zero)| =
// length. Robust nonlinear least squares (Levenberg-Marquardt with Tukey's weights).
#pragma once

#include <string>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

enum class EllipsoidForm {
    kSymmetric,        ///< soft iron: no turn of its own
    kUpperTriangular,  ///< misaligned axes; the first axis is the reference (Tedaldi 2014)
};

struct EllipsoidFit {
    Vector3d zero = Vector3d::Zero(), sigma_zero = Vector3d::Zero();
    Matrix3d matrix = Matrix3d::Identity();
    double residual = 0;   ///< rms of the lengths of what was believed, in units of the length
    double condition = 0;  ///< of the normal equations in scaled unknowns; large: not determined
    size_t used = 0, doubted = 0;
    int iterations = 0;
    bool converged = false;
};

/// At least 10 readings of which none is NaN.
EllipsoidFit fitEllipsoid(const std::vector<Vector3d>& readings, double length, EllipsoidForm form);

/// Which of 26 directions (faces, edges and corners of a cube) vectors point to.
struct DirectionCoverage {
    static constexpr int kDirections = 26;
    int covered = 0;
    std::vector<std::string> missing;  ///< "+x", "-y+z", ...: faces first
};
DirectionCoverage coverageOf(const std::vector<Vector3d>& vectors);

}  // namespace noctule
