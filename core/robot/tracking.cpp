// SPDX-License-Identifier: Apache-2.0
#include "core/robot/tracking.h"

#include <algorithm>
#include <cmath>

namespace noctule::robot {
namespace {

constexpr int kLeastPoints = 10;
constexpr int kSteps = 50;              ///< of the coarse search
constexpr double kFineStep_s = 0.0005;  ///< of the fine one

Vector3d placeAt(const std::vector<PathPoint>& path, double time_s) {
    const auto after = std::ranges::lower_bound(path, time_s, {}, &PathPoint::time_s);
    if (after == path.begin())
        return path.front().p_m;
    if (after == path.end())
        return path.back().p_m;
    const PathPoint& before = *(after - 1);
    const double way_s = after->time_s - before.time_s;
    const double share = way_s > 0 ? (time_s - before.time_s) / way_s : 0;
    return before.p_m + share * (after->p_m - before.p_m);
}

struct Rest {
    double rms_m = 0, max_m = 0;
};

Rest restAt(double delay_s, const std::vector<PathPoint>& commanded, const std::vector<PathPoint>& compared) {
    double sum = 0, largest = 0;
    for (const PathPoint& point : compared) {
        const double square = (point.p_m - placeAt(commanded, point.time_s - delay_s)).squaredNorm();
        sum += square;
        largest = std::max(largest, square);
    }
    return {std::sqrt(sum / static_cast<double>(compared.size())), std::sqrt(largest)};
}

double bestDelay(double from_s, double to_s, double step_s, const std::vector<PathPoint>& commanded,
                 const std::vector<PathPoint>& compared) {
    double best_s = from_s, least_m = restAt(from_s, commanded, compared).rms_m;
    for (double delay_s = from_s + step_s; delay_s <= to_s + step_s / 2; delay_s += step_s)
        if (const double rms_m = restAt(delay_s, commanded, compared).rms_m; rms_m < least_m) {
            least_m = rms_m;
            best_s = delay_s;
        }
    return best_s;
}

bool movesEnough(const std::vector<PathPoint>& path) {
    Eigen::AlignedBox3d box;
    for (const PathPoint& point : path)
        box.extend(point.p_m);
    return !path.empty() && box.diagonal().norm() >= kLeastWay_m;
}

}  // namespace

std::optional<Tracking> trackingOf(const std::vector<PathPoint>& commanded,
                                   const std::vector<PathPoint>& achieved, double longest_delay_s) {
    std::vector<PathPoint> compared;
    for (const PathPoint& point : achieved)
        if (!commanded.empty() && point.time_s >= commanded.front().time_s + longest_delay_s &&
            point.time_s <= commanded.back().time_s)
            compared.push_back(point);
    if (compared.size() < kLeastPoints || !movesEnough(commanded))
        return std::nullopt;
    const double step_s = longest_delay_s / kSteps;
    const double coarse_s = bestDelay(0, longest_delay_s, step_s, commanded, compared);
    const double delay_s =
        bestDelay(std::max(0.0, coarse_s - step_s), std::min(longest_delay_s, coarse_s + step_s), kFineStep_s,
                  commanded, compared);
    const Rest rest = restAt(delay_s, commanded, compared);
    return Tracking{delay_s, restAt(0, commanded, compared).rms_m, rest.rms_m, rest.max_m,
                    static_cast<int>(compared.size())};
}

}  // namespace noctule::robot
