// SPDX-License-Identifier: Apache-2.0
// Where the bundle begins: exact corners give exact poses, whichever way each square seems to lean.
#include "core/vision/first_poses.h"

#include <numeric>

#include "tests/core/vision/known_bundle.h"

namespace noctule {
namespace {

PlacementParts allOf(const Bundle& bundle) {
    PlacementParts parts{std::vector<int>(bundle.cameras.size()), std::vector<int>(bundle.markers.size())};
    std::iota(parts.cameras.begin(), parts.cameras.end(), 0);
    std::iota(parts.markers.begin(), parts.markers.end(), 0);
    return parts;
}

/// Poses as before any fit: all at the origin.
Bundle unplaced(Bundle bundle) {
    std::ranges::fill(bundle.markers, MarkerPose{});
    std::ranges::fill(bundle.cameras, CameraPose{});
    return bundle;
}

/// A square's middle is taken for the mean of its corners: nearer corners count too much, by half a pixel.
TEST(FirstPoses, OfExactCornersAreNearlyExact) {
    for (int placement = 0; placement < 4; ++placement) {
        const Bundle truth = test::knownBundle(4, placement);
        Bundle bundle = unplaced(truth);
        setFirstPoses(bundle, allOf(bundle));
        EXPECT_EQ(std::ranges::count_if(bundle.cameras, &CameraPose::stays), 1);
        EXPECT_TRUE(std::ranges::all_of(bundle.sightings, &Sighting::used));
        EXPECT_LT(test::worstSighting_px(bundle), 1.5);
        EXPECT_LT(test::worstDistance_m(bundle, truth), 1e-3);
    }
}

TEST(FirstPoses, OfCornersWithNoiseAreNearEnoughToBegin) {
    const Bundle truth = test::knownBundle(4);
    Bundle bundle = unplaced(truth);
    std::mt19937 random(2);
    std::normal_distribution<double> error_px(0, 0.3);
    for (Sighting& sighting : bundle.sightings)
        for (Eigen::Vector2d& corner_px : sighting.corners_px)
            corner_px += Eigen::Vector2d{error_px(random), error_px(random)};
    setFirstPoses(bundle, allOf(bundle));
    EXPECT_LT(test::worstDistance_m(bundle, truth), 0.04);
    ASSERT_TRUE(adjust(bundle, {}));
    EXPECT_LT(test::worstDistance_m(bundle, truth), 0.003);
}

TEST(FirstPoses, ACameraThatSharesNoMarkerTakesNoPart) {
    Bundle bundle = test::knownBundle(3);
    // The last photograph shows one marker, which no other shows.
    const int alone = bundle.sightings.back().marker;
    std::erase_if(bundle.sightings,
                  [&](const Sighting& seen) { return (seen.camera == 2) != (seen.marker == alone); });
    bundle = unplaced(bundle);
    setFirstPoses(bundle, allOf(bundle));
    for (const Sighting& sighting : bundle.sightings)
        EXPECT_EQ(sighting.used, sighting.camera != 2);
}

TEST(FirstPoses, AMarkerThatLeansTheWrongWayIsTurned) {
    const Bundle truth = test::knownBundle(4);
    Bundle bundle = truth;
    EXPECT_EQ(turnMistakenMarkers(bundle), 0) << "poses that are right stay";
    // As the first camera might see it: mirrored at the plane across the line of sight.
    MarkerPose& marker = bundle.markers[5];
    const CameraPose& camera = bundle.cameras[0];
    const Vector3d line =
        (camera.q_camera_jig.conjugate() * camera.toCamera(marker.p_jig_marker_m)).normalized();
    const Vector3d normal = marker.q_jig_marker * Vector3d::UnitZ();
    marker.q_jig_marker =
        smallestRotation(normal, 2 * line.dot(normal) * line - normal) * marker.q_jig_marker;
    ASSERT_GT(test::worstSighting_px(bundle), 1);
    EXPECT_EQ(turnMistakenMarkers(bundle), 1);
    EXPECT_LT(test::worstSighting_px(bundle), 0.01);
    EXPECT_LT(angleBetween(bundle.markers[5].q_jig_marker, truth.markers[5].q_jig_marker), 1e-4);
}

}  // namespace
}  // namespace noctule
