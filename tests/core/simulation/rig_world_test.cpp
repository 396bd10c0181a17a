// SPDX-License-Identifier: Apache-2.0
// Rigs against what a pencil says: g on every side, the table's rate and centripetal acceleration, distances
// over the speed of sound.
#include "core/simulation/rig_world.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/math/rotation.h"
#include "core/recording/take.h"
#include "core/simulation/propagation.h"
#include "core/simulation/simulate.h"
#include "core/suit/default_suit.h"
#include "tests/support/files.h"

namespace noctule::simulation {
namespace {

constexpr double kG = kStandardGravity_m_per_s2;
constexpr double kOmega45 = 45 * 2 * std::numbers::pi / 60;

RigWorld makeRig(RigKind kind, uint64_t seed = 1) {
    return RigWorld(kind, defaultSuit(), RigScenario{}, seed, 1000);
}

double middleOf(const RigStation& station) {
    return (station.begin_s + station.end_s) / 2;
}

TEST(RigWorld, TheLevelPlateReadsGravityOnEverySide) {
    RigWorld rig = makeRig(RigKind::kLevelPlate);
    const auto stations = runThrough(rig, RigScenario{}, 2);
    const auto sides = allRigSides();
    ASSERT_EQ(stations.size(), 6u);
    for (size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(stations[i].label, sides[i].name() + " up");
        for (const double t_s : {stations[i].begin_s, middleOf(stations[i]), stations[i].end_s})
            for (const int board : {0, 17}) {
                const BoardMotion motion = rig.boardMotion(board, t_s);
                EXPECT_NEAR(motion.accel_m_per_s2.norm(), kG, 1e-9);
                const double off_rad = std::acos(motion.accel_m_per_s2.normalized().dot(sides[i].up()));
                EXPECT_GT(off_rad, 0) << "no plate is level";
                EXPECT_LT(off_rad, radians(0.05 * 5));
                EXPECT_LT(motion.gyro_rad_per_s.norm(), 1e-9);
            }
    }
}

TEST(RigWorld, ThePlatesErrorIsTheScenarios) {
    double sum2 = 0;
    constexpr int kSeeds = 400;
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Vector3d accel = makeRig(RigKind::kLevelPlate, seed).boardMotion(0, 0).accel_m_per_s2 / kG;
        sum2 += accel.x() * accel.x() + accel.z() * accel.z();
    }
    EXPECT_NEAR(degrees(std::sqrt(sum2 / (2 * kSeeds))), 0.05, 0.05 * 0.12);  // 5 sigma of the deviation
}

/// By integrating what the gyroscope says.
Quaterniond integrated(const RigWorld& rig, int board, double from_s, double to_s) {
    constexpr int kSteps = 4000;
    const double step_s = (to_s - from_s) / kSteps;
    Quaterniond q = rig.boardMotion(board, from_s).q_world_board;
    for (int i = 0; i < kSteps; ++i)
        q = q * expQuaternion(rig.boardMotion(board, from_s + (i + 0.5) * step_s).gyro_rad_per_s * step_s);
    return q;
}

TEST(RigWorld, TurningAndSpinningUpAreFelt) {
    RigWorld plate = makeRig(RigKind::kLevelPlate);
    const double done_s = plate.layOn({0, +1}, plate.layOn({1, -1}, 1));
    EXPECT_EQ(done_s, 1 + 2 * RigWorld::kTurn_s);
    EXPECT_LT(angleBetween(integrated(plate, 3, 0, done_s), plate.boardMotion(3, done_s).q_world_board),
              1e-5);
    RigWorld table = makeRig(RigKind::kTurntable);
    table.spin({1, +1}, 45, 0.5);
    EXPECT_LT(angleBetween(integrated(table, 3, 0, 3), table.boardMotion(3, 3).q_world_board), 1e-5);
    const double t_s = 1.3, h_s = 1e-4;  // while it speeds up: the acceleration is the second difference
    const auto at = [&](double s) { return table.boardMotion(17, s).p_world_board_m; };
    const Vector3d felt =
        table.boardMotion(17, t_s).q_world_board * table.boardMotion(17, t_s).accel_m_per_s2;
    const Vector3d wanted =
        (at(t_s + h_s) - 2 * at(t_s) + at(t_s - h_s)) / (h_s * h_s) + kG * Vector3d::UnitY();
    EXPECT_LT((felt - wanted).norm(), 1e-5);
}

TEST(RigWorld, TheTurntableTurnsAtItsSpeedOnEverySide) {
    RigWorld rig = makeRig(RigKind::kTurntable);
    const auto stations = runThrough(rig, RigScenario{}, 6);
    const auto sides = allRigSides();
    ASSERT_EQ(stations.size(), 6u);
    const double omega = rig.boardMotion(0, middleOf(stations[0])).gyro_rad_per_s.norm();
    EXPECT_NE(omega, kOmega45);
    EXPECT_NEAR(omega / kOmega45, 1, 5 * 0.0008);
    for (size_t i = 0; i < 6; ++i) {
        const int board = 17;
        const double turn_s = 2 * std::numbers::pi / omega;
        Vector3d mean = Vector3d::Zero();
        double highest = 0;
        constexpr int kInstants = 360;
        for (int k = 0; k < kInstants; ++k) {
            const BoardMotion motion = rig.boardMotion(board, stations[i].begin_s + turn_s * k / kInstants);
            EXPECT_LT((motion.gyro_rad_per_s - omega * sides[i].up()).norm(), 1e-9);
            mean += motion.accel_m_per_s2 / kInstants;
            highest = std::max(highest, motion.accel_m_per_s2.norm());
        }
        const Vector3d arm = rig.boardMotion(board, 0).p_world_board_m - Vector3d(0, RigWorld::kHeight_m, 0);
        const double up = mean.dot(sides[i].up());
        EXPECT_NEAR(up, kG, 2e-3) << "g cos(tilt)";
        EXPECT_NEAR((mean - up * sides[i].up()).norm(), omega * omega * arm.norm(), 1e-6) << "centripetal";
        EXPECT_GT(highest, mean.norm() + 1e-4) << "a table that is not level ripples once a turn";
    }
    EXPECT_EQ(rig.boardMotion(0, stations.back().end_s + RigWorld::kSpeedUp_s).gyro_rad_per_s.norm(), 0);
}

TEST(RigWorld, DistancesOnTheJigAreThoseOfItsPlacement) {
    RigWorld rig = makeRig(RigKind::kJig);
    const auto stations = runThrough(rig, RigScenario{}, 2);
    ASSERT_EQ(stations.size(), 6u);
    double nearest = 1, farthest = 0;
    for (int k = 0; k < 6; ++k)
        for (int s = 0; s < rig.sourceCount(); ++s)
            for (int b = 0; b < rig.boardCount(); ++b) {
                const double distance_m = (rig.sourceIn(k, s) - rig.microphoneIn(k, b)).norm();
                nearest = std::min(nearest, distance_m);
                farthest = std::max(farthest, distance_m);
                const double t_s = middleOf(stations[k]);
                const Flight flight = directFlight(rig, s, b, t_s, 343);
                EXPECT_NEAR(flight.distance_m, distance_m, 1e-12);
                EXPECT_NEAR(flight.arrival_s - t_s, distance_m / 343, 1e-12);
                EXPECT_GT(rig.sourceNormal(s, t_s).dot(rig.microphoneIn(k, b) - rig.sourceIn(k, s)), 0);
            }
    EXPECT_GE(nearest, 0.3);
    EXPECT_LE(farthest, 0.9);
    EXPECT_LT(nearest, 0.35);
    EXPECT_GT(farthest, 0.8);
    EXPECT_LT((rig.boardMotion(4, middleOf(stations[3])).accel_m_per_s2 - kG * Vector3d::UnitY()).norm(),
              1e-9);
}

TEST(RigWorld, BeginningAgainKeepsWhatWasDone) {
    RigWorld table = makeRig(RigKind::kTurntable), jig = makeRig(RigKind::kJig);
    table.spin({0, -1}, -30, 5);
    jig.place(4, 5);
    table.beginAgain();
    jig.beginAgain();
    EXPECT_NEAR(table.boardMotion(0, 0).gyro_rad_per_s.x(), kOmega45 * 30 / 45, 5 * 0.0008 * kOmega45);
    EXPECT_EQ(jig.microphone(7, 0), jig.microphoneIn(4, 7));
    EXPECT_EQ(jig.place(4, 1), 1) << "is there already";
}

StageRequest onRig(RigKind kind, const Scenario& scenario) {
    StageRequest request;
    request.suit = defaultSuit();
    request.scenario = scenario;
    request.rig = kind;
    return request;
}

TEST(RigTakes, ReadingsOfTheLevelPlateAreGravityBeyondTheScenariosErrors) {
    for (const Scenario& scenario : {Scenario::ideal(), Scenario::nominal()}) {
        const auto stage = prepareStage(onRig(RigKind::kLevelPlate, scenario));
        ASSERT_TRUE(stage) << stage.error().text();
        const bool ideal = scenario.name == "ideal";
        const int board = 5;
        const AxisCalibration& accel = stage->truth.inertia[board].accel.calibration;
        BoardReadings readings(*stage->world, board, stage->truth.inertia[board], stage->scenario, 1);
        std::vector<Vector3d> sums(6, Vector3d::Zero());
        std::vector<int> counts(6);
        for (int frame = 0; frame < static_cast<int>(stage->world->duration_s() * 140) - 2; ++frame) {
            const InertialReading reading = readings.next(frame);
            if (!reading.counts[3] || !reading.counts[4] || !reading.counts[5])
                continue;  // a frame of the stream that refreshes something else
            const double t_s = reading.sample / scenario.sample_rate_hz;
            for (size_t i = 0; i < 6; ++i)
                if (t_s > stage->stations[i].begin_s + 1 && t_s < stage->stations[i].end_s) {
                    const Vector3d raw(*reading.counts[3], *reading.counts[4], *reading.counts[5]);
                    sums[i] += accel.matrix * (raw - accel.zero_counts);
                    ++counts[i];
                }
        }
        for (size_t i = 0; i < 6; ++i) {
            ASSERT_GT(counts[i], 300);
            const double tolerance = (ideal ? 0 : 5 * 0.03) + 5 * kG * radians(0.05);
            EXPECT_LT((sums[i] / counts[i] - kG * allRigSides()[i].up()).norm(), tolerance) << scenario.name;
        }
    }
}

Result<Take> takeOf(const Stage& stage, const test::Folder& folder) {
    TakeRequest request;
    request.out_path = folder.file("rig.noctule");
    request.level = Level::kReadings;
    const auto written = writeTake(stage, request, {});
    return written ? Take::open(request.out_path) : Result<Take>(written.error());
}

TEST(RigTakes, AJigTakeHoldsThePlacementsAndItsRangesFit) {
    const test::Folder folder;
    StageRequest request = onRig(RigKind::kJig, Scenario::ideal());
    request.duration_s = 22;
    const auto stage = prepareStage(request);
    ASSERT_TRUE(stage) << stage.error().text();
    const auto take = takeOf(*stage, folder);
    ASSERT_TRUE(take);
    EXPECT_EQ(take->header().take_kind, "jig");
    const auto markers = *take->markers();
    ASSERT_EQ(markers.size(), 12u);
    const auto pulses = *take->pulses();
    std::map<int64_t, Pulse> pulse_of;
    for (const Pulse& pulse : pulses)
        pulse_of[pulse.id] = pulse;
    auto ranges = take->ranges(kPrimaryRun);
    ASSERT_TRUE(ranges);
    int compared = 0;
    while (true) {
        const auto next = ranges->next();
        ASSERT_TRUE(next);
        if (!*next)
            break;
        const RangeMeasurement& range = **next;
        for (size_t k = 0; k < 6; ++k) {
            const int64_t sample = range.pulse_sample;
            if (sample < markers[2 * k].sample || sample + 1200 > markers[2 * k + 1].sample)
                continue;
            const int placement = std::stoi(markers[2 * k].label) - 1;
            const double distance_m = (stage->rig->sourceIn(placement, range.source) -
                                       stage->rig->microphoneIn(placement, range.board))
                                          .norm();
            EXPECT_NEAR(range.distance_m, distance_m, 0.02) << "a speed of sound from a noisy thermometer";
            ++compared;
        }
    }
    EXPECT_GT(compared, 10'000);
}

TEST(RigTakes, ATurntableTakeNamesItsSpeedAndSides) {
    const test::Folder folder;
    const auto stage = prepareStage(onRig(RigKind::kTurntable, Scenario::nominal()));
    ASSERT_TRUE(stage);
    EXPECT_NEAR(stage->truthJson()["turntable"]["rpm"].get<double>(), 45, 45 * 5 * 0.0008);
    const auto take = takeOf(*stage, folder);
    ASSERT_TRUE(take);
    EXPECT_EQ(take->header().take_kind, "turntable");
    EXPECT_EQ(take->meta().at("turntable_rpm"), "45");
    const auto markers = *take->markers();
    ASSERT_EQ(markers.size(), 12u);
    EXPECT_EQ(markers[2].kind, "position");
    EXPECT_EQ(markers[2].label, "-y up");
    EXPECT_EQ(markers[3].label, "");
    StageRequest too_short = onRig(RigKind::kTurntable, Scenario::nominal());
    too_short.duration_s = 20;
    EXPECT_EQ(prepareStage(too_short).error().kind, ErrorKind::kUsage);
}

TEST(RigTakes, TheDigitizerIsAsGoodAsTheScenarioSays) {
    const RigWorld jig = makeRig(RigKind::kJig);
    std::istringstream csv(digitizerCsv(jig, defaultSuit(), 5e-5, 3));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "placement,kind,id,x_m,y_m,z_m");
    double sum2 = 0;
    int rows = 0;
    for (; std::getline(csv, line); ++rows) {
        int placement = 0;
        char kind[16], id[32];
        Vector3d found;
        ASSERT_EQ(std::sscanf(line.c_str(), "%d,%15[^,],%31[^,],%lf,%lf,%lf", &placement, kind, id,
                              &found.x(), &found.y(), &found.z()),
                  6)
            << line;
        const bool source = std::string(kind) == "source";
        const Vector3d truth = source ? jig.sourceIn(placement - 1, defaultSuit().findSource(id))
                                      : jig.microphoneIn(placement - 1, defaultSuit().findBoard(id));
        sum2 += (found - truth).squaredNorm();
    }
    EXPECT_EQ(rows, 6 * (8 + 18));
    EXPECT_NEAR(std::sqrt(sum2 / (3 * rows)), 5e-5, 0.7e-5);
}

TEST(PulseSchedule, OnlyEnabledSourcesPulseInTurn) {
    PulseSchedule schedule;
    EXPECT_EQ(schedule.pulse(9, 8).source, 1);
    schedule.enabled_sources = {{5, 2}};
    EXPECT_EQ(schedule.pulse(0, 8).source, 5);
    EXPECT_EQ(schedule.pulse(3, 8).source, 2);
    EXPECT_EQ(schedule.pulse(3, 8).sample, 3600);
    EXPECT_FALSE(schedule.isSilent(8));
    schedule.enabled_sources->clear();
    EXPECT_TRUE(schedule.isSilent(8));
}

}  // namespace
}  // namespace noctule::simulation
