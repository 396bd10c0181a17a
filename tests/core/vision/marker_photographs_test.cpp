// SPDX-License-Identifier: Apache-2.0
// From corners to distances, without pictures: exact, honest about its errors, and everything that can be
// wrong with the photographs by name.
#include "tests/core/vision/test_jig.h"

namespace noctule {
namespace {

using namespace test;

class MarkerPhotographs : public ::testing::Test {
protected:
    /// `placements` placements, `each` photographs of every one.
    void takeCorners(int placements, int each, double sigma_px, unsigned seed = 1,
                     const TestCamera& lens = {}) {
        std::mt19937 random(seed);
        stuck_.clear();
        photographs_.clear();
        for (int p = 0; p < placements; ++p) {
            stuck_.push_back(stickMarkers(suit_, p));
            for (int k = 0; k < each; ++k) {
                const std::string label = std::to_string(p + 1);
                photographs_.push_back(
                    {label, seenCorners(cameraOf(p, k, lens), stuck_.back(), sigma_px, random,
                                        label + "_" + std::to_string(k + 1) + ".jpg")});
            }
        }
    }
    PhotographedDistances measure() const { return measurePhotographs(photographs_, suit_, {}, {}).value(); }
    JigErrors errors(const PhotographedDistances& found) const { return compare(found, suit_, stuck_); }
    /// In one photograph.
    void forget(size_t photograph, int number) {
        std::erase_if(photographs_[photograph].photograph.markers,
                      [&](const SeenMarker& seen) { return seen.number == number; });
    }
    std::vector<std::string> partsFound(const PhotographedDistances& found) const {
        std::set<std::string> ids;
        for (const KnownDistance& known : found.known.distances)
            ids.insert({known.source, known.board});
        return {ids.begin(), ids.end()};
    }

