// SPDX-License-Identifier: Apache-2.0
// The lens's derivatives, and the bundle against a jig that is known.
#include "core/vision/bundle.h"

#include "tests/core/vision/known_bundle.h"
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

/// Cameras a degree and a centimetre off, markers three degrees and half a centimetre, the lens 2 %.
Bundle startedWrongly(Bundle bundle) {
    std::mt19937 random(3);
    std::normal_distribution<double> gaussian;
    const auto off = [&](double sigma) {
        return Vector3d{sigma * gaussian(random), sigma * gaussian(random), sigma * gaussian(random)};
    };
    for (CameraPose& camera : bundle.cameras)
        if (!camera.stays) {
            camera.q_camera_jig = camera.q_camera_jig * expQuaternion(off(radians(1)));
            camera.p_camera_jig_m += off(0.01);
        }
    for (MarkerPose& marker : bundle.markers) {
        marker.q_jig_marker = marker.q_jig_marker * expQuaternion(off(radians(3)));
        marker.p_jig_marker_m += off(0.005);
    }
    bundle.lenses[0].focal_px *= 1.02;
    bundle.lenses[0].k1 += 0.01;
    return bundle;
}

TEST(Bundle, FindsWhereExactCornersWereTaken) {
    const Bundle truth = test::knownBundle(4);
    ASSERT_LT(test::worstSighting_px(truth), 1e-6);
    Bundle bundle = startedWrongly(truth);
    ASSERT_GT(test::worstSighting_px(bundle), 10) << "else the test shows nothing";
    const auto fit = adjust(bundle, {});
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->converged);
    EXPECT_LT(test::worstSighting_px(bundle), 1e-3);
    EXPECT_LT(test::worstDistance_m(bundle, truth), 1e-6);
    EXPECT_NEAR(bundle.lenses[0].focal_px, truth.lenses[0].focal_px, 0.01);
    EXPECT_EQ(bundle.cameras[0].p_camera_jig_m, truth.cameras[0].p_camera_jig_m) << "it stays";
}

TEST(Bundle, ReachesTheBottomInAFewSteps) {
    constexpr int kDraws = 12;
    for (unsigned draw = 1; draw <= kDraws; ++draw) {
        Bundle bundle = startedWrongly(test::knownBundle(4));
        std::mt19937 random(draw);
        std::normal_distribution<double> error_px(0, 0.2);
        for (Sighting& sighting : bundle.sightings)
            for (Eigen::Vector2d& corner_px : sighting.corners_px)
                corner_px += Eigen::Vector2d{error_px(random), error_px(random)};
        const auto fit = adjust(bundle, {});
        ASSERT_TRUE(fit);
        EXPECT_TRUE(fit->converged) << "draw " << draw;
        EXPECT_NEAR(fit->sigma_px, 0.2, 0.02) << "draw " << draw;
        EXPECT_LE(fit->iterations, 30) << "draw " << draw << ": derivatives that are wrong take more";
    }
}

TEST(Bundle, TheMarkersSideIsTheScale) {
    const Bundle truth = test::knownBundle(4);
    Bundle bundle = startedWrongly(truth);
    bundle.side_m *= 1.1;
    ASSERT_TRUE(adjust(bundle, {}));
    // The first camera stays: all is a tenth larger as seen from there.
    EXPECT_LT(test::worstDistance_m(bundle, truth, 1.1), 1e-5);
}

TEST(Bundle, AWildMarkerPullsLittle) {
    const Bundle truth = test::knownBundle(4);
    Bundle bundle = startedWrongly(truth);
    for (Eigen::Vector2d& corner_px : bundle.sightings[7].corners_px)
        corner_px.x() += 30;
    const int wild = bundle.sightings[7].marker;
    ASSERT_TRUE(adjust(bundle, {}));
    for (Sighting& sighting : bundle.sightings)
        sighting.used = sighting.marker != wild;
    EXPECT_LT(test::worstDistance_m(bundle, truth), 1e-4);
}

}  // namespace
}  // namespace noctule
