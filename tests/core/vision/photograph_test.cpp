// SPDX-License-Identifier: Apache-2.0
// Real picture files: corners to a fraction of a pixel, distances below a millimetre, damage without harm.
#include "core/vision/photograph.h"

#include "tests/core/vision/test_jig.h"
#include "tests/support/files.h"

namespace noctule {
namespace {

using namespace test;

struct CornerErrors {
    int markers = 0, wrong = 0;  ///< found, of them not there
    double rms_px = 0, mean_px = 0;
};

CornerErrors cornerErrors(const Photograph& photograph, const TestCamera& camera,
                          const std::vector<StuckMarker>& stuck) {
    std::mt19937 random;
    const Photograph truth = seenCorners(camera, stuck, 0, random, "");
    CornerErrors errors;
    double sum_px2 = 0;
    Eigen::Vector2d sum_px = Eigen::Vector2d::Zero();
    for (const SeenMarker& seen : photograph.markers) {
        const auto right = std::ranges::find(truth.markers, seen.number, &SeenMarker::number);
        ++errors.markers;
        if (right == truth.markers.end() || (right->corners_px[0] - seen.corners_px[0]).norm() > 5) {
            ++errors.wrong;
            continue;
        }
        for (size_t k = 0; k < 4; ++k) {
            sum_px2 += (seen.corners_px[k] - right->corners_px[k]).squaredNorm() / 2;
            sum_px += seen.corners_px[k] - right->corners_px[k];
        }
    }
    errors.rms_px = std::sqrt(sum_px2 / std::max(1, 4 * errors.markers));
    errors.mean_px = sum_px.norm() / std::max(1, 4 * errors.markers);
    return errors;
}

TEST(Photograph, CornersAreFoundToAFractionOfAPixel) {
    const auto stuck = stickMarkers(defaultSuit(), 0);
    for (const double hole_share : {0.0, 0.125}) {
        const TestCamera camera = cameraOf(0, 0);
        PhotographLook look;
        look.hole_share = hole_share;
        const Photograph photograph = findMarkers(takePhotograph(camera, stuck, look, 1), "1_1.jpg").value();
        EXPECT_EQ(photograph.width_px, 2592);
        const CornerErrors errors = cornerErrors(photograph, camera, stuck);
        std::printf("corners of %d markers: rms %.3f px, mean %.3f px\n", errors.markers, errors.rms_px,
                    errors.mean_px);
        EXPECT_GE(errors.markers, 25) << "hole " << hole_share;
        EXPECT_EQ(errors.wrong, 0);
        EXPECT_LT(errors.rms_px, 0.1);
        EXPECT_LT(errors.mean_px, 0.02) << "pixels counted from their middles";
    }
}

/// From picture files to distances.
JigErrors measured(int placements, int each, const TestCamera& lens, const PhotographLook& look) {
    const Suit suit = defaultSuit();
    std::vector<std::vector<StuckMarker>> stuck;
    std::vector<PlacedPhotograph> photographs;
    for (int p = 0; p < placements; ++p) {
        stuck.push_back(stickMarkers(suit, p));
        for (int k = 0; k < each; ++k) {
            const std::string name = std::to_string(p + 1) + "_" + std::to_string(k) + ".jpg";
            auto photograph = findMarkers(
                takePhotograph(cameraOf(p, k, lens), stuck.back(), look, uint32_t(10 * p + k)), name);
            photographs.push_back({std::to_string(p + 1), std::move(*photograph)});
        }
    }
    const PhotographedDistances found = measurePhotographs(photographs, suit, {}, {}).value();
    const JigErrors errors = compare(found, suit, stuck);
    std::printf(
        "%d placements of %d photographs, k1 %.2f, blur %.1f px, noise %.0f: corners %.3f px, focal "
        "length %.1f px, edges %.3f px, %d distances, rms %.3f mm, worst %.3f mm, chi square %.2f\n",
        placements, each, lens.k1, look.blur_px, look.noise_levels, found.corner_sigma_px,
        found.lenses.at(0).focal_px, found.lenses.at(0).edge_px, errors.distances, 1e3 * errors.rms_m,
        1e3 * errors.worst_m, errors.chi_square);
    EXPECT_EQ(gradeOf(found.known.findings), Grade::kGood) << all(found.known.findings);
    return errors;
}

TEST(Photograph, DistancesOnTheJigAreRightToATenthOfAMillimetre) {
    const JigErrors errors = measured(2, 4, {}, {});
    EXPECT_EQ(errors.distances, 2 * 18 * 8);
    EXPECT_LT(errors.rms_m, 1e-4);
    EXPECT_LT(errors.worst_m, 3e-4);
    // One draw, in which all distances share the error of the scale: it may be any small number.
    // SigmasAreHonestOverManyRuns judges the mean.
    EXPECT_LT(errors.chi_square, 3);
}

TEST(Photograph, ALensThatBendsAndANoisySoftPictureStayBelowAMillimetre) {
    TestCamera lens;
    lens.k1 = -0.1;
    lens.k2 = 0.04;
    PhotographLook look;
    look.blur_px = 1.5;
    look.noise_levels = 8;
    look.jpeg_quality = 75;
    const JigErrors errors = measured(1, 4, lens, look);
    EXPECT_EQ(errors.distances, 18 * 8);
    EXPECT_LT(errors.rms_m, 1e-3);
}

TEST(Photograph, ACameraWithTonesOfItsOwnDoesNotStretchTheJig) {
    PhotographLook look;
    look.tone = 1.4;
    const JigErrors errors = measured(1, 4, {}, look);
    EXPECT_EQ(errors.distances, 18 * 8);
    EXPECT_LT(errors.rms_m, 1e-3);
    EXPECT_LT(errors.chi_square, 3);
}

TEST(Photograph, DamagedFilesAreNamedAndDoNoHarm) {
    TestCamera small;
    small.width_px = 640;
    small.height_px = 480;
    small.focal_px = 480;
    small.center_px = {320, 240};
    small.look({0, 0, 0.4}, {0, 0, 0}, 0);
    const std::string jpeg = takePhotograph(small, {{7, Vector3d::Zero(), Matrix3d::Identity(), 0.1}}, {}, 1);
    ASSERT_EQ(findMarkers(jpeg, "1_1.jpg").value().markers.size(), 1U);
    cv::Mat picture = cv::imdecode(std::vector<uchar>(jpeg.begin(), jpeg.end()), cv::IMREAD_COLOR);
    std::vector<uchar> buffer;
    cv::imencode(".png", picture, buffer);
    const std::string png(buffer.begin(), buffer.end());
    EXPECT_EQ(findMarkers(png, "1_1.png").value().markers.size(), 1U);
    const auto expectNamed = [](const std::string& bytes, const std::string& what) {
        const auto damaged = findMarkers(bytes, "jig/1_1.jpg");
        ASSERT_FALSE(damaged) << what;
        EXPECT_EQ(damaged.error().kind, ErrorKind::kUnreadable);
        EXPECT_NE(damaged.error().message.find("jig/1_1.jpg"), std::string::npos);
        EXPECT_FALSE(damaged.error().remedy.empty());
    };
    for (const double share : {0.0, 0.001, 0.01, 0.1, 0.5, 0.9, 0.99})
        for (const std::string* file : {&jpeg, &png})
            expectNamed(file->substr(0, size_t(share * double(file->size()))), std::to_string(share));
    expectNamed("this is no picture", "words");
    std::mt19937 random(5);
    std::string noise(5000, 0);
    for (char& byte : noise)
        byte = char(random());
    expectNamed(noise, "noise");
    // Bytes changed in the middle may still be a picture; they must not be more than that.
    for (int trial = 0; trial < 60; ++trial) {
        std::string flipped = trial % 2 ? jpeg : png;
        for (int i = 0; i < 1 + trial / 6; ++i)
            flipped[random() % flipped.size()] = char(random());
        const auto result = findMarkers(flipped, "flipped");
        EXPECT_TRUE(result || result.error().kind == ErrorKind::kUnreadable);
    }
}

TEST(Photograph, APictureOfAFewPixelsHasNoMarkers) {
    for (const int size : {1, 2, 5, 20}) {
        std::vector<uchar> bytes;
        cv::imencode(".png", cv::Mat(size, size, CV_8U, cv::Scalar(9)), bytes);
        const auto result = findMarkers({bytes.begin(), bytes.end()}, "dot.png");
        EXPECT_TRUE(result ? result->markers.empty() : result.error().kind == ErrorKind::kUnreadable);
    }
}

TEST(Photograph, FilesAreReadInOrderAndAMissingOneIsNamed) {
    const Folder folder;
    std::vector<uchar> bytes;
    cv::imencode(".jpg", cv::Mat(100, 120, CV_8U, cv::Scalar(9)), bytes);
    writeBytes(folder.file("1_a.jpg"), {bytes.begin(), bytes.end()});
    EXPECT_EQ(readPhotographs({folder.file("1_a.jpg")}, {}).value().at(0).width_px, 120);
    const auto missing = readPhotographs({folder.file("1_a.jpg"), folder.file("1_b.jpg")}, {});
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().message.find("1_b.jpg"), std::string::npos);
}

TEST(Photograph, ThePlacementIsTheLongestLabelThatTheNameBeginsWith) {
    const std::vector<std::string> labels{"1", "1_low", "left"};
    EXPECT_EQ(placementOf("a_b/1_IMG_0034.jpg", labels).value(), "1");
    EXPECT_EQ(placementOf("1_low_2.jpg", labels).value(), "1_low");
    EXPECT_EQ(placementOf("/x/left_.png", labels).value(), "left");
    for (const char* name : {"IMG_0034.jpg", "10_1.jpg", "left.jpg", "left/5_1.jpg", ""}) {
        const auto refused = placementOf(name, labels);
        ASSERT_FALSE(refused) << name;
        EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
        EXPECT_NE(refused.error().message.find("1, 1_low, left"), std::string::npos);
        EXPECT_NE(refused.error().remedy.find("PLACEMENT_"), std::string::npos);
    }
}

}  // namespace
}  // namespace noctule
