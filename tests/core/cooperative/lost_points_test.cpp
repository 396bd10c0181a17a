// SPDX-License-Identifier: Apache-2.0
// A foot that steps while nobody hears it, is then heard by the sources on a partner's chest alone, and later
// by the room's as well.
#include "core/cooperative/lost_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/cooperative/point_filter.h"

namespace noctule::cooperative {
namespace {

constexpr double kPulse_s = 0.008, kRangeSigma_m = 0.003;
constexpr double kLeaves_s = 1, kComesBack_s = 2, kInSight_s = 3, kEnds_s = 4;
constexpr int kHip = 0, kFoot = 1, kCorners = 4;
const Vector3d kHip_m(0, 0.95, 0);

/// Four corners of a room, then eight sources on the chest of somebody who stands a metre in front.
std::vector<Vector3d> ends() {
    std::vector<Vector3d> ends{{2.3, 2.7, 2.3}, {-2.3, 0.4, 2.3}, {-2.3, 2.7, -2.3}, {2.3, 0.4, -2.3}};
    for (const double x : {-0.1, 0.1})
        for (const double y : {0.9, 1.1, 1.3, 1.45})
            ends.emplace_back(x, y, 1 + 0.01 * (y > 1.2) - 0.01 * (x > 0 && y < 1));
    return ends;
}

/// A step of 0.4 m: fastest, 2 m/s, when the foot is heard for the last time.
Vector3d footAt(double time_s) {
    const double through = std::clamp((time_s - 0.8) / 0.4, 0.0, 1.0);
    return {0.1, 0.08, 0.4 * through * through * (3 - 2 * through)};
}

struct Walked {
    double heard_by_chest_m = 0;  ///< error after a second in which the chest alone was heard
    double error_m = 0;           ///< at the end
    double worst_sigmas = 0;  ///< largest error in units of the stated sigma, since the foot is heard again
    bool was_lost = false, is_lost = false;
};

Walked walk(bool seeks_lost) {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0, kRangeSigma_m);
    const std::vector<Vector3d> ends_m = ends(), rest_m{kHip_m, footAt(0)};
    PointFilterSettings settings;
    PointFilter filter(settings, startPoints(rest_m, 0.03, 0.1), {0, 0}, ends_m);
    LostPoints lost(rest_m, {0, 0}, {{Reach{0, 0}, Reach{0, 1}}, {Reach{0, 1}, Reach{0, 0}}});
    Walked walked;
    size_t turn = 0;
    for (double time_s = kPulse_s; time_s < kEnds_s; time_s += kPulse_s, ++turn) {
        filter.predict(kPulse_s);
        if (seeks_lost)
            lost.look(filter.points(), time_s);
        const auto corner = static_cast<int>(turn % kCorners);
        const auto source = static_cast<int>(kCorners + turn % (ends_m.size() - kCorners));
        const auto measured = [&](const Vector3d& p, int end) {
            return (p - ends_m[static_cast<size_t>(end)]).norm() + noise(random);
        };
        const double variance = kRangeSigma_m * kRangeSigma_m;
        std::vector<PointRange> ranges{{kHip, anchorPoint(corner), measured(kHip_m, corner), variance}};
        const bool of_room = time_s < kLeaves_s || (time_s > kInSight_s && turn % 3 == 0);
        const int heard = of_room ? corner : source;
        if (time_s < kLeaves_s || time_s > kComesBack_s) {
            const double distance_m = measured(footAt(time_s), heard);
            if (lost.isLost(kFoot))
                lost.note(kFoot, {time_s, distance_m, variance, ends_m[static_cast<size_t>(heard)],
                                  anchorPoint(heard)});
            else
                ranges.push_back({kFoot, anchorPoint(heard), distance_m, variance});
        }
        filter.correct(ranges, 0);
        walked.was_lost |= lost.isLost(kFoot);
        walked.error_m = (filter.points().place(kFoot) - footAt(time_s)).norm();
        if (time_s < kInSight_s)
            walked.heard_by_chest_m = walked.error_m;
        const Matrix3d P = filter.points().cov_pp.block<3, 3>(3 * kFoot, 3 * kFoot);
        if (time_s > kComesBack_s + 0.5)
            walked.worst_sigmas = std::max(walked.worst_sigmas, walked.error_m / std::sqrt(P.trace()));
    }
    walked.is_lost = lost.isLost(kFoot);
    return walked;
}

TEST(LostPoints, AFilterAloneTakesTheMirrorImageForTheFoot) {
    EXPECT_GT(walk(false).heard_by_chest_m, 0.5);
}

TEST(LostPoints, AFootThatSteppedUnheardIsFoundAgain) {
    const Walked walked = walk(true);
    EXPECT_TRUE(walked.was_lost);
    EXPECT_FALSE(walked.is_lost);
    EXPECT_LT(walked.heard_by_chest_m, 0.06);
    EXPECT_LT(walked.error_m, 0.02);
    EXPECT_LT(walked.worst_sigmas, 3);
}

/// Ranges to all sources of the chest for a quarter of a second, of a foot that stands.
std::deque<LostRange> heardByAChest(const Vector3d& foot_m) {
    std::deque<LostRange> ranges;
    const std::vector<Vector3d> ends_m = ends();
    for (int k = 0; k < 32; ++k) {
        const int end = kCorners + k % 8;
        const Vector3d& known_m = ends_m[static_cast<size_t>(end)];
        ranges.push_back({kPulse_s * k, (foot_m - known_m).norm(), 1e-5, known_m, anchorPoint(end)});
    }
    return ranges;
}

PointBelief vague(const Vector3d& about_m) {
    PointBelief prior;
    prior.p_m = about_m;
    prior.covariance.diagonal() << 1, 1, 1, 0.04, 0.04, 0.04;
    return prior;
}

TEST(PointFit, AMirrorImageMakesUnsureUnlessBonesForbidIt) {
    const Vector3d foot_m(0.1, 0.08, 0.4), between_m(0.1, 0.08, 1);
    const std::deque<LostRange> ranges = heardByAChest(foot_m);
    const PointFit either = fitPoint(ranges, 0.25, vague(between_m), {}, {});
    EXPECT_FALSE(either.is_certain);
    EXPECT_GT(std::sqrt(either.belief.covariance(2, 2)), 0.4) << "both sides of the chest";
    const PointFit bound = fitPoint(ranges, 0.25, vague(between_m), {{{kHip_m, {0, 1}}}}, {});
    EXPECT_LT((bound.belief.p_m - foot_m).norm(), 0.02);
    EXPECT_LT(std::sqrt(bound.belief.covariance(2, 2)), 0.2);
    EXPECT_FALSE(bound.is_certain) << "late sound from one plane moves it";
    std::deque<LostRange> more = ranges;
    const std::vector<Vector3d> ends_m = ends();
    for (int k = 0; k < 2 * kCorners; ++k) {
        const Vector3d& known_m = ends_m[static_cast<size_t>(k % kCorners)];
        more.push_back({kPulse_s * k, (foot_m - known_m).norm(), 1e-5, known_m, anchorPoint(k % kCorners)});
    }
    EXPECT_TRUE(fitPoint(more, 0.25, vague(between_m), {{{kHip_m, {0, 1}}}}, {}).is_certain);
}

TEST(PointFit, NothingIsBelowTheFloor) {
    const Vector3d image_m(0.1, -0.3, 0.4);
    const PointFit found = fitPoint(heardByAChest(image_m), 0.25, vague(image_m), {{}, 0}, {});
    EXPECT_GT(found.belief.p_m.y(), -0.1);
    EXPECT_LT(fitPoint(heardByAChest(image_m), 0.25, vague(image_m), {}, {}).belief.p_m.y(), -0.25);
}

TEST(LostPoints, WhatBonesForbidIsLost) {
    const std::vector<Vector3d> rest_m{{0, 1, 0}, {0, 0.5, 0}, {0, 0.1, 0}};
    std::vector<std::vector<Reach>> reaches(3, std::vector<Reach>(3, Reach{0, 0.6}));
    reaches[0][2] = reaches[2][0] = Reach{0, 1};
    LostPoints lost(rest_m, {0, 0, 0}, reaches);
    FreePoints points = startPoints({rest_m[0], rest_m[1], {0, 0.1, 1.2}}, 0.01, 0.1);
    lost.look(points, 0.1);
    EXPECT_FALSE(lost.isLost(0));
    EXPECT_FALSE(lost.isLost(1));
    EXPECT_TRUE(lost.isLost(2));
    EXPECT_GT(std::sqrt(points.cov_pp(6, 6)), 0.1) << "it goes along with its neighbour, unsure";
    EXPECT_LT((points.place(2) - rest_m[2]).norm(), 0.05);
}

TEST(LostPoints, AHungPointSharesTheErrorOfItsNeighbour) {
    FreePoints points = startPoints({{0, 1, 0}, {0, 0, 0}}, 0.02, 0.1);
    predict(points, 0.1, 0.3);
    hangPoint(points, 1, 0, {0, -1, 0}, 0.05, 1);
    EXPECT_NEAR(relativeVariance(points, 0, 1), 3 * 0.05 * 0.05, 1e-12);
    EXPECT_TRUE(points.covariance().isApprox(points.covariance().transpose(), 1e-12));
}

}  // namespace
}  // namespace noctule::cooperative
