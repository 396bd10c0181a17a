// SPDX-License-Identifier: Apache-2.0
// The lens's derivatives.
#include "core/vision/bundle.h"

#include "tests/support/jacobian_checker.h"

namespace noctule {
namespace {

TEST(Lens, Jacobians) {
    Lens lens{1500, {800, 610}, -0.2, 0.1};
    for (const Vector3d& p : {Vector3d(0, 0, 1), Vector3d(0.3, -0.4, 0.9), Vector3d(-1, 0.8, 1.5)}) {
        LensJacobians jacobians;
        project(lens, p, &jacobians);
        testing::expectJacobian(
            [&](const Eigen::VectorXd& d) -> Eigen::VectorXd { return project(lens, p + d); },
            jacobians.J_pixel_point, "point");
        testing::expectJacobian(
            [&](const Eigen::VectorXd& d) -> Eigen::VectorXd {
                Lens moved = lens;
                moved.add(d);
                return project(moved, p);
            },
            jacobians.J_pixel_lens, "lens");
    }
}

}  // namespace
}  // namespace noctule