    Suit suit_ = defaultSuit();
    std::vector<std::vector<StuckMarker>> stuck_;
    std::vector<PlacedPhotograph> photographs_;
};

TEST_F(MarkerPhotographs, ExactCornersGiveExactDistancesAndTheLens) {
    TestCamera lens;
    lens.k1 = -0.08;
    lens.k2 = 0.03;
    takeCorners(2, 4, 0, 1, lens);
    const PhotographedDistances found = measure();
    EXPECT_TRUE(found.known.findings.empty()) << all(found.known.findings);
    EXPECT_EQ(found.known.distances.size(), 2U * 18 * 8);
    const JigErrors wrong = errors(found);
    // The beliefs about the lens pull a little.
    EXPECT_LT(wrong.worst_m, 2e-5);
    ASSERT_EQ(found.lenses.size(), 1U);
    EXPECT_NEAR(found.lenses[0].focal_px, lens.focal_px, 1);
    EXPECT_NEAR(found.lenses[0].k1, lens.k1, 1e-3);
}

TEST_F(MarkerPhotographs, SigmasAreHonestOverManyRuns) {
    double chi_square = 0, rms_m2 = 0;
    const int runs = 120;
    for (int run = 0; run < runs; ++run) {
        takeCorners(2, 3, 0.1, 10 + unsigned(run));
        const PhotographedDistances found = measure();
        EXPECT_NEAR(found.corner_sigma_px, 0.1, 0.01);
        const JigErrors wrong = errors(found);
        chi_square += wrong.chi_square / runs;
        rms_m2 += wrong.rms_m * wrong.rms_m / runs;
        for (size_t i = 0; i < found.known.distances.size(); ++i)
            EXPECT_GE(found.known.distances[i].sigma_m, std::hypot(found.fit_sigma_m[i], 4.2e-4));
    }
    RecordProperty("chi_square", std::to_string(chi_square));
    std::printf("3 photographs, 0.1 px: rms %.3f mm, chi square %.3f per distance\n", 1e3 * std::sqrt(rms_m2),
                chi_square);
    EXPECT_GT(chi_square, 0.75);
    EXPECT_LT(chi_square, 1.3);
    EXPECT_LT(std::sqrt(rms_m2), 1e-3);
}

TEST_F(MarkerPhotographs, AnyFocalLengthIsFound) {
    for (const double focal_px : {1300.0, 2000.0, 3200.0, 5200.0}) {
        TestCamera lens;
        lens.focal_px = focal_px;
        takeCorners(1, 5, 0, 1, lens);
        for (PlacedPhotograph& photograph : photographs_)
            photograph.photograph.markers.clear();
        std::mt19937 random(3);
        for (int k = 0; k < 5; ++k) {  // a longer lens from farther away
            TestCamera camera = cameraOf(0, k, lens);
            camera.p_m = kJigMiddle + (camera.p_m - kJigMiddle) * focal_px / 2000;
            photographs_[size_t(k)].photograph = seenCorners(camera, stuck_[0], 0.1, random, "1_x.jpg");
        }
        const PhotographedDistances found = measure();
        EXPECT_LT(errors(found).rms_m, 1.5e-3) << focal_px << " px";
        EXPECT_EQ(errors(found).distances, 18 * 8) << focal_px << " px\n" << all(found.known.findings);
        EXPECT_NEAR(found.lenses.at(0).focal_px / focal_px, 1, 0.02);
    }
}

TEST_F(MarkerPhotographs, TwoCamerasOfDifferentSizeServeOnePlacement) {
    takeCorners(1, 3, 0.1);
    TestCamera small;
    small.width_px = 1600;
    small.height_px = 1200;
    small.focal_px = 1350;
    small.center_px = {795, 604};
    std::mt19937 random(4);
    for (int k = 3; k < 6; ++k)
        photographs_.push_back({"1", seenCorners(cameraOf(0, k, small), stuck_[0], 0.1, random, "1_s.jpg")});
    const PhotographedDistances found = measure();
    EXPECT_EQ(found.lenses.size(), 2U);
    EXPECT_LT(errors(found).rms_m, 2e-3);
    EXPECT_EQ(errors(found).distances, 18 * 8);
}

TEST_F(MarkerPhotographs, PhotographsAreTiedTogetherThroughOthers) {
    takeCorners(1, 5, 0.1);
    // The first shows boards only, the second sources only; the others tie them.
    for (int number = 0; number < 50; ++number)
        forget(number < kFirstBoardMarker ? 0 : 1, number);
    const PhotographedDistances found = measure();
    EXPECT_TRUE(found.known.findings.empty()) << all(found.known.findings);
    EXPECT_EQ(errors(found).distances, 18 * 8);
    EXPECT_LT(errors(found).rms_m, 1e-3);
}

TEST_F(MarkerPhotographs, MissingMarkersAreNamed) {
    takeCorners(2, 3, 0.1);
    for (size_t k = 0; k < 6; ++k)
        forget(k, kFirstSourceMarker + 2);  // nowhere
    for (size_t k = 0; k < 5; ++k)
        if (k != 1)
            forget(k, kFirstBoardMarker + 6);  // once in either
    for (size_t k = 0; k < 6; ++k)
        forget(k, kOriginMarker);
    const PhotographedDistances found = measure();
    EXPECT_TRUE(says(found.known.findings,
                     {"Source 3, " + suit_.sources[2].id, "marker 2", "no photograph", "1 and 2"}))
        << all(found.known.findings);
    EXPECT_TRUE(
        says(found.known.findings, {"Board 7, " + suit_.boards[6].id, "marker 16", "one photograph only"}))
        << all(found.known.findings);
    EXPECT_EQ(found.known.findings.size(), 2U) << all(found.known.findings);
    EXPECT_EQ(partsFound(found).size(), 24U);
    EXPECT_LT(errors(found).rms_m, 1e-3);
}

TEST_F(MarkerPhotographs, APlacementWithOnePhotographIsNamedAndTheOthersServe) {
    takeCorners(2, 3, 0.1);
    photographs_.resize(4);
    const PhotographedDistances found = measure();
    EXPECT_TRUE(says(found.known.findings, {"Placement 2", "only one photograph", "2_1.jpg"}));
    EXPECT_EQ(errors(found).distances, 18 * 8);
    photographs_.resize(1);
    const PhotographedDistances nothing = measure();
    EXPECT_TRUE(nothing.known.distances.empty());
    EXPECT_TRUE(says(nothing.known.findings, {"two photographs"}, Grade::kNotUsable));
}

TEST_F(MarkerPhotographs, ADoubleMarkerIsNamedAndNotUsed) {
    takeCorners(2, 3, 0.1);
    auto& markers = photographs_[1].photograph.markers;
    const auto source =
        std::ranges::find_if(markers, [](const SeenMarker& marker) { return marker.number < 8; });
    ASSERT_NE(source, markers.end());
    SeenMarker copy = *source;
    for (auto& corner : copy.corners_px)
        corner += Eigen::Vector2d(200, 50);
    markers.push_back(copy);
    const PhotographedDistances found = measure();
    EXPECT_TRUE(says(found.known.findings,
                     {"Source " + std::to_string(copy.number + 1), "marker " + std::to_string(copy.number),
                      "twice", "1_2.jpg", "placement 1"}));
    EXPECT_EQ(errors(found).distances, 18 * 8 + 18 * 7);
    EXPECT_LT(errors(found).rms_m, 1e-3);
}

TEST_F(MarkerPhotographs, AMarkerThatHasMovedIsNamedAndDoesNotHarmTheOthers) {
    takeCorners(1, 5, 0.1);
    std::vector<StuckMarker> moved = stuck_[0];
    std::ranges::find(moved, kFirstBoardMarker + 4, &StuckMarker::number)->p_m += Vector3d(0.015, 0.01, 0);
    std::mt19937 random(9);
    photographs_[3].photograph = seenCorners(cameraOf(0, 3), moved, 0.1, random, "1_4.jpg");
    const PhotographedDistances found = measure();
    EXPECT_TRUE(says(found.known.findings,
                     {"Board 5, " + suit_.boards[4].id, "marker 14", "does not lie", "1_4.jpg"}))
        << all(found.known.findings);
    EXPECT_EQ(found.known.findings.size(), 1U) << all(found.known.findings);
    EXPECT_LT(errors(found).rms_m, 1e-3);
}

TEST_F(MarkerPhotographs, AMarkerOfAnotherSizeIsNamed) {
    takeCorners(1, 5, 0.1);
    std::mt19937 random(9);
    std::ranges::find(stuck_[0], 5, &StuckMarker::number)->side_m = 0.05;
    for (int k = 0; k < 5; ++k)
        photographs_[size_t(k)].photograph =
            seenCorners(cameraOf(0, k), stuck_[0], 0.1, random, "1_" + std::to_string(k + 1) + ".jpg");
    const PhotographedDistances found = measure();
    EXPECT_TRUE(says(found.known.findings, {"Source 6", "marker 5", "does not lie"}))
        << all(found.known.findings);
    EXPECT_LT(errors(found).rms_m, 2e-3);
}

TEST_F(MarkerPhotographs, ABlurredPhotographIsNamed) {
    takeCorners(1, 5, 0.1);
    std::mt19937 random(9);
    photographs_[2].photograph = seenCorners(cameraOf(0, 2), stuck_[0], 2.0, random, "1_3.jpg");
    const PhotographedDistances found = measure();
    EXPECT_TRUE(says(found.known.findings, {"1_3.jpg"})) << all(found.known.findings);
    EXPECT_LT(errors(found).rms_m, 1e-3);
}

TEST_F(MarkerPhotographs, PhotographsThatDoNotFitAreRefused) {
    takeCorners(1, 4, 8);
    const PhotographedDistances found = measure();
    EXPECT_TRUE(says(found.known.findings, {"do not fit together", "px"}, Grade::kNotUsable))
        << all(found.known.findings);
}

TEST_F(MarkerPhotographs, PhotographsOfSomethingElseAreNotTied) {
    takeCorners(1, 5, 0.1);
    for (int number = 0; number < 50; ++number)
        if (number != 20 && number != 21)
            forget(4, number);
    for (size_t k = 0; k < 4; ++k) {
        forget(k, 20);
        forget(k, 21);
    }
    photographs_.push_back(photographs_[4]);
    photographs_.back().photograph.name = "1_6.jpg";
    const PhotographedDistances found = measure();
    EXPECT_TRUE(says(found.known.findings, {"1_5.jpg", "ties it"})) << all(found.known.findings);
    EXPECT_TRUE(says(found.known.findings, {"1_6.jpg", "ties it"}));
    EXPECT_EQ(errors(found).distances, 16 * 8);
    EXPECT_LT(errors(found).rms_m, 1e-3);
}

TEST_F(MarkerPhotographs, StrangersAndEmptyPhotographsAreNamed) {
    takeCorners(1, 4, 0.1);
    photographs_.push_back({"1", {"1_dark.jpg", 2592, 1944, {}}});
    for (const size_t k : {0, 1}) {
        SeenMarker stranger = photographs_[k].photograph.markers.front();
        stranger.number = 40;
        photographs_[k].photograph.markers.push_back(stranger);
    }
    const PhotographedDistances found = measure();
    EXPECT_TRUE(says(found.known.findings, {"1_dark.jpg", "no marker", "found"}) ||
                says(found.known.findings, {"1_dark.jpg", "No marker"}))
        << all(found.known.findings);
    EXPECT_TRUE(says(found.known.findings, {"arker 40", "no part"})) << all(found.known.findings);
    EXPECT_EQ(errors(found).distances, 18 * 8);
}

TEST_F(MarkerPhotographs, ASuitWithMorePartsThanMarkersIsRefused) {
    Suit suit = suit_;
    while (suit.sources.size() < 11)
        suit.sources.push_back(suit.sources.front());
    const auto refused = measurePhotographs({}, suit, {}, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(refused.error().message.find("11 sources"), std::string::npos);
}

TEST_F(MarkerPhotographs, CanBeCancelled) {
    takeCorners(1, 3, 0.1);
    CancelFlag flag;
    flag.cancel();
    const auto cancelled = measurePhotographs(photographs_, suit_, {}, {nullptr, &flag});
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().kind, ErrorKind::kCancelled);
}

}  // namespace
}  // namespace noctule
