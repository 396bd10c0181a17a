// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/source_offsets/source_offsets.h"

#include <gtest/gtest.h>

#include "tests/core/calibration/jig_take.h"
#include "tests/support/fuzzing.h"

namespace noctule {
namespace {

using simulation::Random;
using test::JigTake;
using test::nominalJig;
using SpeedOfSound = SourceOffsetSettings::SpeedOfSound;

constexpr double kOffsetLimit_m = 3e-4;
constexpr double kPaperMean_m = 2.35e-3, kPaperDeviation_m = 1.92e-3;  // Vlasic 2007, section 4.3

int64_t seedCount(int64_t few) {
    return test::countFromEnvironment("NOCTULE_CALIBRATION_TRIALS", few);
}

void expectAsGoodAsThePaper(const SourceOffsetReport& report) {
    EXPECT_LT(report.all_left_out.mean_m, kPaperMean_m);
    EXPECT_LT(report.all_left_out.deviation_m, kPaperDeviation_m);
    EXPECT_GT(report.all_left_out.count, 0);
    EXPECT_EQ(report.grade(), Grade::kGood) << test::findingsText(report.findings);
}

TEST(SourceOffsets, AreRightWithTheThermometerAndWithout) {
    for (int64_t seed = 1; seed <= seedCount(3); ++seed) {
        const JigTake& jig = nominalJig(static_cast<uint64_t>(seed));
        for (const SpeedOfSound sound : {SpeedOfSound::kTemperature, SpeedOfSound::kEstimate}) {
            const SourceOffsetReport report = jig.solve({.speed_of_sound = sound});
            EXPECT_LT(jig.worstError_m(report), kOffsetLimit_m) << "seed " << seed;
            expectAsGoodAsThePaper(report);
            std::printf(
                "seed %lld, speed of sound by %s: worst offset off by %.3f mm, sigma %.3f mm; leave-one-out "
                "%.3f mm mean, %.3f mm deviation, %.3f mm worst; thermometer off by %.2f K\n",
                static_cast<long long>(seed), sound == SpeedOfSound::kEstimate ? "distances" : "thermometer",
                1e3 * jig.worstError_m(report), 1e3 * test::kJigSound_m_per_s * report.sources[0].sigma_s,
                1e3 * report.all_left_out.mean_m, 1e3 * report.all_left_out.deviation_m,
                1e3 * report.all_left_out.worst_m, jig.stage->truth.air.thermometer_error_c);
        }
    }
}

TEST(SourceOffsets, AreRightWithAThermometerThatIsExact) {
    simulation::StageRequest request = test::stageOf(simulation::RigKind::kJig, 4);
    request.scenario.temperature_error_c = 0;
    request.scenario.temperature_noise_c = 0;
    const JigTake jig = test::jigTake(request);
    const SourceOffsetReport report = jig.solve({.thermometer_sigma_k = 0, .thermometer_noise_k = 0});
    EXPECT_LT(jig.worstError_m(report), kOffsetLimit_m);
    expectAsGoodAsThePaper(report);
}

TEST(SourceOffsets, ScaleOfSoundIsThatOfTheTrueAir) {
    simulation::StageRequest request = test::stageOf(simulation::RigKind::kJig, 1);
    request.scenario.temperature_error_c = 2;  // as in realistic
    const JigTake jig = test::jigTake(request);
    const SourceOffsetReport estimated = jig.solve({.speed_of_sound = SpeedOfSound::kEstimate});
    const double true_scale =
        jig.stage->truth.air.speedOfSound_m_per_s() / jig.observations.flights.front().c_m_per_s;
    EXPECT_GT(std::abs(true_scale - 1), 1e-3) << "else the test shows nothing";
    EXPECT_NEAR(estimated.sound.scale, true_scale, 3 * estimated.sound_scale_sigma);
    EXPECT_LT(estimated.sound_scale_sigma, 2e-4) << "0.1 K";
    EXPECT_LT(jig.worstError_m(estimated), kOffsetLimit_m);
    EXPECT_EQ(estimated.applied({}).sound.scale, estimated.sound.scale);
    const SourceOffsetReport believed = jig.solve();
    EXPECT_LT(jig.worstError_m(believed), kOffsetLimit_m) << "the thermometer counts with its tolerance only";
    EXPECT_EQ(believed.applied({}).sound.scale, 1);
    EXPECT_GT(believed.all_left_out.mean_m, 3 * estimated.all_left_out.mean_m)
        << "what is left out is judged with the speed of sound that later takes will use";
}

/// Squared errors over their variances, on average over sources and seeds: 1 when sigmas are honest.
TEST(SourceOffsets, SigmasAreHonest) {
    double sum = 0;
    const int64_t seeds = seedCount(8);
    for (int64_t seed = 1; seed <= seeds; ++seed) {
        simulation::StageRequest request = test::stageOf(simulation::RigKind::kJig, 100 + seed);
        request.duration_s = 16;
        const JigTake jig = test::jigTake(request);
        const SourceOffsetReport report = jig.solve();
        for (size_t s = 0; s < report.sources.size(); ++s)
            sum += std::pow(jig.error_m(report, s) / test::kJigSound_m_per_s / report.sources[s].sigma_s, 2);
    }
    const double mean = sum / static_cast<double>(8 * seeds);
    // Errors of one seed are nearly one error, the mean of the microphones' delays; 3 sigma.
    const double tolerance = 3 * std::sqrt(2.0 / static_cast<double>(seeds));
    EXPECT_LT(mean, 1 + tolerance);
    EXPECT_GT(mean, std::max(0.3, 1 - tolerance));
    std::printf("squared error over variance, mean of %lld takes: %.2f\n", static_cast<long long>(seeds),
                mean);
}

TEST(SourceOffsets, MicrophonesAreTimedWhenAsked) {
    const JigTake& jig = nominalJig();
    const SourceOffsetReport report = jig.solve({.estimate_mic_delays = true});
    ASSERT_EQ(report.mic_delays.size(), 18u);
    double mean_s = 0, true_mean_s = 0, worst_s = 0, spread_s = 0;
    const auto& truth = jig.stage->truth.sound.boards;
    for (size_t b = 0; b < 18; ++b) {
        mean_s += report.mic_delays[b].delay_s / 18;
        true_mean_s += truth[b].mic_delay_s / 18;
    }
    for (size_t b = 0; b < 18; ++b) {
        worst_s =
            std::max(worst_s, std::abs(report.mic_delays[b].delay_s - truth[b].mic_delay_s + true_mean_s));
        spread_s = std::max(spread_s, std::abs(truth[b].mic_delay_s - true_mean_s));
    }
    EXPECT_NEAR(mean_s, 0, 1e-11) << "the mean of those in force";
    EXPECT_LT(worst_s, 3e-7) << "0.1 mm";
    EXPECT_GT(spread_s, 1e-6) << "else the test shows nothing";
    EXPECT_LT(report.all_left_out.mean_m, jig.solve().all_left_out.mean_m);
    const Calibration applied = report.applied({});
    ASSERT_EQ(applied.boards.size(), 18u);
    EXPECT_EQ(applied.boards[3].mic_delay_s, report.mic_delays[3].delay_s);
    EXPECT_EQ(applied.boards[3].gyro.matrix, nominalCalibration(report.suit).boards[3].gyro.matrix)
        << "a board that the base lacks stays nominal";
}

TEST(SourceOffsets, KnownMicrophoneDelaysAreTakenOff) {
    JigTake jig = nominalJig();
    for (size_t b = 0; b < 18; ++b)
        jig.observations.calibration.boards[b].mic_delay_s = jig.stage->truth.sound.boards[b].mic_delay_s;
    const SourceOffsetReport report = jig.solve({.mic_delay_sigma_s = 0});
    EXPECT_LT(jig.worstError_m(report), 1e-4);
}

TEST(SourceOffsets, RealDetectorOnSound) {
    simulation::StageRequest request = test::stageOf(simulation::RigKind::kJig, 3);
    request.duration_s = 16;
    const JigTake jig = test::jigTake(request, simulation::Level::kSignal);
    const SourceOffsetReport report = jig.solve();
    EXPECT_LT(jig.worstError_m(report), kOffsetLimit_m);
    for (size_t s = 0; s < report.sources.size(); ++s)
        std::printf("sound, source %zu: off by %.3f mm, sigma %.3f mm, residuals %.3f mm\n", s + 1,
                    1e3 * jig.error_m(report, s), 1e3 * test::kJigSound_m_per_s * report.sources[s].sigma_s,
                    1e3 * report.sources[s].rms_m);
    expectAsGoodAsThePaper(report);
    std::printf("sound: leave-one-out %.3f mm mean, %.3f mm deviation, %d measurements\n",
                1e3 * report.all_left_out.mean_m, 1e3 * report.all_left_out.deviation_m,
                report.all_left_out.count);
}

TEST(SourceOffsets, TwoTakesCountTogether) {
    const JigTake& jig = nominalJig();
    const SourceOffsetReport once = jig.solve();
    Observations again = jig.observations;
    again.calibration.sound.scale = 1.01;  // the same air, known by another scale
    for (FlightTime& flight : again.flights)
        flight.c_m_per_s *= 1.01;
    const SourceOffsetReport twice = calibrateSourceOffsets({jig.observations, again}, jig.known());
    EXPECT_EQ(twice.measurements.size(), 2 * once.measurements.size());
    EXPECT_NEAR(twice.sources[0].offset_s, once.sources[0].offset_s, 1e-8);
    EXPECT_EQ(twice.grade(), Grade::kGood) << test::findingsText(twice.findings);
}

TEST(SourceOffsets, AppliedKeepsAllElse) {
    const JigTake& jig = nominalJig();
    Calibration base = jig.stage->calibration;
    base.sources.erase(base.sources.begin());
    base.created_utc = "2020-01-01T00:00:00Z";
    const SourceOffsetReport report = jig.solve();
    const Calibration applied = report.applied(base);
    ASSERT_EQ(applied.sources.size(), 8u);
    EXPECT_EQ(applied.sources.back().id, "chest_l");
    EXPECT_EQ(applied.sources.back().offsets_s.size(), 1u);
    for (const SourceOffset& source : report.sources) {
        const SourceCalibration* found = applied.findSource(source.id);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->offsets_s.at("inflection"), source.offset_s);
        EXPECT_EQ(found->sigma_s.at("inflection"), source.sigma_s);
    }
    EXPECT_EQ(applied.findSource("hat")->offsets_s.at("start"),
              base.findSource("hat")->offsets_s.at("start"));
    Calibration without = applied;
    without.sources = base.sources;
    EXPECT_EQ(toJson(without), toJson(base));
}

/// Of the jig with every label right.
const SourceOffsetReport& wholeReport(uint64_t jig_seed) {
    static std::map<uint64_t, SourceOffsetReport> reports;
    const auto known = reports.find(jig_seed);
    return known != reports.end() ? known->second
                                  : reports.emplace(jig_seed, nominalJig(jig_seed).solve()).first->second;
}

/// Exchanges two labels of one kind, in one placement or in all, and sees them named and nothing else wrong.
bool isSwapNamed(int64_t trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    Random random(static_cast<uint64_t>(trial), "labels");
    const auto jig_seed = 1 + static_cast<uint64_t>(trial % 3);
    const JigTake& jig = nominalJig(jig_seed);
    const bool boards = random.below(2) == 0;
    const Suit& suit = jig.stage->suit;
    const int64_t count = boards ? std::ssize(suit.boards) : std::ssize(suit.sources);
    const auto first = static_cast<size_t>(random.below(count - 1));
    const auto second =
        first + 1 + static_cast<size_t>(random.below(count - 1 - static_cast<int64_t>(first)));
    const auto id = [&](size_t i) { return boards ? suit.boards[i].id : suit.sources[i].id; };
    const std::string placement = random.below(2) == 0 ? "" : std::to_string(1 + random.below(6));
    const SourceOffsetReport report = jig.solveWith(
        test::withSwapped(jig.csv, boards ? "board" : "source", id(first), id(second), placement));
    const SourceOffsetReport& whole = wholeReport(jig_seed);
    const SwappedLabels expected{boards ? SwappedLabels::Kind::kBoards : SwappedLabels::Kind::kSources,
                                 id(first), id(second), placement};
    EXPECT_EQ(report.swaps, std::vector{expected}) << test::findingsText(report.findings);
    for (size_t s = 0; s < report.sources.size(); ++s) {
        const bool lost = !boards && placement.empty() && (s == first || s == second);
        EXPECT_EQ(report.sources[s].calibrated, !lost);
        if (!lost) {
            EXPECT_LT(std::abs(jig.error_m(report, s) - jig.error_m(whole, s)), 1e-4)
                << "what is right stays right";
        }
    }
    EXPECT_NE(report.grade(), Grade::kGood);
    return report.swaps == std::vector{expected} &&
           test::findingWith(report.findings, {id(first), id(second), "exchanged"});
}

TEST(SourceOffsets, ExchangedLabelsAreNamed) {
    const int64_t trials = seedCount(50);
    int64_t named = 0;
    for (int64_t trial = 1; trial <= trials; ++trial)
        named += isSwapNamed(trial) ? 1 : 0;
    EXPECT_EQ(named, trials);
    std::printf("%lld of %lld exchanged labels named\n", static_cast<long long>(named),
                static_cast<long long>(trials));
}

TEST(SourceOffsets, ExchangedPlacementsAndTwoSwapsAreNamed) {
    const JigTake& jig = nominalJig();
    const SourceOffsetReport placements = jig.solveWith(test::withRows(jig.csv, [](test::CsvCells& cells) {
        cells[0] = cells[0] == "2" ? "5" : cells[0] == "5" ? "2" : cells[0];
    }));
    ASSERT_EQ(placements.swaps.size(), 1u) << test::findingsText(placements.findings);
    EXPECT_EQ(placements.swaps[0], (SwappedLabels{SwappedLabels::Kind::kPlacements, "2", "5", ""}));
    EXPECT_LT(jig.worstError_m(placements), kOffsetLimit_m);
    const SourceOffsetReport both = jig.solveWith(test::withSwapped(
        test::withSwapped(jig.csv, "board", "hips", "head"), "source", "hat", "navel", "4"));
    EXPECT_EQ(both.swaps.size(), 2u) << test::findingsText(both.findings);
    EXPECT_TRUE(test::findingWith(both.findings, {"hips", "head", "exchanged"}));
    EXPECT_TRUE(test::findingWith(both.findings, {"navel", "hat", "exchanged in placement 4"}));
    EXPECT_LT(jig.worstError_m(both), kOffsetLimit_m);
}

}  // namespace
}  // namespace noctule
