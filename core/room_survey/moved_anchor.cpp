// SPDX-License-Identifier: Apache-2.0
#include "core/room_survey/moved_anchor.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "core/math/linear_solvers.h"
#include "core/math/order_statistics.h"

namespace noctule::room_survey {
namespace {

constexpr int kSplits = 16;
constexpr size_t kFewestPulls = 30;  ///< before and after
constexpr double kDetour_s = 0.5;    ///< flesh errs alike for so long

/// A range of one anchor: by how much it is too long, and the direction in which it would get longer.
struct Pull {
    double time_s, residual_m;
    Vector3d direction;
    int device = 0;
};

struct Shift {
    Vector3d by_m = Vector3d::Zero();
    Matrix3d covariance_m2 = Matrix3d::Zero();
    double cost = 0;
};

/// The place's shift that explains them, from a wide to a narrow loss.
Shift shiftOf(std::span<const Pull> pulls, double sigma_m) {
    Shift shift;
    std::set<int> devices;
    for (const Pull& pull : pulls)
        devices.insert(pull.device);
    const double pairs_s = (pulls.back().time_s - pulls.front().time_s) * static_cast<double>(devices.size());
    const double copies =
        std::max(1.0, static_cast<double>(pulls.size()) * kDetour_s / std::max(kDetour_s, pairs_s));
    for (const double scale_m : {0.3, 0.1, 0.05, 3 * sigma_m, 3 * sigma_m})
        for (int step = 0; step < 4; ++step) {
            Matrix3d A = 1e-3 * Matrix3d::Identity();
            Vector3d g = Vector3d::Zero();
            shift.cost = 0;
            for (const Pull& pull : pulls) {
                const double r = pull.residual_m - pull.direction.dot(shift.by_m);
                const double w = 1 / (1 + r * r / (scale_m * scale_m));
                A += w * pull.direction * pull.direction.transpose();
                g += w * r * pull.direction;
                shift.cost += std::log1p(r * r / (scale_m * scale_m));
            }
            shift.by_m += solveSymmetric(A, g);
            shift.covariance_m2 = sigma_m * sigma_m * copies * A.inverse();
        }
    return shift;
}

/// How many of the ranges a shift of the place explains.
double explainedBy(std::span<const Pull> pulls, const Vector3d& by_m, double sigma_m) {
    double count = 0;
    for (const Pull& pull : pulls)
        count += std::abs(pull.residual_m - pull.direction.dot(by_m)) < 3 * sigma_m;
    return count;
}

std::optional<AnchorMove> moveOf(int anchor, const std::vector<Pull>& pulls, double sigma_m) {
    if (pulls.size() < 2 * kFewestPulls)
        return std::nullopt;
    std::optional<AnchorMove> best;
    double least = 0;
    const double by_one = explainedBy(pulls, shiftOf(pulls, sigma_m).by_m, sigma_m);
    for (int k = 1; k < kSplits; ++k) {
        const size_t at = pulls.size() * static_cast<size_t>(k) / kSplits;
        if (at < kFewestPulls || pulls.size() - at < kFewestPulls)
            continue;
        const Shift before = shiftOf(std::span(pulls).first(at), sigma_m),
                    after = shiftOf(std::span(pulls).subspan(at), sigma_m);
        if (best && before.cost + after.cost >= least)
            continue;
        least = before.cost + after.cost;
        const Vector3d by_m = after.by_m - before.by_m;
        const Vector3d along = by_m / std::max(by_m.norm(), 1e-9);
        best = AnchorMove{anchor, pulls[at].time_s, by_m.norm(),
                          std::sqrt(along.dot((before.covariance_m2 + after.covariance_m2) * along)),
                          (explainedBy(std::span(pulls).first(at), before.by_m, sigma_m) +
                           explainedBy(std::span(pulls).subspan(at), after.by_m, sigma_m) - by_one) /
                              static_cast<double>(pulls.size())};
    }
    return best;
}

/// Of a pair that hears itself: by how much its distance steps.
std::optional<AnchorMove> stepOf(const std::vector<Pull>& pulls) {
    std::vector<double> values;
    std::optional<AnchorMove> best;
    for (const Pull& pull : pulls)
        values.push_back(pull.residual_m);
    for (int k = 1; k < kSplits; ++k) {
        const auto at = std::ssize(values) * k / kSplits;
        if (at < 5 || std::ssize(values) - at < 5)
            continue;
        const std::vector<double> before(values.begin(), values.begin() + at),
            after(values.begin() + at, values.end());
        const double step_m = medianOf(after) - medianOf(before);
        const double sigma_m =
            std::hypot(spreadAbout(medianOf(before), before), spreadAbout(medianOf(after), after)) /
            std::sqrt(static_cast<double>(std::min(before.size(), after.size())));
        if (!best || std::abs(step_m) > best->distance_m)
            best = AnchorMove{0, pulls[static_cast<size_t>(at)].time_s, std::abs(step_m), sigma_m, 1};
    }
    return best && best->isPlain() ? best : std::nullopt;
}

/// The anchor of which most distances to others step.
std::optional<AnchorMove> moveBetween(const Evidence& evidence) {
    std::map<std::pair<int, int>, std::vector<Pull>> pairs;
    for (const AnchorRange& range : evidence.between)
        pairs[std::minmax(range.from, range.to)].push_back(
            {range.time_s, range.distance_m, Vector3d::Zero(), 0});
    std::map<int, std::pair<int, AnchorMove>> steps;
    for (auto& [pair, pulls] : pairs) {
        std::ranges::stable_sort(pulls, {}, &Pull::time_s);
        if (const auto step = stepOf(pulls))
            for (const int anchor : {pair.first, pair.second}) {
                auto& [count, move] = steps[anchor];
                ++count;
                if (step->distance_m > move.distance_m)
                    move = *step, move.anchor = anchor;
            }
    }
    const auto most = std::ranges::max_element(steps, {}, [](const auto& entry) {
        return std::pair(entry.second.first, entry.second.second.distance_m);
    });
    // A single step has two ends, and does not tell which of them moved.
    return most == steps.end() || most->second.first < 2 ? std::nullopt : std::optional(most->second.second);
}

}  // namespace

std::vector<AnchorMove> shiftsOf(const Evidence& evidence, const RoomFit& fit) {
    std::vector<AnchorMove> moves;
    if (const auto between = moveBetween(evidence))
        moves.push_back(*between);
    for (size_t a = 0; a < evidence.anchors.size(); ++a) {
        std::vector<Pull> pulls;
        for (size_t i = 0; i < evidence.walk.size(); ++i) {
            const WalkRange& range = evidence.walk[i];
            if (range.anchor != static_cast<int>(a))
                continue;
            const Vector3d end = range.anchor_hears ? fit.unknowns.microphone_m(a) : fit.unknowns.source_m(a);
            pulls.push_back(
                {range.time_s, fit.walk_m[i], (end - fit.devices_at_m[i]).normalized(), range.device});
        }
        if (const auto move = moveOf(static_cast<int>(a), pulls, std::max(fit.flesh_m, 0.005)))
            moves.push_back(*move);
    }
    std::ranges::sort(moves, std::greater(), &AnchorMove::sigmas);
    return moves;
}

}  // namespace noctule::room_survey
