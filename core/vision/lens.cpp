// SPDX-License-Identifier: Apache-2.0
#include "core/vision/lens.h"

#include <cmath>

namespace noctule {

void Lens::add(const Values& step) {
    focal_px *= std::exp(step[0]);
    center_px += step.segment<2>(1);
    k1 += step[3];
    k2 += step[4];
    edge_px += step[5];
}

Eigen::Vector2d project(const Lens& lens, const Vector3d& p_camera, LensJacobians* jacobians) {
    using Eigen::Matrix2d, Eigen::Vector2d;
    const double by_z = 1 / p_camera.z();
    const Vector2d m = p_camera.head<2>() * by_z;
    const double r2 = m.squaredNorm(), bend = 1 + r2 * (lens.k1 + r2 * lens.k2);
    if (jacobians) {
        Eigen::Matrix<double, 2, 3> J_m_point;
        J_m_point << by_z, 0, -m.x() * by_z, 0, by_z, -m.y() * by_z;
        const Matrix2d J_bent_m =
            bend * Matrix2d::Identity() + (2 * lens.k1 + 4 * r2 * lens.k2) * m * m.transpose();
        jacobians->J_pixel_point = lens.focal_px * J_bent_m * J_m_point;
        jacobians->J_pixel_lens << lens.focal_px * bend * m, Matrix2d::Identity(), lens.focal_px * r2 * m,
            lens.focal_px * r2 * r2 * m, Vector2d::Zero();
    }
    return lens.center_px + lens.focal_px * bend * m;
}

}  // namespace noctule
