// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/rest_pose/still_check.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "core/calibration/rest_pose/rest_pose_calibration.h"
#include "tests/core/calibration/standing_take.h"
#include "tests/support/fuzzing.h"

namespace noctule {
namespace {

using simulation::StageRequest;
using test::ObservedTake;

constexpr double kHeldDifferently_rad = radians(2), kStraps_rad = radians(5);

/// The same suit on the same person, who stands a little differently each time; calibrated the first time.
class CalibratedPerson {
public:
    explicit CalibratedPerson(uint64_t seed) : seed_(seed) {
        const auto take = stand(0);
        EXPECT_TRUE(take);
        const auto report = calibrateRestPose(take->observations, {}, {});
        EXPECT_TRUE(report);
        calibration_ = report->applied(take->observations.calibration, take->observations.suit);
    }

    Result<ObservedTake> stand(uint64_t time, const std::function<void(Suit&)>& change = {}) const {
        auto take = test::standing(seed_, [&](StageRequest& request) {
            request.scenario.mounting_m = 0.005;
            test::turnBoards(request.suit, kStraps_rad, seed_);
            Actor actor = defaultActor();
            simulation::Random random(seed_, "stands", time);
            for (int j = 1; j < actor.skeleton.size(); ++j) {
                Quaterniond& q = actor.rest_q_parent_joint[static_cast<size_t>(j)];
                const Joint& joint = actor.skeleton.joint(j);
                Eigen::VectorXd angles = projectOntoJoint(joint, q, false).angles_rad;
                for (double& angle : angles)
                    angle += random.gaussian(kHeldDifferently_rad);
                q = rotationFromAngles(joint, angles);
            }
            request.actor = actor;
            if (change)
                change(request.suit);
        });
        if (take && !calibration_.boards.empty())
            take->observations.calibration = calibration_;
        return take;
    }

