// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/gyroscope/gyroscope_calibration.h"

#include <gtest/gtest.h>

#include "core/body/text.h"
#include "core/simulation/inertial_sensor.h"
#include "tests/core/calibration/inertial_bench.h"
#include "tests/support/fuzzing.h"

namespace noctule {
namespace {

using simulation::Level;
using simulation::RigKind;

constexpr double kGyroZeroLimit_deg_per_s = 0.02, kGyroSlopeLimit = 0.0003;

/// Zero plus bias, in counts, as the board really had it, on the mean over the stretches: the sensor once
/// more, with the same walk of its bias but without noise. The rate is even in each.
Vector3d trueMeanZero(const test::ObservedTake& take, size_t b, const GyroscopeBoard& found) {
    const auto board = static_cast<int>(b);
    simulation::InertialTruth truth = take.stage.truth.inertia[b];
    truth.gyro.noise = 0;
    constexpr int64_t kWarmUpFrames = 140;
    const int rate_hz = take.stage.scenario.sample_rate_hz;
    simulation::InertialSensor sensor(*take.stage.world, board, truth, rate_hz, take.stage.truth.seed,
                                      simulation::BoardStream::kFirstFrame - kWarmUpFrames);
    Vector3d sum = Vector3d::Zero();
    int count = 0;
    for (const GyroscopeTurn& turn : found.turns) {
        const Vector3d rate =
            take.stage.world->boardMotion(board, (turn.begin_s + turn.end_s) / 2).gyro_rad_per_s;
        for (double time_s = 0; time_s < turn.end_s;) {
            time_s = sensor.sampleOf(sensor.nextFrame()) / rate_hz;
            const std::array<double, 6> counts = sensor.next();
            if (time_s < turn.begin_s)
                continue;
            sum += Vector3d(counts[0], counts[1], counts[2]) - truth.gyro.calibration.matrix.inverse() * rate;
            ++count;
        }
    }
    return sum / count;
}

struct GyroErrors {
    double mean_zero_deg_per_s = 0, first_zero_deg_per_s = 0, slope = 0, cross_rad = 0;
    double matrix_nees = 0, zero_nees = 0;
    int boards = 0;

