// SPDX-License-Identifier: Apache-2.0
#include "core/room_survey/anchor_start.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/linear_solvers.h"
#include "core/math/order_statistics.h"

namespace noctule::room_survey {
namespace {

constexpr double kCoarse_m = 0.2, kFine_m = 0.05;  ///< scale of the Cauchy loss
constexpr int kSteps = 20;
constexpr size_t kMostRanges = 400;  ///< of one anchor, spread over the walk
constexpr double kOtherPlace_m = 0.25;
/// A rival costs at most so much more; beyond that the ranges tell both apart.
constexpr double kRivalCost = 1.25;
constexpr double kUnheard_m = 1e6;
/// What both directions of a pair share: offset of the source, microphone's delay, temperature's gradients.
constexpr double kConstantError_m = 0.001;

/// A known point and how far away it is; `clock`: by how much of the clock's error that is too long.
struct KnownRange {
    Vector3d p_m;
    double distance_m, clock;
};

using Place = Eigen::Vector4d;  ///< x, y, z, clock

struct PlaceFit {
    Place u;
    double cost = 0;
};

double costOf(const std::vector<KnownRange>& ranges, const Place& u, double scale_m) {
    double cost = 0;
    for (const KnownRange& range : ranges) {
        const double r = range.distance_m - (u.head<3>() - range.p_m).norm() - range.clock * u[3];
        cost += std::log1p(r * r / (scale_m * scale_m));
    }
    return cost / static_cast<double>(ranges.size());
}

Place improved(const std::vector<KnownRange>& ranges, Place u, double scale_m, bool fits_clock) {
    for (int step = 0; step < kSteps; ++step) {
        Eigen::Matrix4d A = 1e-6 * Eigen::Matrix4d::Identity();
        Place g = Place::Zero();
        for (const KnownRange& range : ranges) {
            const Vector3d between = u.head<3>() - range.p_m;
            const double length = std::max(between.norm(), 1e-6);
            const double r = range.distance_m - length - range.clock * u[3];
            Place d;
            d << between / length, fits_clock ? range.clock : 0;
            const double w = 1 / (1 + r * r / (scale_m * scale_m));
            A += w * d * d.transpose();
            g += w * r * d;
        }
        Place change = solveSymmetric(A, g);
        change *= std::min(1.0, 1.0 / std::max(1e-9, change.head<3>().norm()));
        u += change;
        if (change.norm() < 1e-6)
            break;
    }
    return u;
}

/// From starts all over a room about the known points; the best, and the best of those elsewhere.
std::pair<PlaceFit, std::optional<PlaceFit>> placed(const std::vector<KnownRange>& ranges, double clock_m,
                                                    bool fits_clock) {
    Vector3d middle = Vector3d::Zero();
    for (const KnownRange& range : ranges)
        middle += range.p_m / static_cast<double>(ranges.size());
    std::vector<PlaceFit> fits;
    for (const double x : {-4.0, -2.0, 0.0, 2.0, 4.0})
        for (const double z : {-4.0, -2.0, 0.0, 2.0, 4.0})
            for (const double y : {-1.5, 0.0, 1.5}) {
                Place u;
                u << middle + Vector3d(x, y, z), clock_m;
                u = improved(ranges, improved(ranges, u, kCoarse_m, fits_clock), kFine_m, fits_clock);
                fits.push_back({u, costOf(ranges, u, kFine_m)});
            }
    std::ranges::sort(fits, {}, &PlaceFit::cost);
    const auto other = std::ranges::find_if(
        fits, [&](const PlaceFit& fit) { return (fit.u - fits.front().u).head<3>().norm() > kOtherPlace_m; });
    return {fits.front(), other == fits.end() ? std::nullopt : std::optional(*other)};
}

bool isRival(const PlaceFit& best, const std::optional<PlaceFit>& other) {
    return other && other->cost < kRivalCost * best.cost + 1e-3;
}

std::vector<KnownRange> rangesToDevices(const Evidence& evidence, int anchor) {
    std::vector<KnownRange> all;
    for (const WalkRange& range : evidence.walk)
        if (range.anchor == anchor)
            all.push_back({range.p_m, range.distance_m, range.anchor_hears ? 1.0 : -1.0});
    if (all.size() <= kMostRanges)
        return all;
    std::vector<KnownRange> spread;
    for (size_t i = 0; i < kMostRanges; ++i)
        spread.push_back(all[i * all.size() / kMostRanges]);
    return spread;
}

std::vector<KnownRange> rangesToPlaced(const std::vector<PairDistance>& pairs, const AnchorStart& start,
                                       int anchor) {
    std::vector<KnownRange> all;
    for (const PairDistance& pair : pairs)
        if (pair.a == anchor || pair.b == anchor)
            if (const auto& other = start.places_m[static_cast<size_t>(pair.a == anchor ? pair.b : pair.a)])
                all.push_back({*other, pair.distance_m, 0});
    return all;
}

void put(AnchorStart& start, int anchor, const std::vector<KnownRange>& ranges, bool fits_clock = false) {
    const auto [best, other] = placed(ranges, start.clock_m, fits_clock);
    start.places_m[static_cast<size_t>(anchor)] = best.u.head<3>();
    start.is_mirrored[static_cast<size_t>(anchor)] = isRival(best, other);
    if (fits_clock)
        start.clock_m = best.u[3];
}

/// All-pairs shortest ways over measured distances.
Eigen::MatrixXd completed(const Evidence& evidence) {
    const auto n = static_cast<Eigen::Index>(evidence.anchors.size());
    Eigen::MatrixXd D = Eigen::MatrixXd::Constant(n, n, kUnheard_m);
    D.diagonal().setZero();
    for (const PairDistance& pair : pairDistances(evidence))
        D(pair.a, pair.b) = D(pair.b, pair.a) = pair.distance_m;
    for (Eigen::Index via = 0; via < n; ++via)
        for (Eigen::Index a = 0; a < n; ++a)
            for (Eigen::Index b = 0; b < n; ++b)
                D(a, b) = std::min(D(a, b), D(a, via) + D(via, b));
    return D;
}

}  // namespace

std::vector<PairDistance> pairDistances(const Evidence& evidence) {
    std::map<std::pair<int, int>, std::vector<double>> ways;
    for (const AnchorRange& range : evidence.between)
        ways[{range.from, range.to}].push_back(range.distance_m);
    std::vector<PairDistance> pairs;
    const auto count = static_cast<int>(evidence.anchors.size());
    for (int a = 0; a < count; ++a)
        for (int b = a + 1; b < count; ++b) {
            const auto there = ways.find({a, b}), back = ways.find({b, a});
            PairDistance pair{a, b};
            double sum_m = 0, variance_m2 = 0, directions = 0;
            std::vector<double> medians;
            for (const auto& way : {there, back}) {
                if (way == ways.end())
                    continue;
                const double median_m = medianOf(way->second), n = static_cast<double>(way->second.size());
                sum_m += median_m, directions += 1;
                variance_m2 += std::pow(1.25 * spreadAbout(median_m, way->second), 2) / n;
                pair.count += static_cast<int>(way->second.size());
                medians.push_back(median_m);
            }
            if (medians.empty())
                continue;
            pair.distance_m = sum_m / directions;
            pair.sigma_m = std::hypot(std::sqrt(variance_m2) / directions, kConstantError_m);
            if (medians.size() == 2)
                pair.apart_m = std::abs(medians[0] - medians[1]);
            pairs.push_back(pair);
        }
    return pairs;
}

AnchorStart startFromWalk(const Evidence& evidence) {
    const auto count = static_cast<int>(evidence.anchors.size());
    AnchorStart start{std::vector<std::optional<Vector3d>>(evidence.anchors.size()),
                      std::vector<char>(evidence.anchors.size(), 0), 0};
    std::vector<std::pair<int, int>> by_ranges;
    for (int anchor = 0; anchor < count; ++anchor)
        by_ranges.emplace_back(
            static_cast<int>(std::ranges::count(evidence.walk, anchor, &WalkRange::anchor)), anchor);
    std::ranges::sort(by_ranges, std::greater());
    bool clock_known = evidence.clock_known;
    for (const auto& [heard, anchor] : by_ranges)
        if (heard >= kFewestRanges) {
            put(start, anchor, rangesToDevices(evidence, anchor), !clock_known);
            clock_known = true;
        }
    const std::vector<PairDistance> pairs = pairDistances(evidence);
    for (int round = 0; round < count; ++round)
        for (int anchor = 0; anchor < count; ++anchor)
            if (!start.places_m[static_cast<size_t>(anchor)])
                if (const auto ranges = rangesToPlaced(pairs, start, anchor); ranges.size() >= kFewestAnchors)
                    put(start, anchor, ranges);
    return start;
}

AnchorStart startFromDistances(const Evidence& evidence) {
    const auto n = static_cast<Eigen::Index>(evidence.anchors.size());
    AnchorStart start{std::vector<std::optional<Vector3d>>(evidence.anchors.size()),
                      std::vector<char>(evidence.anchors.size(), 1), 0};
    const Eigen::MatrixXd D = completed(evidence);
    // Anchors that no chain of distances joins to the first one stay without a place.
    std::vector<Eigen::Index> joined;
    for (Eigen::Index a = 0; a < n; ++a)
        if (D(0, a) < kUnheard_m)
            joined.push_back(a);
    const auto m = static_cast<Eigen::Index>(joined.size());
    Eigen::MatrixXd squares(m, m);
    for (Eigen::Index a = 0; a < m; ++a)
        for (Eigen::Index b = 0; b < m; ++b)
            squares(a, b) = std::pow(D(joined[static_cast<size_t>(a)], joined[static_cast<size_t>(b)]), 2);
    const Eigen::MatrixXd J =
        Eigen::MatrixXd::Identity(m, m) - Eigen::MatrixXd::Constant(m, m, 1.0 / static_cast<double>(m));
    const Eigensystem axes = eigensystemOf(-0.5 * J * squares * J);
    for (Eigen::Index a = 0; a < m; ++a) {
        Vector3d p = Vector3d::Zero();
        for (Eigen::Index axis = 0; axis < std::min<Eigen::Index>(3, m); ++axis) {
            const Eigen::Index k = m - 1 - axis;
            p[axis] = axes.vectors(a, k) * std::sqrt(std::max(0.0, axes.values[k]));
        }
        start.places_m[static_cast<size_t>(joined[static_cast<size_t>(a)])] = p;
    }
    return start;
}

}  // namespace noctule::room_survey