    /// Turns a board by the angle about a horizontal axis of the rest pose.
    void tilt(Suit& suit, size_t board, double angle_rad) const {
        const Actor actor = defaultActor();
        const GlobalPose rest = globalPose(actor.skeleton, actor.restPose());
        Board& worn = suit.boards[board];
        const Quaterniond q_world_segment =
            rest.q_world_joint[static_cast<size_t>(actor.skeleton.find(worn.segment))];
        simulation::Random random(seed_, "slip", board);
        const double heading = random.uniform(0, 2 * std::numbers::pi);
        const Quaterniond turn = axisAngle({std::cos(heading), 0, std::sin(heading)}, angle_rad);
        worn.q_segment_board = q_world_segment.conjugate() * turn * q_world_segment * worn.q_segment_board;
    }

private:
    uint64_t seed_;
    Calibration calibration_;
};

std::string wordsOf(const StillCheckReport& report) {
    std::string text;
    for (const Finding& finding : report.findings)
        text += finding.what + ". " + finding.remedy + ".\n";
    return text;
}

TEST(StillCheck, NamesNoBoardWhenOnlyThePoseIsHeldDifferently) {
    const int64_t trials = test::countFromEnvironment("NOCTULE_CALIBRATION_TRIALS", 3);
    double worst_rad = 0;
    for (int64_t trial = 0; trial < trials; ++trial) {
        const CalibratedPerson person(static_cast<uint64_t>(trial + 1));
        const auto take = person.stand(1);
        ASSERT_TRUE(take) << take.error().text();
        const StillCheckReport report = checkStill(take->observations);
        EXPECT_EQ(report.grade(), Grade::kGood) << "person " << trial << "\n" << wordsOf(report);
        for (const BoardStillCheck& board : report.boards)
            worst_rad = std::max(worst_rad, board.tilt_change_rad);
    }
    std::printf("largest tilt of %lld people who changed nothing: %.1f degrees\n",
                static_cast<long long>(trials), degrees(worst_rad));
}

TEST(StillCheck, NamesTheStrapThatSlippedAndNoOther) {
    const int64_t persons = test::countFromEnvironment("NOCTULE_CALIBRATION_TRIALS", 1);
    int named = 0, others = 0, slips = 0;
    for (int64_t p = 0; p < persons; ++p) {
        const CalibratedPerson person(static_cast<uint64_t>(p + 100));
        for (size_t board = static_cast<size_t>(p % 2); board < 18; board += 2) {
            const double angle_rad = radians(10 + 10.0 * static_cast<double>(board) / 17);
            const auto take = person.stand(1, [&](Suit& suit) { person.tilt(suit, board, angle_rad); });
            ASSERT_TRUE(take) << take.error().text();
            const StillCheckReport report = checkStill(take->observations);
            ++slips;
            for (size_t b = 0; b < report.boards.size(); ++b)
                (b == board ? named : others) += report.boards[b].slipped;
        }
    }
    std::printf("%d of %d slipped straps named, and %d others\n", named, slips, others);
    EXPECT_GE(50 * named, 49 * slips) << "the pose may take up what a strap did, but seldom";
    EXPECT_EQ(others, 0);
}

TEST(StillCheck, SpeaksToTheOperator) {
    const CalibratedPerson person(7);
    const auto take = person.stand(1, [&](Suit& suit) { person.tilt(suit, 6, radians(15)); });
    ASSERT_TRUE(take) << take.error().text();
    const StillCheckReport report = checkStill(take->observations);
    ASSERT_EQ(report.findings.size(), 1U) << wordsOf(report);
    EXPECT_TRUE(
        report.findings[0].what.starts_with("The strap of board 7, left forearm, has slipped by about "))
        << report.findings[0].what;
    EXPECT_EQ(report.findings[0].part, "l_forearm");
    EXPECT_EQ(report.grade(), Grade::kNotUsable);
}

TEST(StillCheck, SeesAGyroscopesZeroMove) {
    const CalibratedPerson person(8);
    auto take = person.stand(1);
    ASSERT_TRUE(take) << take.error().text();
    for (CountReading& reading : take->observations.boards[3])
        reading.gyro_counts.y() += 5;  // 2.4 degrees a second
    const StillCheckReport report = checkStill(take->observations);
    ASSERT_EQ(report.findings.size(), 1U) << wordsOf(report);
    EXPECT_EQ(report.findings[0].what, "The gyroscope of board 4, head, has drifted by about 2°/s");
    EXPECT_NEAR(report.boards[3].gyro_change_rad_per_s.norm(), radians(2.44), radians(0.4));
}

TEST(StillCheck, WhatWasNeverCalibratedCannotBeChecked) {
    const CalibratedPerson person(9);
    auto take = person.stand(1);
    ASSERT_TRUE(take) << take.error().text();
    Calibration& calibration = take->observations.calibration;
    const Calibration nominal = nominalCalibration(take->observations.suit);
    for (size_t b = 0; b < calibration.boards.size(); ++b) {
        calibration.boards[b].gyro = nominal.boards[b].gyro;
        calibration.boards[b].made["accelerometers"] = {"2026-01-01T00:00:00Z", "good"};
    }
    const StillCheckReport report = checkStill(take->observations);
    ASSERT_EQ(report.findings.size(), 1U) << wordsOf(report);
    EXPECT_EQ(report.unchecked, "gyroscopes are not calibrated");
    EXPECT_EQ(report.grade(), Grade::kUnknown);
}

void exchange(Observations& seen, int one, int other) {
    std::swap(seen.boards[static_cast<size_t>(one)], seen.boards[static_cast<size_t>(other)]);
    for (FlightTime& flight : seen.flights)
        if (flight.board == one || flight.board == other)
            flight.board = flight.board == one ? other : one;
}

TEST(StillCheck, ExchangedBoardsAreNamedAsSuch) {
    const CalibratedPerson person(11);
    const struct {
        const char *one, *other, *said;
    } pairs[] = {{"l_forearm", "r_leg", "Boards 7 (left forearm) and %2 (right shin)"},
                 {"l_forearm", "l_hand", "Boards 7 (left forearm) and %2 (left hand)"}};
    for (const auto& pair : pairs) {
        SCOPED_TRACE(pair.said);
        auto take = person.stand(1);
        ASSERT_TRUE(take) << take.error().text();
        const int one = take->observations.suit.findBoard(pair.one);
        const int other = take->observations.suit.findBoard(pair.other);
        ASSERT_GE(one, 0);
        ASSERT_GE(other, 0);
        exchange(take->observations, one, other);
        const StillCheckReport report = checkStill(take->observations);
        ASSERT_FALSE(report.findings.empty());
        std::string said = pair.said;
        said.replace(said.find("%2"), 2, std::to_string(other + 1));
        EXPECT_EQ(report.findings[0].what, said + " seem to be exchanged") << wordsOf(report);
        EXPECT_EQ(report.findings.size(), 1U) << wordsOf(report);
        EXPECT_NE(report.grade(), Grade::kGood);
    }
}

TEST(StillCheck, WhatBefellAllBoardsIsOneFinding) {
    const CalibratedPerson person(10);
    auto take = person.stand(1);
    ASSERT_TRUE(take) << take.error().text();
    for (auto& board : take->observations.boards)
        for (CountReading& reading : board)
            reading.gyro_counts.y() += 5;
    const StillCheckReport report = checkStill(take->observations);
    ASSERT_EQ(report.findings.size(), 1U) << wordsOf(report);
    EXPECT_TRUE(report.findings[0].what.starts_with("The gyroscopes of 18 boards have drifted"))
        << report.findings[0].what;
}

TEST(StillCheck, BadInputIsAReport) {
    EXPECT_EQ(checkStill({}).grade(), Grade::kNotUsable);
    auto take = test::standing(3);
    ASSERT_TRUE(take) << take.error().text();
    take->observations.flights.clear();
    take->observations.boards[4].clear();
    const StillCheckReport report = checkStill(take->observations);
    ASSERT_EQ(report.findings.size(), 1U) << wordsOf(report);
    EXPECT_FALSE(report.boards[4].heard);
    take->observations.boards.clear();
    EXPECT_EQ(checkStill(take->observations).grade(), Grade::kNotUsable);
}

}  // namespace
}  // namespace noctule