    void add(const test::ObservedTake& take, const GyroscopeReport& report, size_t b) {
        const GyroscopeBoard& board = report.boards[b];
        const simulation::ChipTruth& truth = take.stage.truth.inertia[b].gyro;
        const Matrix3d& M = truth.calibration.matrix;
        const auto worse = [](double& worst, double value) { worst = std::max(worst, std::abs(value)); };
        const Vector3d off_mean = board.axes->zero_counts - trueMeanZero(take, b, board);
        const Vector3d off_first =
            board.axes->zero_counts - truth.calibration.zero_counts - M.inverse() * truth.bias;
        worse(mean_zero_deg_per_s, degrees((M * off_mean).cwiseAbs().maxCoeff()));
        worse(first_zero_deg_per_s, degrees((M * off_first).cwiseAbs().maxCoeff()));
        zero_nees += off_mean.cwiseQuotient(board.sigma_mean_zero_counts).squaredNorm() / 3;
        const Matrix3d off = board.axes->matrix - M;
        matrix_nees += off.cwiseQuotient(board.sigma_matrix).squaredNorm() / 9;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                worse(i == j ? slope : cross_rad, off(i, j) / M(j, j));
        ++boards;
    }
};

GyroErrors gyroErrorsOf(const test::ObservedTake& take, const GyroscopeReport& report) {
    GyroErrors errors;
    for (size_t b = 0; b < report.boards.size(); ++b)
        errors.add(take, report, b);
    return errors;
}

void expectWithinLimits(const GyroErrors& errors) {
    EXPECT_LT(errors.mean_zero_deg_per_s, kGyroZeroLimit_deg_per_s);
    EXPECT_LT(errors.slope, kGyroSlopeLimit);
}

double trueSpeed_rpm(const test::ObservedTake& take) {
    return take.stage.truthJson()["turntable"]["rpm"];
}

double tilt_deg(const test::ObservedTake& take) {
    const nlohmann::json axis = take.stage.truthJson()["turntable"]["axis_world"];
    return degrees(std::hypot(axis[0].get<double>(), axis[2].get<double>()));
}

/// The bias walks by 0.0002 rad/s in a second's root, 0.1 deg/s over the 80 s of a take, as much as five
/// times the limit: no solver can know the zero of one instant better than to the walk in between. So it is
/// judged by its mean over the turns, which it is.
TEST(GyroscopeCalibration, SixTurnsGiveZeroAndSlopeOfEveryBoard) {
    GyroErrors all;
    double speed_nees = 0;
    int64_t measured = 0;
    const int64_t trials = test::countFromEnvironment("NOCTULE_CALIBRATION_TRIALS", 2);
    for (int64_t seed = 1; seed <= trials; ++seed) {
        const auto take = test::observe(test::stageOf(RigKind::kTurntable, static_cast<uint64_t>(seed)));
        ASSERT_TRUE(take) << take.error().text();
        const GyroscopeReport report = calibrateGyroscopes({take->observations}, 0);
        ASSERT_EQ(report.boards.size(), 18U);
        if (!report.speed_measured) {  // the nominal speed's own 0.1 % counts: another test
            EXPECT_LT(tilt_deg(*take), 0.05) << "seed " << seed;
            std::printf("seed %d: the table is level to %.3f deg\n", static_cast<int>(seed), tilt_deg(*take));
            continue;
        }
        ++measured;
        for (const Finding& finding : report.findings)
            ADD_FAILURE() << "seed " << seed << ": " << finding.what;
        speed_nees += std::pow((report.rpm - trueSpeed_rpm(*take)) / report.sigma_rpm, 2);
        EXPECT_LT(std::abs(report.rpm / trueSpeed_rpm(*take) - 1), kGyroSlopeLimit) << "seed " << seed;
        EXPECT_NEAR(report.wander_rad_per_s_per_sqrt_s, 2e-4, 8e-5);
        for (size_t b = 0; b < 18; ++b) {
            ASSERT_TRUE(report.boards[b].axes) << report.boards[b].board.id;
            all.add(*take, report, b);
        }
        SCOPED_TRACE("seed " + std::to_string(seed));
        expectWithinLimits(all);
    }
    ASSERT_GE(10 * measured, 9 * trials);
    EXPECT_GT(all.matrix_nees / all.boards, 0.6) << "sigmas are as large as the errors";
    EXPECT_LT(all.matrix_nees / all.boards, 1.6);
    EXPECT_GT(all.zero_nees / all.boards, 0.6);
    EXPECT_LT(all.zero_nees / all.boards, 1.6);
    std::printf(
        "worst zero %.4f deg/s (of the first instant %.4f), slope %.4f %%, axes %.4f deg; mean squared "
        "error over sigma: zero %.2f, matrix %.2f, speed %.2f\n",
        all.mean_zero_deg_per_s, all.first_zero_deg_per_s, 100 * all.slope, degrees(all.cross_rad),
        all.zero_nees / all.boards, all.matrix_nees / all.boards, speed_nees / static_cast<double>(measured));
}

TEST(GyroscopeCalibration, AZeroThatStaysIsFoundForEveryInstant) {
    simulation::StageRequest request = test::benchRequest(RigKind::kTurntable, 3);
    request.scenario.gyro_bias_walk_rad_per_s_per_sqrt_s = 0;
    const auto take = test::mustObserve(request);
    const GyroscopeReport report = calibrateGyroscopes({take.observations}, 45);
    EXPECT_EQ(report.grade(), Grade::kGood);
    const GyroErrors errors = gyroErrorsOf(take, report);
    expectWithinLimits(errors);
    EXPECT_LT(errors.first_zero_deg_per_s, kGyroZeroLimit_deg_per_s);
}

TEST(GyroscopeCalibration, WorksFromSound) {
    const auto take = test::mustObserve(test::benchRequest(RigKind::kTurntable, 2), Level::kSignal);
    const GyroscopeReport report = calibrateGyroscopes({take.observations}, 0);
    EXPECT_EQ(report.grade(), Grade::kGood);
    expectWithinLimits(gyroErrorsOf(take, report));
}

TEST(GyroscopeCalibration, KnowsTheThreeSpeedsOfATable) {
    for (const double rpm : {100.0 / 3, 78.0}) {
        simulation::StageRequest request = test::benchRequest(RigKind::kTurntable, 3);
        request.scenario.rigs.turntable_rpm = rpm;
        auto take = test::mustObserve(request);
        take.observations.turntable_rpm = 0;
        const GyroscopeReport report = calibrateGyroscopes({take.observations}, 0);
        EXPECT_EQ(report.grade(), Grade::kGood);
        EXPECT_EQ(report.nominal_rpm, rpm);
        EXPECT_LT(std::abs(report.rpm / trueSpeed_rpm(take) - 1), 0.0003);
        expectWithinLimits(gyroErrorsOf(take, report));
        for (const GyroscopeBoard& board : report.boards) {
            ASSERT_EQ(board.turns.size(), 6U);
            for (size_t k = 0; k < 6; ++k)
                EXPECT_EQ(board.turns[k].up->name() + " up", take.stage.stations[k].label);
        }
    }
}

TEST(GyroscopeCalibration, RefusesASpeedThatTheTableDidNotHave) {
    const GyroscopeReport report = calibrateGyroscopes({test::tableTake().observations}, 33);
    EXPECT_EQ(test::onlyFinding(report.findings, "").what, "The table turned at about 45 rpm, not at 33 rpm");
    EXPECT_EQ(report.grade(), Grade::kNotUsable);
    EXPECT_FALSE(report.boards[0].axes);
}

TEST(GyroscopeCalibration, MeasuresATableThatIsFarOff) {
    const GyroscopeReport report = calibrateGyroscopes({test::tableTake().observations}, 45.9);
    EXPECT_LT(std::abs(report.rpm / trueSpeed_rpm(test::tableTake()) - 1), 0.0002);
    EXPECT_TRUE(test::onlyFinding(report.findings, "")
                    .what.starts_with("The table turned 1.9 % slower than 45.9 rpm"))
        << report.findings[0].what;
    expectWithinLimits(gyroErrorsOf(test::tableTake(), report));
}

TEST(GyroscopeCalibration, OnALevelTableTheNominalSpeedCounts) {
    simulation::StageRequest request = test::benchRequest(RigKind::kTurntable, 3);
    request.scenario.rigs.turntable_tilt_deg = 0;
    const auto take = test::mustObserve(request);
    const GyroscopeReport report = calibrateGyroscopes({take.observations}, 0);
    EXPECT_FALSE(report.speed_measured);
    EXPECT_EQ(report.rpm, 45);
    EXPECT_NEAR(report.sigma_rpm, 0.045, 1e-9);
    const Finding finding = test::onlyFinding(report.findings, "");
    EXPECT_EQ(finding.grade, Grade::kUsable);
    EXPECT_TRUE(finding.what.find("45 rpm counts") != std::string::npos) << finding.what;
    EXPECT_GT(report.boards[0].sigmaSlope(), 0.001);
    EXPECT_LT(gyroErrorsOf(take, report).slope, std::abs(trueSpeed_rpm(take) / 45 - 1) + kGyroSlopeLimit);
}

TEST(GyroscopeCalibration, TheSpeedOutlivesAGapInTheReadings) {
    Observations all = test::tableTake().observations;
    for (size_t b = 0; b < 3; ++b)
        test::removeReadings(all, b, {30, 30.6, ""});
    const GyroscopeReport report = calibrateGyroscopes({all}, 0);
    EXPECT_TRUE(report.speed_measured);
    EXPECT_LT(std::abs(report.rpm / trueSpeed_rpm(test::tableTake()) - 1), 0.0003);
}

TEST(GyroscopeCalibration, RestsInAnotherTakeDoNoHarm) {
    const GyroscopeReport report =
        calibrateGyroscopes({test::tableTake().observations, test::plateTake().observations}, 0);
    EXPECT_EQ(report.grade(), Grade::kGood);
    for (const GyroscopeBoard& board : report.boards) {
        EXPECT_EQ(board.turns.size(), 12U);
        EXPECT_EQ(std::ranges::count_if(board.turns, [](const auto& turn) { return !turn.about; }), 6);
    }
}

/// One of the takes that a wizard makes: a single turn.
Observations turnAlone(const std::string& side) {
    Observations all = test::tableTake().observations;
    const Stretch turn = test::whileUp(test::tableTake(), side);
    for (size_t b = 0; b < all.boards.size(); ++b) {
        test::removeReadings(all, b, {-1, turn.begin_s, ""});
        test::removeReadings(all, b, {turn.end_s, all.duration_s + 1, ""});
    }
    return all;
}

TEST(GyroscopeCalibration, TurnsThatAreTakesOfTheirOwnAreSurerWhenTheyWereTakenInOneSitting) {
    std::vector<std::string> sides{"+x", "-x", "+y", "-y", "+z", "-z"};
    std::ranges::sort(sides, {},
                      [](const std::string& side) { return test::whileUp(test::tableTake(), side).begin_s; });
    std::vector<Observations> takes;
    for (const std::string& side : sides)
        takes.push_back(turnAlone(side));
    for (Observations& take : takes)
        take.began_s = 1.8e9;
    const GyroscopeReport report = calibrateGyroscopes(takes, 45);
    expectWithinLimits(gyroErrorsOf(test::tableTake(), report));

    for (Observations& take : takes)
        take.began_s.reset();
    const GyroscopeReport apart = calibrateGyroscopes(takes, 45);
    for (size_t b = 0; b < apart.boards.size(); ++b)
        EXPECT_LT(report.boards[b].sigmaSlope(), 0.6 * apart.boards[b].sigmaSlope());
    const Finding finding = test::onlyFinding(apart.findings, "");
    const auto sigmaOf = [](const GyroscopeBoard& board) {
        return std::max(board.sigmaZero_rad_per_s() / GyroscopeLimits::kZero_rad_per_s,
                        board.sigmaSlope() / GyroscopeLimits::kSlope);
    };
    const auto worst = std::ranges::max_element(apart.boards, {}, sigmaOf) - apart.boards.begin();
    EXPECT_TRUE(finding.what.starts_with("The zeros and slopes of 3 boards are uncertain; worst is board " +
                                         std::to_string(worst + 1) + ", "))
        << finding.what;
    const double slope = apart.boards[static_cast<size_t>(worst)].sigmaSlope();
    EXPECT_TRUE(finding.what.ends_with(" and slope to " + text::number(100 * slope, 3) + " %"))
        << "as finely as the limit beside it: " << finding.what;
    EXPECT_EQ(finding.grade, Grade::kUsable);
    for (const Board& board : takes[0].suit.boards)
        EXPECT_TRUE(finding.concerns(board.id));
    EXPECT_FALSE(finding.concerns("somebody_else")) << "the others keep their grade";
}

TEST(GyroscopeCalibration, BoardsThatWereSwitchedOffBetweenTurnsAreToldSo) {
    std::vector<Observations> takes;
    for (const BoardSide side : kBoardSides)
        takes.push_back(turnAlone(side.name()));
    std::ranges::sort(takes, {}, [](const Observations& take) { return take.boards[0].front().time_s; });
    const auto calibratedOn = [&takes](std::optional<double> day_s) {
        for (Observations& take : takes)
            take.began_s = day_s;
        return calibrateGyroscopes(takes, 45);
    };
    const GyroscopeReport undated = calibratedOn(std::nullopt), all_on = calibratedOn(1.8e9);
    for (size_t k = 3; k < takes.size(); ++k)
        for (size_t b = 0; b < 2; ++b)
            test::changeReadings(takes[k], b, {0, takes[k].duration_s, ""},
                                 [](CountReading& reading) { reading.gyro_counts += Vector3d(2, -3, 2); });
    const GyroscopeReport report = calibrateGyroscopes(takes, 45);
    const auto told = std::ranges::find_if(report.findings, [](const Finding& finding) {
        return finding.remedy.starts_with("Leave box and boards switched on");
    });
    ASSERT_NE(told, report.findings.end());
    EXPECT_EQ(told->parts, (std::vector{takes[0].suit.boards[0].id, takes[0].suit.boards[1].id}))
        << "the third stayed on";
    EXPECT_NEAR(report.boards[0].sigmaSlope() / undated.boards[0].sigmaSlope(), 1, 0.02);
    EXPECT_NEAR(report.boards[2].sigmaSlope() / all_on.boards[2].sigmaSlope(), 1, 0.02);
    EXPECT_GT(undated.boards[0].sigmaSlope(), 1.5 * all_on.boards[0].sigmaSlope());
    EXPECT_NEAR(report.wander_rad_per_s_per_sqrt_s / all_on.wander_rad_per_s_per_sqrt_s, 1, 0.1);
}

GyroscopeReport withoutTurns(const std::vector<std::string>& sides) {
    Observations all = test::tableTake().observations;
    for (const std::string& side : sides)
        test::removeReadings(all, 1, test::whileUp(test::tableTake(), side));
    return calibrateGyroscopes({all}, 0);
}

TEST(GyroscopeCalibration, NamesTheTurnThatIsMissing) {
    const std::string id = test::tableTake().observations.suit.boards[1].id;
    const GyroscopeReport one_way = withoutTurns({"-x"});
    const Finding finding = test::onlyFinding(one_way.findings, id);
    EXPECT_EQ(finding.what,
              "board 2, abdomen: turned about its x axis in one direction only, with its +x side up");
    EXPECT_EQ(finding.remedy, "Turn it with its -x side up as well, the table turning as before");
    EXPECT_EQ(finding.grade, Grade::kNotUsable);
    EXPECT_FALSE(one_way.boards[1].axes);
    EXPECT_TRUE(one_way.boards[0].axes && one_way.boards[2].axes);

    const GyroscopeReport no_axis = withoutTurns({"+z", "-z"});
    EXPECT_EQ(test::onlyFinding(no_axis.findings, id).what,
              "board 2, abdomen: was never turned evenly about its z axis");

    const Calibration base = nominalCalibration(test::tableTake().observations.suit),
                      applied = one_way.applied(base);
    EXPECT_EQ(applied.boards[1].gyro.matrix, base.boards[1].gyro.matrix);
    EXPECT_EQ(applied.boards[0].gyro.zero_counts, one_way.boards[0].axes->zero_counts);
    EXPECT_TRUE(applied.boards[0].gyro.sigma_zero_counts);
    EXPECT_EQ(one_way.applied({}).boards.size(), 2U);
}

TEST(GyroscopeCalibration, NoticesATableThatWasReversed) {
    const test::ObservedTake& take = test::tableTake();
    Observations all = take.observations;
    const Vector3d zero = take.stage.truth.inertia[1].gyro.calibration.zero_counts;
    test::changeReadings(all, 1, test::whileUp(take, "-y"), [&](CountReading& reading) {
        reading.gyro_counts = (2 * zero - reading.gyro_counts).array().round();
    });
    const Finding finding = test::onlyFinding(calibrateGyroscopes({all}, 0).findings, all.suit.boards[1].id);
    EXPECT_EQ(finding.remedy, "Repeat both sides with the table turning one way");
}

TEST(GyroscopeCalibration, RefusesATableThatIsTooFast) {
    Observations all = test::tableTake().observations;
    all.suit.boards[2].gyro_full_scale_rad_per_s = 5.8;
    const Finding finding = test::onlyFinding(calibrateGyroscopes({all}, 45).findings, all.suit.boards[2].id);
    EXPECT_EQ(finding.what, "board 3, chest: 45 rpm is more than 80 % of its gyroscope's range of 332 °/s");
    EXPECT_EQ(finding.grade, Grade::kNotUsable);
}

TEST(GyroscopeCalibration, LeavesOutClippedTurns) {
    Observations all = test::tableTake().observations;
    test::changeReadings(all, 0, test::whileUp(test::tableTake(), "+y"), [](CountReading& reading) {
        reading.gyro_counts.y() = 4095;
        reading.clipped = true;
    });
    const GyroscopeReport report = calibrateGyroscopes({all}, 45);
    ASSERT_EQ(report.findings.size(), 2U);
    EXPECT_EQ(report.findings[0].what,
              "board 1, pelvis: its gyroscope reached the end of its range in a turn, which was left out");
    EXPECT_EQ(report.findings[1].what,
              "board 1, pelvis: turned about its y axis in one direction only, with its -y side up");
}

TEST(GyroscopeCalibration, MissesABoardThatIsUnplugged) {
    Observations all = test::tableTake().observations;
    all.boards[1].clear();
    const GyroscopeReport report = calibrateGyroscopes({all}, 0);
    EXPECT_EQ(test::onlyFinding(report.findings, all.suit.boards[1].id).what,
              "board 2, abdomen: sent no readings");
    EXPECT_TRUE(report.speed_measured);
    all.boards.clear();
    EXPECT_EQ(calibrateGyroscopes({all}, 0).findings.size(), 3U);
    EXPECT_TRUE(calibrateGyroscopes({}, 0).boards.empty());
}

TEST(GyroscopeCalibration, SurvivesReadingsWithoutSense) {
    for (uint64_t seed = 1; seed <= 30; ++seed) {
        const GyroscopeReport report = calibrateGyroscopes({test::garbageTake(test::tableTake(), seed)}, 0);
        EXPECT_EQ(report.grade(), Grade::kNotUsable) << seed;
        for (const GyroscopeBoard& board : report.boards)
            EXPECT_FALSE(board.axes) << seed;
    }
}

}  // namespace
}  // namespace noctule
