// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/rest_pose/rest_pose_calibration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "core/report/calibration_documents.h"
#include "tests/core/calibration/standing_take.h"
#include "tests/support/fuzzing.h"

namespace noctule {
namespace {

using simulation::StageRequest;
using test::ObservedTake;

int64_t restTrials(int64_t few) {
    return test::countFromEnvironment("NOCTULE_CALIBRATION_TRIALS", few);
}

RestPoseReport restReport(const Observations& take, const RestPoseSettings& settings = {}) {
    auto report = calibrateRestPose(take, settings, {});
    EXPECT_TRUE(report);
    return report ? *report : RestPoseReport{};
}

/// Angle between the true up and the one that board, segment and pose give, per board.
std::vector<double> tiltErrors_rad(const ObservedTake& take, const RestPoseReport& report) {
    const GlobalPose global = globalPose(take.observations.actor.skeleton, report.pose);
    std::vector<double> errors;
    for (size_t b = 0; b < report.boards.size(); ++b) {
        const int joint = take.observations.actor.skeleton.find(take.observations.suit.boards[b].segment);
        const Quaterniond estimated =
            global.q_world_joint[static_cast<size_t>(joint)] * report.boards[b].q_segment_board;
        const Quaterniond truth = take.stage.body->boardMotion(static_cast<int>(b), 1.0).q_world_board;
        const Vector3d up_found = estimated.conjugate() * Vector3d::UnitY();
        const Vector3d up_true = truth.conjugate() * Vector3d::UnitY();
        errors.push_back(std::atan2(up_found.cross(up_true).norm(), up_found.dot(up_true)));
    }
    return errors;
}

std::string findingsText(const RestPoseReport& report) {
    std::string text;
    for (const Finding& finding : report.findings)
        text += finding.what + ". " + finding.remedy + ".\n";
    return text;
}

bool namesSwap(const RestPoseReport& report, int a, int b) {
    return report.swapped.size() == 1 && report.swapped.front().first == a &&
           report.swapped.front().second == b;
}

/// As far off as a suit may be put on: boards 10 degrees, the pose 5 degrees per freedom.
void putOnBadly(StageRequest& request) {
    request.scenario.initial_pose_rad = radians(5);
    test::turnBoards(request.suit, radians(10), request.seed);
}

TEST(RestPoseCalibration, BoardsFarOffAndAPoseFarOffStillPointUp) {
    const int64_t trials = restTrials(6);
    double worst_rad = 0;
    for (int64_t trial = 0; trial < trials; ++trial) {
        const auto take = test::standing(static_cast<uint64_t>(trial + 1), [](StageRequest& request) {
            putOnBadly(request);
            request.scenario.accel_bias_m_per_s2 = 0;  // is a tilt that nothing shows: see the next test
        });
        ASSERT_TRUE(take) << take.error().text();
        const RestPoseReport report = restReport(take->observations);
        for (const double error_rad : tiltErrors_rad(*take, report))
            worst_rad = std::max(worst_rad, error_rad);
        EXPECT_TRUE(report.converged);
        EXPECT_TRUE(report.swapped.empty()) << trial << " " << findingsText(report);
    }
    std::printf("largest error of up in %lld starts: %.3f degrees\n", static_cast<long long>(trials),
                degrees(worst_rad));
    EXPECT_LT(worst_rad, radians(0.5));
}

TEST(RestPoseCalibration, SigmasOfUpAndOfGyroscopesAreHonest) {
    const int64_t trials = restTrials(4);
    double up_square = 0, gyro_square = 0;
    int boards = 0, above = 0;
    for (int64_t trial = 0; trial < trials; ++trial) {
        const auto take = test::standing(static_cast<uint64_t>(trial + 500), putOnBadly);
        ASSERT_TRUE(take) << take.error().text();
        const RestPoseReport report = restReport(take->observations);
        const std::vector<double> errors_rad = tiltErrors_rad(*take, report);
        for (size_t b = 0; b < errors_rad.size(); ++b) {
            const BoardAtRest& board = report.boards[b];
            up_square += std::pow(errors_rad[b] / board.sigma_tilt_rad, 2) / 2;
            const simulation::ChipTruth& gyro = take->stage.truth.inertia[b].gyro;
            const Vector3d zero_counts =
                gyro.calibration.zero_counts + gyro.calibration.matrix.inverse() * gyro.bias;
            gyro_square +=
                ((board.gyro_zero_counts - zero_counts).array() / board.sigma_gyro_zero_counts.array())
                    .square()
                    .sum() /
                3;
            above += errors_rad[b] > radians(0.5);
            ++boards;
        }
    }
    std::printf(
        "squares of errors in sigma, per coordinate: up %.2f, gyroscopes' zeros %.2f; with the "
        "accelerometers' unknown bias %d of %d boards are more than 0.5 degrees off\n",
        up_square / boards, gyro_square / boards, above, boards);
    EXPECT_GT(up_square / boards, 0.5);
    EXPECT_LT(up_square / boards, 2.0);
    EXPECT_GT(gyro_square / boards, 0.1);
    EXPECT_LT(gyro_square / boards, 2.0);
}

bool isUntold(const RestPoseReport& report, int a, int b) {
    return std::ranges::any_of(
        report.untold, [&](const SwappedBoards& pair) { return pair.first == a && pair.second == b; });
}

/// Of random pairs in a suit that is put on badly.
int namedOf(int64_t trials, bool plugs) {
    int named = 0;
    for (int64_t trial = 0; trial < trials; ++trial) {
        const auto seed = static_cast<uint64_t>(trial + 1000);
        const auto pair = test::anyTwo(seed, 18);
        auto take = test::standing(seed, [&](StageRequest& request) {
            putOnBadly(request);
            if (!plugs)
                test::exchangePlaces(request.suit, pair.first, pair.second);
        });
        EXPECT_TRUE(take);
        if (plugs)
            test::exchangePlugs(take->observations, pair.first, pair.second);
        const RestPoseReport report = restReport(take->observations);
        const bool right = namesSwap(report, pair.first, pair.second) && report.swapped[0].plugs == plugs;
        if (!right)
            std::printf("%d and %d were exchanged:\n%s", pair.first + 1, pair.second + 1,
                        findingsText(report).c_str());
        named += right;
    }
    std::printf("%d of %lld pairs named\n", named, static_cast<long long>(trials));
    return named;
}

TEST(RestPoseCalibration, NamesTwoBoardsWornTheOneAsTheOther) {
    const int64_t trials = restTrials(5);
    EXPECT_EQ(namedOf(trials, false), trials);
}

TEST(RestPoseCalibration, NamesTwoBoardsPluggedInTheOneAsTheOther) {
    const int64_t trials = restTrials(3);
    EXPECT_EQ(namedOf(trials, true), trials);
}

/// Sound alone decides; where too little of it is heard the report says that nothing tells the two apart.
TEST(RestPoseCalibration, NamesLeftAndRightThatGravityCannotTell) {
    const int64_t trials = restTrials(1);
    int64_t named = 0;
    for (int64_t trial = 0; trial < trials; ++trial)
        for (const int left : {4, 8, 9, 10}) {
            const auto take = test::standing(static_cast<uint64_t>(trial + 2000), [&](StageRequest& request) {
                request.scenario.initial_pose_rad = radians(2);
                test::turnBoards(request.suit, radians(5), request.seed);
                test::exchangePlaces(request.suit, left, left + 7);
            });
            ASSERT_TRUE(take) << take.error().text();
            const RestPoseReport report = restReport(take->observations);
            const bool is_named = namesSwap(report, left, left + 7);
            named += is_named;
            EXPECT_TRUE(is_named || isUntold(report, left, left + 7)) << trial << ", " << left + 1 << "\n"
                                                                      << findingsText(report);
        }
    std::printf("%lld of %lld pairs named that only sound can tell, the others said to be untold\n",
                static_cast<long long>(named), static_cast<long long>(4 * trials));
    EXPECT_GE(named, 4 * trials * 4 / 5);
}

TEST(RestPoseCalibration, SaysWhichBoardsNothingTellsApart) {
    auto take = test::standing(5);
    ASSERT_TRUE(take) << take.error().text();
    take->observations.flights.clear();
    const RestPoseReport report = restReport(take->observations);
    EXPECT_TRUE(report.swapped.empty());
    EXPECT_TRUE(isUntold(report, 8, 15)) << findingsText(report);
    EXPECT_TRUE(isUntold(report, 9, 16)) << findingsText(report);
    EXPECT_TRUE(isUntold(report, 10, 17)) << findingsText(report);
    EXPECT_FALSE(isUntold(report, 4, 10)) << findingsText(report);
}

TEST(RestPoseCalibration, SwappedBoardsAreWorded) {
    auto take = test::standing(6, [](StageRequest& request) { test::exchangePlaces(request.suit, 6, 13); });
    ASSERT_TRUE(take) << take.error().text();
    const RestPoseReport report = restReport(take->observations);
    ASSERT_EQ(report.findings.size(), 1U) << findingsText(report);
    EXPECT_EQ(report.findings[0].what, "Boards 7 (left forearm) and 14 (right forearm) seem to be swapped");
    EXPECT_EQ(report.findings[0].part, "l_forearm");
    EXPECT_EQ(report.grade(), Grade::kNotUsable);
    EXPECT_FALSE(report.boards[6].measured);
    EXPECT_TRUE(report.boards[5].measured);
}

TEST(RestPoseCalibration, NamesWhatSitsElsewhere) {
    const auto take = test::standing(9, [](StageRequest& request) {
        request.suit.boards[5].p_segment_board_m.x() += 0.08;
        request.suit.sources[4].p_segment_source_m.y() += 0.09;
        Quaterniond& q_segment_board = request.suit.boards[8].q_segment_board;
        q_segment_board = q_segment_board * axisAngle(Vector3d::UnitY(), radians(35));
    });
    ASSERT_TRUE(take) << take.error().text();
    const RestPoseReport report = restReport(take->observations);
    std::set<std::string> parts;
    for (const Finding& finding : report.findings)
        parts.insert(finding.part);
    EXPECT_EQ(parts, (std::set<std::string>{"l_arm", "navel", "l_upleg"})) << findingsText(report);
    EXPECT_NEAR(degrees(report.boards[8].tilt_from_suit_rad), 35, 8);
}

TEST(RestPoseCalibration, AppliedReadingsAreAtRest) {
    const auto take = test::standing(12, putOnBadly);
    ASSERT_TRUE(take) << take.error().text();
    const Observations& seen = take->observations;
    const RestPoseReport report = restReport(seen);
    const Calibration applied = report.applied(seen.calibration, seen.suit);
    const GlobalPose global = globalPose(seen.actor.skeleton, report.pose);
    for (size_t b = 0; b < seen.boards.size(); ++b) {
        const BoardCalibration& board = *applied.findBoard(seen.suit.boards[b].id);
        ASSERT_TRUE(board.q_segment_board && board.gyro.sigma_zero_counts);
        const auto joint = static_cast<size_t>(seen.actor.skeleton.find(seen.suit.boards[b].segment));
        Vector3d velocity_m_per_s = Vector3d::Zero();
        Quaterniond q = global.q_world_joint[joint] * *board.q_segment_board;
        const auto& readings = seen.boards[b];
        for (size_t i = 1; i < readings.size(); ++i) {
            const double dt_s = readings[i].time_s - readings[i - 1].time_s;
            q = q * expQuaternion(board.gyro.apply(readings[i].gyro_counts) * dt_s);
            velocity_m_per_s +=
                (q * board.accel.apply(readings[i].accel_counts) - seen.g_m_per_s2 * Vector3d::UnitY()) *
                dt_s;
        }
        EXPECT_LT(velocity_m_per_s.norm(), 0.05) << seen.suit.boards[b].id << ", m/s after three seconds";
    }
}

TEST(RestPoseCalibration, AccelerometersWithoutCalibrationAreSaidToBeUnsure) {
    auto take = test::standing(13);
    ASSERT_TRUE(take) << take.error().text();
    Observations& seen = take->observations;
    const Calibration nominal = nominalCalibration(seen.suit);
    for (size_t b = 0; b < seen.calibration.boards.size(); ++b)
        seen.calibration.boards[b].accel = nominal.boards[b].accel;
    const RestPoseReport report = restReport(seen);
    EXPECT_NE(findingsText(report).find("Accelerometers are not calibrated"), std::string::npos)
        << findingsText(report);
    const std::vector<double> errors_rad = tiltErrors_rad(*take, report);
    double square = 0;
    for (size_t b = 0; b < errors_rad.size(); ++b)
        square += std::pow(errors_rad[b] / report.boards[b].sigma_tilt_rad, 2) / 2 / 18;
    EXPECT_LT(square, 2.0);
    EXPECT_GT(report.boards[0].sigma_tilt_rad, radians(8));
}

TEST(RestPoseCalibration, WithoutCalibratedGyroscopesItIsAsGoodAndSaysWhatItWasMadeWithout) {
    auto take = test::standing(13);
    ASSERT_TRUE(take) << take.error().text();
    Observations& seen = take->observations;
    const RestPoseReport with = restReport(seen);
    const std::string words = "Made before the gyroscopes were calibrated";
    EXPECT_EQ(findingsText(with).find(words), std::string::npos);
    const Calibration nominal = nominalCalibration(seen.suit);
    for (size_t b = 0; b < seen.calibration.boards.size(); ++b)
        seen.calibration.boards[b].gyro = nominal.boards[b].gyro;
    seen.calibration.sources.front().made["sources"] = {};
    const RestPoseReport without = restReport(seen);
    EXPECT_NE(findingsText(without).find(words), std::string::npos) << findingsText(without);
    EXPECT_EQ(without.grade(), with.grade()) << findingsText(without);
    for (size_t b = 0; b < with.boards.size(); ++b) {
        EXPECT_LT(angleBetween(without.boards[b].q_segment_board, with.boards[b].q_segment_board),
                  radians(0.01));
        EXPECT_LT((without.boards[b].gyro_zero_counts - with.boards[b].gyro_zero_counts).norm(), 0.01);
    }
}

TEST(RestPoseCalibration, WithoutDistancesItSaysWhatItDoesNotKnowAndWhatItServes) {
    auto take = test::standing(5);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(findingsText(restReport(take->observations)).find("suit's file"), std::string::npos);
    take->observations.flights.clear();
    const RestPoseReport report = restReport(take->observations);
    EXPECT_EQ(report.grade(), Grade::kUsable);
    for (const char* words : {"No distance was measured", "tilts and turns, not distances",
                              "headings (sigma 10°) and places are those of the suit's file"})
        EXPECT_NE(findingsText(report).find(words), std::string::npos) << findingsText(report);
    const CalibrationDocument document = documentOf(report);
    EXPECT_EQ(document.summary, "Boards aligned by gravity alone: 18 of 18");
    EXPECT_EQ(document.numbers[2].value, "10°");
    EXPECT_EQ(document.numbers[3].grade, Grade::kUsable) << "no distance is not good";
    take->observations.suit.sources.clear();
    const RestPoseReport without = restReport(take->observations);
    EXPECT_NE(findingsText(without).find("The suit has no sources"), std::string::npos);
    for (const Finding& finding : without.findings)
        EXPECT_EQ(finding.remedy.find("Calibrate the sources"), std::string::npos) << "it has none";
}

TEST(RestPoseCalibration, TiltsThatAreUnknownByTensOfDegreesAreNotUsable) {
    auto take = test::standing(13);
    ASSERT_TRUE(take) << take.error().text();
    Observations& seen = take->observations;
    const Calibration nominal = nominalCalibration(seen.suit);
    for (size_t b = 0; b < seen.calibration.boards.size(); ++b) {
        seen.calibration.boards[b].accel = nominal.boards[b].accel;
        for (CountReading& reading : seen.boards[b])  // a slope that nobody has calibrated
            reading.accel_counts =
                Vector3d::Constant(2048) + 1.5 * (reading.accel_counts - Vector3d::Constant(2048));
    }
    const RestPoseReport report = restReport(seen);
    EXPECT_GT(report.boards[0].sigma_tilt_rad, radians(20));
    EXPECT_EQ(report.grade(), Grade::kNotUsable) << findingsText(report);
}

TEST(RestPoseCalibration, MovementIsSeenAndTheStillPartUsed) {
    auto take = test::standing(14);
    ASSERT_TRUE(take) << take.error().text();
    Observations& seen = take->observations;
    for (CountReading& reading : seen.boards[6])
        if (reading.time_s > 1.1 && reading.time_s < 1.4)
            reading.gyro_counts.x() += 100 * std::sin(20 * reading.time_s);
    const RestPoseReport part = restReport(seen);
    ASSERT_EQ(part.findings.size(), 1U) << findingsText(part);
    EXPECT_EQ(part.findings[0].part, "l_forearm");
    EXPECT_GE(part.stretch.begin_s, 1.4);
    for (CountReading& reading : seen.boards[6])
        reading.gyro_counts.x() += 100 * std::sin(20 * reading.time_s);
    const RestPoseReport never = restReport(seen);
    EXPECT_EQ(never.grade(), Grade::kNotUsable);
    ASSERT_EQ(never.findings.size(), 1U);
    EXPECT_TRUE(never.findings[0].what.starts_with("Board 7, left forearm, moved at 0:"))
        << never.findings[0].what;
}

TEST(RestPoseCalibration, LooksForTheStillnessWhenNoRestIsMarked) {
    auto take = test::standing(15);
    ASSERT_TRUE(take) << take.error().text();
    take->observations.rest.reset();
    const RestPoseReport report = restReport(take->observations);
    EXPECT_FALSE(report.rest_marked);
    EXPECT_GT(report.stretch.end_s - report.stretch.begin_s, 2.5);
    ASSERT_EQ(report.findings.size(), 1U) << findingsText(report);
    EXPECT_EQ(report.grade(), Grade::kUsable);
}

TEST(RestPoseCalibration, BadInputIsAReport) {
    EXPECT_EQ(restReport({}).grade(), Grade::kNotUsable);
    auto take = test::standing(16);
    ASSERT_TRUE(take) << take.error().text();
    Observations& seen = take->observations;
    seen.boards[2].clear();
    seen.boards[3][50].clipped = true;
    seen.flights.push_back({1.0, 99, -4, 0.001, 1, 340});
    seen.flights.push_back({1.0, 1, 1, std::nan(""), 1, 340});
    const RestPoseReport report = restReport(seen);
    ASSERT_EQ(report.findings.size(), 2U) << findingsText(report);
    EXPECT_EQ(report.findings[0].part, "chest");
    EXPECT_EQ(report.findings[0].grade, Grade::kNotUsable) << "a board is missing";
    EXPECT_EQ(report.findings[1].part, "head");
    EXPECT_FALSE(report.boards[2].measured);
    EXPECT_FALSE(report.applied(seen.calibration, seen.suit).findBoard("chest")->q_segment_board);
    seen.boards.clear();
    EXPECT_EQ(restReport(seen).grade(), Grade::kNotUsable);
    seen.suit = {};
    EXPECT_EQ(restReport(seen).grade(), Grade::kNotUsable);
}

TEST(RestPoseCalibration, CanBeCancelled) {
    const auto take = test::standing(17);
    ASSERT_TRUE(take) << take.error().text();
    CancelFlag cancel;
    cancel.cancel();
    const auto report = calibrateRestPose(take->observations, {}, {nullptr, &cancel});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ErrorKind::kCancelled);
}

}  // namespace
}  // namespace noctule
