// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/accelerometer/accelerometer_calibration.h"

#include <gtest/gtest.h>

#include "core/calibration/accelerometer/accelerometer_fit.h"
#include "tests/core/calibration/inertial_bench.h"
#include "tests/support/fuzzing.h"

namespace noctule {
namespace {

using simulation::Level;
using simulation::RigKind;

struct AccelErrors {
    double zero_m_per_s2 = 0, slope = 0, cross_rad = 0, nees = 0;
    int values = 0;

    void add(const AccelErrors& other) {
        zero_m_per_s2 = std::max(zero_m_per_s2, other.zero_m_per_s2);
        slope = std::max(slope, other.slope);
        cross_rad = std::max(cross_rad, other.cross_rad);
        nees += other.nees;
        values += other.values;
    }
};

constexpr double kZeroLimit_m_per_s2 = 0.005 * kStandardGravity_m_per_s2, kSlopeLimit = 0.001;

/// The bias is constant and belongs to the zero: counts = zero + matrix^-1 (value + bias).
AccelErrors errorsOf(const AccelerometerReport& report, const simulation::Stage& stage) {
    AccelErrors errors;
    for (size_t b = 0; b < report.boards.size(); ++b) {
        const AccelerometerBoard& board = report.boards[b];
        const simulation::ChipTruth& truth = stage.truth.inertia[b].accel;
        const Matrix3d& M = truth.calibration.matrix;
        const Vector3d zero = truth.calibration.zero_counts + M.inverse() * truth.bias;
        const Vector3d off_counts = board.axes->zero_counts - zero;
        const Matrix3d off = board.axes->matrix - M;
        AccelErrors found;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                double& worst = i == j ? found.slope : found.cross_rad;
                worst = std::max(worst, std::abs(off(i, j) / M(j, j)));
                found.nees += std::pow(off(i, j) / board.sigma_matrix(i, j), 2);
            }
        found.zero_m_per_s2 = (M * off_counts).cwiseAbs().maxCoeff();
        found.nees += off_counts.cwiseQuotient(*board.axes->sigma_zero_counts).squaredNorm();
        found.values = 12;
        errors.add(found);
    }
    return errors;
}

TEST(AccelerometerCalibration, SixLevelSidesGiveZeroAndSlopeOfEveryBoard) {
    AccelErrors all;
    const int64_t trials = test::countFromEnvironment("NOCTULE_CALIBRATION_TRIALS", 2);
    for (int64_t seed = 1; seed <= trials; ++seed) {
        const auto take = test::observe(test::stageOf(RigKind::kLevelPlate, static_cast<uint64_t>(seed)));
        ASSERT_TRUE(take) << take.error().text();
        const AccelerometerReport report = calibrateAccelerometers({take->observations});
        ASSERT_EQ(report.boards.size(), 18U);
        for (const Finding& finding : report.findings)
            ADD_FAILURE() << "seed " << seed << ": " << finding.what;
        for (const AccelerometerBoard& board : report.boards)
            ASSERT_TRUE(board.axes) << board.board.id;
        const AccelErrors errors = errorsOf(report, take->stage);
        EXPECT_LT(errors.zero_m_per_s2, kZeroLimit_m_per_s2) << "seed " << seed;
        EXPECT_LT(errors.slope, kSlopeLimit) << "seed " << seed;
        EXPECT_LT(errors.cross_rad, radians(0.2)) << "seed " << seed;
        all.add(errors);
    }
    EXPECT_GT(all.nees / all.values, 0.6) << "sigmas are as large as the errors";
    EXPECT_LT(all.nees / all.values, 1.6);
    std::printf("worst zero %.2f mg, slope %.4f %%, axes %.3f deg; mean squared error over sigma %.2f\n",
                1000 * all.zero_m_per_s2 / kStandardGravity_m_per_s2, 100 * all.slope, degrees(all.cross_rad),
                all.nees / all.values);
}

AccelerometerReport calibrateOne(const Observations& take) {
    return calibrateAccelerometers({take});
}

/// Degrees by which the axes are not as square as they should be: what no rotation of the board explains.
double skew_deg(const AccelerometerBoard& board, const simulation::ChipTruth& truth) {
    const Matrix3d off = board.axes->matrix * truth.calibration.matrix.inverse() - Matrix3d::Identity();
    const Matrix3d both = (off + off.transpose()) / 2;
    return degrees(std::max({std::abs(both(0, 1)), std::abs(both(0, 2)), std::abs(both(1, 2))}));
}

TEST(AccelerometerCalibration, WorksFromSound) {
    const auto take = test::mustObserve(test::benchRequest(RigKind::kLevelPlate, 2), Level::kSignal);
    const AccelerometerReport report = calibrateOne(take.observations);
    EXPECT_EQ(report.grade(), Grade::kGood);
    const AccelErrors errors = errorsOf(report, take.stage);
    EXPECT_LT(errors.zero_m_per_s2, kZeroLimit_m_per_s2);
    EXPECT_LT(errors.slope, kSlopeLimit);
}

TEST(AccelerometerCalibration, PositionsKnowTheirSidesAndReadGravity) {
    const AccelerometerReport report = calibrateOne(test::plateTake().observations);
    for (const AccelerometerBoard& board : report.boards) {
        ASSERT_EQ(board.positions.size(), 6U);
        for (size_t k = 0; k < 6; ++k) {
            ASSERT_TRUE(board.positions[k].side);
            EXPECT_EQ(board.positions[k].side->name() + " up", test::plateTake().stage.stations[k].label);
            EXPECT_LT(std::abs(board.positions[k].residual_m_per_s2), 0.01);
            EXPECT_LT(degrees(board.positions[k].off_level_rad), 0.3);
        }
    }
}

TEST(AccelerometerCalibration, TiltedPositionsSquareTheAxes) {
    const test::ObservedTake& plate = test::plateTake();
    const Observations tilted = test::tiltedTake(plate, test::tiltedDirections());
    const AccelerometerReport six = calibrateOne(plate.observations),
                              all = calibrateAccelerometers({plate.observations, tilted});
    EXPECT_EQ(all.grade(), Grade::kGood);
    double worst_six = 0, worst_all = 0;
    for (size_t b = 0; b < all.boards.size(); ++b) {
        ASSERT_EQ(all.boards[b].positions.size(), 18U);
        EXPECT_LT(all.boards[b].sigma_matrix(0, 1), six.boards[b].sigma_matrix(0, 1));
        worst_six = std::max(worst_six, skew_deg(six.boards[b], plate.stage.truth.inertia[b].accel));
        worst_all = std::max(worst_all, skew_deg(all.boards[b], plate.stage.truth.inertia[b].accel));
    }
    EXPECT_LT(worst_all, 0.02);
    EXPECT_LT(worst_all, worst_six);
    const AccelErrors errors = errorsOf(all, plate.stage);
    EXPECT_LT(errors.zero_m_per_s2, kZeroLimit_m_per_s2);
    EXPECT_LT(errors.slope, kSlopeLimit);
}

TEST(AccelerometerFit, IsExactWithoutNoise) {
    AxisCalibration truth = AxisCalibration::nominal(156.9064);
    truth.zero_counts = {2100, 1990, 2030};
    Matrix3d errors;
    errors << 1.02, 0.01, -0.008, -0.012, 0.99, 0.004, 0.009, -0.006, 1.013;
    truth.matrix = truth.matrix * errors;
    std::vector<StillPosition> positions;
    const auto add = [&](const Vector3d& up, std::optional<BoardSide> side) {
        const Vector3d accel = up.normalized() * kStandardGravity_m_per_s2;
        positions.push_back({{truth.zero_counts + truth.matrix.inverse() * accel, Vector3d::Constant(0.01)},
                             kStandardGravity_m_per_s2,
                             side,
                             radians(0.05)});
    };
    for (const BoardSide side : kBoardSides)
        add(side.up(), side);
    for (const Vector3d& up : test::tiltedDirections())
        add(up, std::nullopt);
    const AccelerometerFit fit = fitAccelerometer(positions, AxisCalibration::nominal(156.9064));
    EXPECT_TRUE(fit.converged);
    EXPECT_LT(fit.iterations, 10);
    // The start has its say: by (0.025 / 2)^2 of what is off.
    EXPECT_LT((truth.matrix * (fit.axes.zero_counts - truth.zero_counts)).norm(), 1e-4);
    EXPECT_LT((fit.axes.matrix - truth.matrix).norm() / truth.matrix(0, 0), 1e-5);
}

TEST(AccelerometerCalibration, EachBoardMayLieInItsOwnWay) {
    Observations all = test::plateTake().observations;
    for (CountReading& reading : all.boards[1])
        for (Vector3d* counts : {&reading.gyro_counts, &reading.accel_counts})
            *counts = Vector3d(counts->y(), counts->z(), counts->x());
    const AccelerometerReport report = calibrateOne(all),
                              plain = calibrateOne(test::plateTake().observations);
    EXPECT_EQ(report.grade(), Grade::kGood);
    const Vector3d zero = plain.boards[1].axes->zero_counts;
    EXPECT_LT((report.boards[1].axes->zero_counts - Vector3d(zero.y(), zero.z(), zero.x())).norm(), 1e-3);
}

TEST(AccelerometerCalibration, TakesAreMergedByTheNamesOfTheirBoards) {
    Observations first = test::plateTake().observations, second = first;
    const double middle_s = first.duration_s / 2;
    for (size_t b = 0; b < 3; ++b) {
        test::removeReadings(first, b, {middle_s, 1e9, ""});
        test::removeReadings(second, b, {0, middle_s, ""});
    }
    std::ranges::reverse(second.suit.boards);
    std::ranges::reverse(second.boards);
    const AccelerometerReport parts = calibrateAccelerometers({first, second}),
                              whole = calibrateOne(test::plateTake().observations);
    ASSERT_EQ(parts.boards.size(), 3U);
    for (size_t b = 0; b < 3; ++b) {
        ASSERT_TRUE(parts.boards[b].axes);
        EXPECT_EQ(parts.boards[b].board.id, first.suit.boards[b].id);
        EXPECT_LT((parts.boards[b].axes->zero_counts - whole.boards[b].axes->zero_counts).norm(), 0.1);
    }
}

TEST(AccelerometerCalibration, NamesTheSideThatIsMissing) {
    Observations all = test::plateTake().observations;
    test::removeReadings(all, 1, test::whileUp(test::plateTake(), "+x"));
    const AccelerometerReport report = calibrateOne(all);
    const Finding finding = test::onlyFinding(report.findings, all.suit.boards[1].id);
    EXPECT_EQ(finding.what, "board 2, abdomen: never lay still with its +x side up");
    EXPECT_EQ(finding.grade, Grade::kNotUsable);
    EXPECT_FALSE(report.boards[1].axes);
    EXPECT_TRUE(report.boards[0].axes && report.boards[2].axes);
    EXPECT_EQ(report.findings.size(), 1U);

    const Calibration base = nominalCalibration(all.suit), applied = report.applied(base);
    EXPECT_EQ(applied.boards[1].accel.matrix, base.boards[1].accel.matrix);
    EXPECT_EQ(applied.boards[1].accel.sigma_zero_counts, std::nullopt);
    EXPECT_EQ(applied.boards[2].accel.zero_counts, report.boards[2].axes->zero_counts);
    EXPECT_TRUE(applied.boards[2].accel.sigma_zero_counts);
    EXPECT_EQ(applied.boards[2].gyro.matrix, base.boards[2].gyro.matrix);
}

TEST(AccelerometerCalibration, ManyTiltedPositionsMakeUpForAMissingSide) {
    Observations all = test::plateTake().observations;
    test::removeReadings(all, 1, test::whileUp(test::plateTake(), "+x"));
    const AccelerometerReport report =
        calibrateAccelerometers({all, test::tiltedTake(test::plateTake(), test::tiltedDirections())});
    EXPECT_EQ(test::onlyFinding(report.findings, all.suit.boards[1].id).grade, Grade::kUsable);
    ASSERT_TRUE(report.boards[1].axes);
    const AccelErrors errors = errorsOf(report, test::plateTake().stage);
    EXPECT_LT(errors.zero_m_per_s2, kZeroLimit_m_per_s2);
    EXPECT_LT(errors.slope, kSlopeLimit);
}

TEST(AccelerometerCalibration, FewPositionsAreNotEnough) {
    Observations all = test::plateTake().observations;
    test::removeReadings(all, 0, {9, 1e9, ""});
    const AccelerometerReport report = calibrateOne(all);
    EXPECT_EQ(test::onlyFinding(report.findings, all.suit.boards[0].id).what,
              "board 1, pelvis: six sides are needed, but it lay still 2 times");
    EXPECT_FALSE(report.boards[0].axes);
}

TEST(AccelerometerCalibration, SaysThatABoardWasMoved) {
    const test::ObservedTake& take = test::plateTake();
    Observations shaken = take.observations;
    for (double into_s = 0.5; into_s < 5; into_s += 1.2) {
        const Stretch side = test::whileUp(take, "-z");
        test::changeReadings(shaken, 2, {side.begin_s + into_s, side.begin_s + into_s + 0.1, ""},
                             [](CountReading& reading) { reading.gyro_counts.x() += 60; });
    }
    const Finding finding = test::onlyFinding(calibrateOne(shaken).findings, shaken.suit.boards[2].id);
    EXPECT_TRUE(
        finding.what.starts_with("board 3, chest: was moved while its -z side was up, it lay still for 0."))
        << finding.what;

    Observations creeping = take.observations;
    test::changeAcceleration(take, creeping, 2, test::whileUp(take, "-z"),
                             [](const Vector3d& accel, double t_s) {
                                 return Eigen::AngleAxisd(radians(0.3) * t_s, Vector3d::UnitX()) * accel;
                             });
    EXPECT_TRUE(test::onlyFinding(calibrateOne(creeping).findings, creeping.suit.boards[2].id)
                    .what.starts_with("board 3, chest: was moved while its -z side was up"));
}

Observations askew(const test::ObservedTake& take, double angle_deg) {
    Observations all = take.observations;
    test::changeAcceleration(take, all, 0, test::whileUp(take, "+x"), [&](const Vector3d& accel, double) {
        return Eigen::AngleAxisd(radians(angle_deg), Vector3d(0, 1, 1).normalized()) * accel;
    });
    return all;
}

TEST(AccelerometerCalibration, SixSidesTellThatTwoAreNotOpposite) {
    const Observations all = askew(test::plateTake(), 3);
    const AccelerometerReport report = calibrateOne(all);
    const Finding finding = test::onlyFinding(report.findings, all.suit.boards[0].id);
    EXPECT_EQ(finding.grade, Grade::kUsable);
    EXPECT_TRUE(finding.what.starts_with("board 1, pelvis: its +x and -x sides are ")) << finding.what;
    EXPECT_NEAR(degrees(report.boards[0].positions[2].off_level_rad), 3, 0.25);
    const AccelErrors errors = errorsOf(report, test::plateTake().stage);
    EXPECT_LT(errors.zero_m_per_s2, kZeroLimit_m_per_s2) << "gravity is as long as ever";
    EXPECT_LT(errors.slope, kSlopeLimit);
}

TEST(AccelerometerCalibration, TiltedPositionsTellWhichSideWasAskew) {
    const Observations all = askew(test::plateTake(), 3);
    const AccelerometerReport report =
        calibrateAccelerometers({all, test::tiltedTake(test::plateTake(), test::tiltedDirections())});
    const Finding finding = test::onlyFinding(report.findings, all.suit.boards[0].id);
    EXPECT_TRUE(finding.what.starts_with("board 1, pelvis: lay ")) << finding.what;
    EXPECT_TRUE(finding.what.ends_with("° askew with its +x side up")) << finding.what;
}

TEST(AccelerometerCalibration, LeavesOutClippedReadings) {
    Observations all = test::plateTake().observations;
    test::changeReadings(all, 1, test::whileUp(test::plateTake(), "+y"), [](CountReading& reading) {
        reading.accel_counts.y() = 4095;
        reading.clipped = true;
    });
    const AccelerometerReport report = calibrateOne(all);
    ASSERT_EQ(report.findings.size(), 2U);
    EXPECT_EQ(report.findings[0].what,
              "board 2, abdomen: its accelerometer reached the end of its range while it lay still");
    EXPECT_EQ(report.findings[1].what, "board 2, abdomen: never lay still with its +y side up");
    EXPECT_FALSE(report.boards[1].axes);
}

TEST(AccelerometerCalibration, MissesABoardThatIsUnplugged) {
    Observations all = test::plateTake().observations;
    all.boards[1].clear();
    const AccelerometerReport report = calibrateOne(all);
    EXPECT_EQ(test::onlyFinding(report.findings, all.suit.boards[1].id).what,
              "board 2, abdomen: sent no readings");
    EXPECT_EQ(report.findings.size(), 1U);
    EXPECT_FALSE(report.boards[1].axes);
    EXPECT_EQ(report.grade(), Grade::kNotUsable);
    all.boards.clear();
    EXPECT_EQ(calibrateOne(all).findings.size(), 3U);
    EXPECT_TRUE(calibrateAccelerometers({}).boards.empty());
}

TEST(AccelerometerCalibration, SurvivesReadingsWithoutSense) {
    for (uint64_t seed = 1; seed <= 30; ++seed) {
        const AccelerometerReport report = calibrateOne(test::garbageTake(test::plateTake(), seed));
        EXPECT_EQ(report.grade(), Grade::kNotUsable) << seed;
        for (const AccelerometerBoard& board : report.boards)
            EXPECT_FALSE(board.axes) << seed;
    }
}

}  // namespace
}  // namespace noctule
