// SPDX-License-Identifier: Apache-2.0
#include "core/vision/marker_sides.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/linear_solvers.h"
#include "core/math/order_statistics.h"
#include "core/vision/marker_cells.h"

namespace noctule {
namespace {

using Eigen::Vector2d;

constexpr int kRounds = 4;
constexpr double kFromCorner = 0.15;  ///< share of a side near a corner, where blur bends it
/// Profiles reach so many cells to either side, where the black border and the white margin are one wide.
constexpr double kReachCells = 0.6, kLeastReach_px = 1.5, kMostReach_px = 8;
constexpr double kProfileStep_px = 0.25;
constexpr double kLeastContrast = 0.04;  ///< of full light
constexpr double kLeastShareOfSide = 0.6, kOutlierSpreads = 3;
constexpr double kStraight_px = 0.8, kMostMoved_px = 3;

const std::array<double, 256>& lightOfLevel() {
    static const std::array<double, 256> light = [] {
        std::array<double, 256> table{};
        for (size_t level = 0; level < table.size(); ++level) {
            const double v = double(level) / 255;
            table[level] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        }
        return table;
    }();
    return light;
}

/// Between pixels; black beside the picture.
double lightAt(const cv::Mat& grey, const Vector2d& at) {
    const bool is_inside = at.x() >= 0 && at.y() >= 0 && at.x() < grey.cols - 1 && at.y() < grey.rows - 1;
    if (!is_inside)  // nor where sides without a length point
        return 0;
    const int x = int(at.x()), y = int(at.y());
    const auto& light = lightOfLevel();
    const double fx = at.x() - x, fy = at.y() - y;
    const auto row = [&](int v) {
        const uchar* levels = grey.ptr<uchar>(v);
        return (1 - fx) * light[levels[x]] + fx * light[levels[x + 1]];
    };
    return (1 - fy) * row(y) + fy * row(y + 1);
}

/// How far outside `at` the edge lies: as if all the light beyond it had come from a sharp one.
std::optional<double> edgeBeyond(const cv::Mat& grey, const Vector2d& at, const Vector2d& outwards,
                                 double reach_px) {
    const int half = std::max(4, int(reach_px / kProfileStep_px));
    const int ends = std::max(1, half / 3);
    double sum = 0, dark = 0, bright = 0;
    for (int i = -half; i <= half; ++i) {
        const double light = lightAt(grey, at + outwards * (i * kProfileStep_px));
        sum += light * (i == -half || i == half ? 0.5 : 1);
        if (i < -half + ends)
            dark += light / ends;
        if (i > half - ends)
            bright += light / ends;
    }
    if (bright - dark < kLeastContrast)
        return {};
    return (half - (sum - 2 * half * dark) / (bright - dark)) * kProfileStep_px;
}

struct EdgeLine {
    Vector2d point, along;
};

std::optional<EdgeLine> lineThrough(std::vector<Vector2d> points, size_t least) {
    EdgeLine line;
    for (const bool last : {false, true}) {
        if (points.size() < std::max<size_t>(4, least))
            return {};
        line.point = Vector2d::Zero();
        for (const Vector2d& point : points)
            line.point += point / double(points.size());
        Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
        for (const Vector2d& point : points)
            scatter += (point - line.point) * (point - line.point).transpose();
        line.along = eigensystemOf(scatter).vectors.col(1);
        const auto beside = [&](const Vector2d& point) {
            const Vector2d from = point - line.point;
            return std::abs(from.x() * line.along.y() - from.y() * line.along.x());
        };
        std::vector<double> distances;
        for (const Vector2d& point : points)
            distances.push_back(beside(point));
        const double spread = 1.4826 * medianOf(std::move(distances));
        if (last && spread > kStraight_px)
            return {};
        std::erase_if(points, [&](const Vector2d& point) {
            return beside(point) > std::max(0.05, kOutlierSpreads * spread);
        });
    }
    return line;
}

std::optional<EdgeLine> sideOf(const cv::Mat& grey, const Vector2d& from, const Vector2d& to,
                               double cell_px) {
    const double length = (to - from).norm();
    const Vector2d along = (to - from) / length, outwards(along.y(), -along.x());
    const double reach_px = std::clamp(kReachCells * cell_px, kLeastReach_px, kMostReach_px);
    const int count = std::clamp(int(length * (1 - 2 * kFromCorner)), 8, 200);
    std::vector<Vector2d> edge;
    for (int i = 0; i < count; ++i) {
        const Vector2d at = from + along * length * (kFromCorner + (1 - 2 * kFromCorner) * (i + 0.5) / count);
        if (const auto beyond = edgeBeyond(grey, at, outwards, reach_px);
            beyond && std::abs(*beyond) < reach_px)
            edge.push_back(at + outwards * *beyond);
    }
    return lineThrough(std::move(edge), size_t(kLeastShareOfSide * count));
}

std::optional<Vector2d> meeting(const EdgeLine& a, const EdgeLine& b) {
    Eigen::Matrix2d sides;
    sides << a.along, -b.along;
    if (std::abs(sides.determinant()) < 0.05)
        return {};
    return a.point + a.along * (sides.inverse() * (b.point - a.point)).x();
}

/// Of the narrowest direction across the four corners.
double cellSize_px(const std::array<Vector2d, 4>& corners) {
    const Vector2d d = corners[2] - corners[0], e = corners[3] - corners[1];
    double longest = 0;
    for (size_t k = 0; k < 4; ++k)
        longest = std::max(longest, (corners[k] - corners[(k + 1) % 4]).norm());
    return 0.5 * std::abs(d.x() * e.y() - d.y() * e.x()) / std::max(1.0, longest) / kMarkerCells;
}

}  // namespace

std::optional<std::array<cv::Point2d, 4>> cornersFromSides(const cv::Mat& grey,
                                                           const std::array<cv::Point2d, 4>& corners) {
    std::array<Vector2d, 4> at;
    for (size_t k = 0; k < 4; ++k)
        at[k] = {corners[k].x, corners[k].y};
    const std::array<Vector2d, 4> first = at;
    const double cell_px = cellSize_px(at);
    for (int round = 0; round < kRounds; ++round) {
        std::array<std::optional<EdgeLine>, 4> sides;
        for (size_t k = 0; k < 4; ++k)
            if (sides[k] = sideOf(grey, at[k], at[(k + 1) % 4], cell_px); !sides[k])
                return {};
        for (size_t k = 0; k < 4; ++k) {
            const auto corner = meeting(*sides[(k + 3) % 4], *sides[k]);
            if (!corner || (*corner - first[k]).norm() > std::max(kMostMoved_px, cell_px / 2))
                return {};
            at[k] = *corner;
        }
    }
    std::array<cv::Point2d, 4> refined;
    for (size_t k = 0; k < 4; ++k)
        refined[k] = {at[k].x(), at[k].y()};
    return refined;
}

}  // namespace noctule
