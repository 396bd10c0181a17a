// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/calibration/motion/motion_start.h"
#include "core/calibration/still_stretch.h"
#include "tests/support/guided_motion.h"
#include "tests/support/observed_take.h"

namespace noctule {
namespace {

constexpr double kDetour_m = 0.2, kSpread_m = 0.05;

/// Most sources reach the hand by way of the floor.
bool isLate(int source) {
    return source % 3 != 0;
}

int handOf(const Observations& take) {
    return take.suit.findBoard("r_hand");
}

Observations takeWithAHandThatHearsEchoes() {
    simulation::StageRequest request = test::stageOf(std::nullopt, 4);
    request.scenario = simulation::Scenario::ideal();
    request.clip = test::GuidedMotion::clip(test::GuidedPlan{3});
    Observations take = test::observe(request).value().observations;
    for (size_t i = 0; i < take.flights.size(); ++i)
        if (FlightTime& flight = take.flights[i]; flight.board == handOf(take) && isLate(flight.source))
            flight.flight_s += (kDetour_m + kSpread_m * std::sin(static_cast<double>(i))) / flight.c_m_per_s;
    return take;
}

/// Distances of a hand that are heard directly keep their weight beside those that are late: the noise is
/// that of a pair. With one noise for the whole board they would count a hundred times less.
TEST(MotionFit, LearnsTheNoiseOfEveryPair) {
    const Observations take = takeWithAHandThatHearsEchoes();
    MotionSettings settings;
    settings.flesh = false;
    settings.longest_s = 20;
    const MotionBody body(take.actor);
    const auto boards = static_cast<int>(take.suit.boards.size()),
               sources = static_cast<int>(take.suit.sources.size());
    const MotionLayout layout{body.size(), boards, sources, static_cast<int>(body.bones().size()), false};
    const MotionModel model(body, take, layout, settings.step_s);
    const std::vector<MotionEvidence> evidence{
        readMotion(take, findStillStretch(take), settings.step_s, settings.longest_s)};
    ExpectedConstants expected;
    for (const Board& board : take.suit.boards) {
        expected.boards.emplace_back();
        expected.boards.back().q_segment_board = board.q_segment_board;
        expected.boards.back().p_segment_board_m = board.p_segment_board_m;
    }
    for (const Source& source : take.suit.sources)
        expected.sources.push_back({source.p_segment_source_m, 0});
    MotionUnknowns start;
    std::vector<Quaterniond> q_segment_board;
    appendFirstNodes(body, model, evidence[0], expected, q_segment_board, start.nodes);
    start.boards = expected.boards;
    start.sources = expected.sources;
    start.bone_scale.assign(body.bones().size(), 1);
    MotionFit fit(body, model, layout, settings, evidence, expected);
    ASSERT_TRUE(fit.run(std::move(start), {}));
    for (int source = 0; source < sources; ++source) {
        const double noise_m = fit.noise().distance_m[static_cast<size_t>(source * boards + handOf(take))];
        if (isLate(source))
            EXPECT_GT(noise_m, 0.05) << source;
        else
            EXPECT_LT(noise_m, 0.01) << source;
    }
}

}  // namespace
}  // namespace noctule
