// SPDX-License-Identifier: Apache-2.0
// A square that is known to the last digit, drawn soft: corners from its sides.
#include "core/vision/marker_sides.h"

#include "tests/support/photographed_jig.h"

namespace noctule {
namespace {

using Eigen::Vector2d;

/// A black square on white, turned; light is blurred, levels are bytes. Middles of pixels are whole numbers.
struct SoftSquare {
    std::array<Vector2d, 4> corners_px;  ///< clockwise as seen
    cv::Mat grey;

    SoftSquare(double side_px, double turn_rad, double blur_px, double black = 20, double white = 220) {
        const Vector2d middle(60.3, 59.6);
        const Eigen::Rotation2Dd turn(turn_rad);
        const Vector2d square[] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
        for (size_t k = 0; k < 4; ++k)
            corners_px[k] = middle + side_px * (turn * square[k]);
        cv::Mat light(120, 120, CV_32F);
        constexpr int kRays = 24;
        const double dark = test::lightOf(black), bright = test::lightOf(white);
        const auto outside = [&](double u, double v) {  // px
            return (turn.inverse() * (Vector2d(u, v) - middle)).cwiseAbs().maxCoeff() - side_px / 2;
        };
        for (int v = 0; v < light.rows; ++v)
            for (int u = 0; u < light.cols; ++u) {
                double sum = 0;
                const int rays = std::abs(outside(u, v)) < 1.5 ? kRays : 1;
                for (int i = 0; i < rays * rays; ++i)
                    sum += outside(u - 0.5 + (i % rays + 0.5) / rays, v - 0.5 + (i / rays + 0.5) / rays) < 0
                               ? dark
                               : bright;
                light.at<float>(v, u) = float(sum / (rays * rays));
            }
        cv::GaussianBlur(light, light, {0, 0}, blur_px);
        light.forEach<float>([](float& value, const int*) { value = float(test::levelOf(value)); });
        light.convertTo(grey, CV_8U);
    }

    /// Begun about a pixel off.
    std::optional<std::array<cv::Point2d, 4>> find() const {
        std::array<cv::Point2d, 4> about;
        const Vector2d off[] = {{0.7, -0.4}, {-0.5, 0.6}, {0.3, 0.8}, {-0.6, -0.6}};
        for (size_t k = 0; k < 4; ++k)
            about[k] = {corners_px[k].x() + off[k].x(), corners_px[k].y() + off[k].y()};
        return cornersFromSides(grey, about);
    }

    double worst_px(const std::array<cv::Point2d, 4>& found) const {
        double worst = 0;
        for (size_t k = 0; k < 4; ++k)
            worst = std::max(worst, (Vector2d(found[k].x, found[k].y) - corners_px[k]).norm());
        return worst;
    }
};

TEST(MarkerSides, MeetAtTheCornersHoweverSoftThePictureIs) {
    for (const double turn_rad : {0.0, 0.1, 0.5, 2.2})
        for (const double blur_px : {0.6, 1.2}) {
            const SoftSquare square(60, turn_rad, blur_px);
            const auto found = square.find();
            ASSERT_TRUE(found) << turn_rad << ", " << blur_px;
            EXPECT_LT(square.worst_px(*found), 0.03) << turn_rad << ", " << blur_px;
        }
}

TEST(MarkerSides, WithoutAnEdgeThereAreNone) {
    EXPECT_FALSE(SoftSquare(60, 0.3, 0.8, 120, 124).find()) << "hardly any contrast";
    SoftSquare square(60, 0.3, 0.8);
    // Something white lies over most of one side.
    const Vector2d middle = (square.corners_px[0] + square.corners_px[1]) / 2;
    cv::circle(square.grey, {int(middle.x()), int(middle.y())}, 24, cv::Scalar(220), cv::FILLED);
    EXPECT_FALSE(square.find());
    EXPECT_FALSE(cornersFromSides(square.grey, {})) << "no square at all";
}

}  // namespace
}  // namespace noctule
