// SPDX-License-Identifier: Apache-2.0
// Calibration from a guided movement: what it finds against the simulator's truth, and what it refuses.
// NOCTULE_CALIBRATION_TRIALS performers for the full figures.
#include "core/calibration/motion/motion_calibration.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/calibration/rest_pose/rest_pose_calibration.h"
#include "core/formats/bvh.h"
#include "core/math/rotation.h"
#include "core/suit/calibration_entries.h"
#include "tests/support/guided_motion.h"
#include "tests/support/observed_take.h"

namespace noctule {
namespace {

using simulation::Scenario;

Result<test::ObservedTake> guidedTake(const Scenario& scenario, uint64_t seed, const test::GuidedPlan& plan) {
    simulation::StageRequest request = test::stageOf(std::nullopt, seed);
    request.scenario = scenario;
    request.clip = test::GuidedMotion::clip(plan);
    return test::observe(request);
}

/// 18 s without a pause.
const test::GuidedPlan kShort{3};

/// As the wizard asks for it: the rest pose before each exercise, held as badly as the first one.
test::GuidedPlan asAsked(const Scenario& scenario, unsigned seed) {
    return {7.5, 2.5, scenario.initial_pose_rad, seed};
}

/// Only the mounting is unknown: what the solver does on perfect readings.
Scenario badlyMounted() {
    Scenario scenario = Scenario::ideal();
    scenario.mounting_rad = 0.052;
    return scenario;
}

/// A suit whose every value but the mounting is believed; without tissue it is solved in seconds.
MotionSettings plainSettings() {
    MotionSettings settings;
    settings.flesh = false;
    settings.sigma_place_m = settings.sigma_source_m = 1e-4;
    settings.sigma_bone = 1e-3;
    settings.sigma_give_rad = radians(0.3);
    settings.sigma_rest_rad = settings.sigma_level_rad = radians(0.1);
    return settings;
}

/// Errors of the mounting in degrees, about the board's axes.
struct MountingErrors {
    double square = 0, seen_square = 0, unseen_square = 0, before_square = 0, sigma_square = 0, worst = 0;
    int boards = 0, seen = 0, unseen = 0;

    void add(const MotionReport& report, const test::ObservedTake& take, const RestPoseReport* rest) {
        for (size_t b = 0; b < report.boards.size(); ++b) {
            const BoardInMotion& board = report.boards[b];
            const Quaterniond& truth = take.stage.body->worn().boards[b].q_segment_board;
            const Vector3d error = logQuaternion(truth.conjugate() * board.q_segment_board) * degrees(1);
            if (rest)
                before_square += std::pow(degrees(angleBetween(truth, rest->boards[b].q_segment_board)), 2);
            square += error.squaredNorm();
            sigma_square += (board.sigma_turn_rad * degrees(1)).squaredNorm();
            worst = std::max(worst, error.norm());
            ++boards;
            for (int axis = 0; axis < 3; ++axis) {
                (board.observed[axis] ? seen_square : unseen_square) += error[axis] * error[axis];
                ++(board.observed[axis] ? seen : unseen);
            }
        }
    }
    double anAxis() const { return rms(square, 3 * boards); }
    static double rms(double sum, int count) { return std::sqrt(sum / std::max(1, count)); }
};

std::string reasonsOf(const MotionReport& report) {
    std::string text;
    for (const Finding& finding : report.findings)
        text += finding.what + ". " + finding.remedy + ".\n";
    return text;
}

class GuidedMovement : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        take_ = new test::ObservedTake(guidedTake(badlyMounted(), 4, kShort).value());
    }
    static void TearDownTestSuite() { delete std::exchange(take_, nullptr); }

    static test::ObservedTake* take_;
};
test::ObservedTake* GuidedMovement::take_ = nullptr;

TEST_F(GuidedMovement, ShowsHowBoardsSitOnPerfectReadings) {
    const auto report = calibrateMotion({take_->observations}, plainSettings(), {});
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->converged);
    EXPECT_EQ(report->grade(), Grade::kGood) << reasonsOf(*report);
    MountingErrors errors;
    errors.add(*report, *take_, nullptr);
    std::printf("perfect readings: mounting rms %.3f deg, worst %.3f deg, %d iterations\n",
                MountingErrors::rms(errors.square, errors.boards), errors.worst, report->iterations);
    EXPECT_LT(MountingErrors::rms(errors.square, errors.boards), 0.15);
    EXPECT_LT(errors.worst, 0.5);
    EXPECT_NEAR(report->sound_scale, 1, 1e-3);
}

/// Whoever holds the rest pose off by two degrees holds it otherwise the next time.
TEST(MotionCalibration, EveryReturnToTheRestPoseEvensOutHowItWasHeld) {
    Scenario scenario = badlyMounted();
    scenario.initial_pose_rad = 0.035;
    MotionSettings settings;
    settings.flesh = false;
    const auto error_deg = [&](const test::GuidedPlan& plan, int rests) {
        const auto take = guidedTake(scenario, 6, plan).value();
        const auto report = calibrateMotion({take.observations}, settings, {}).value();
        EXPECT_TRUE(report.converged);
        EXPECT_EQ(report.rests, rests);
        MountingErrors errors;
        errors.add(report, take, nullptr);
        return MountingErrors::rms(errors.square, errors.boards);
    };
    const double once_deg = error_deg({4}, 1), each_time_deg = error_deg({4, 2.5, 0.035, 3}, 6);
    std::printf("mounting rms: rest pose held once %.2f deg, before each exercise %.2f deg\n", once_deg,
                each_time_deg);
    EXPECT_LT(each_time_deg, 0.75 * once_deg);
}

/// Every joint of an arm held some degrees off adds up to more than a strap turns: the fit begins with the
/// boards blamed for it, and finds that they are not.
TEST(MotionCalibration, BoardsOfALimbThatWasHeldOtherwiseAreNoStrays) {
    Scenario scenario = badlyMounted();
    scenario.initial_pose_rad = 0.07;
    MotionSettings settings;
    settings.flesh = false;
    settings.sigma_rest_rad = scenario.initial_pose_rad;
    const auto take = guidedTake(scenario, 8, {4, 2.5, scenario.initial_pose_rad, 8}).value();
    const auto report = calibrateMotion({take.observations}, settings, {}).value();
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(reasonsOf(report).find("strap"), std::string::npos) << reasonsOf(report);
    MountingErrors errors;
    errors.add(report, take, nullptr);
    std::printf("joints held 4 deg otherwise: mounting rms %.2f deg, worst %.2f deg\n",
                MountingErrors::rms(errors.square, errors.boards), errors.worst);
    EXPECT_LT(MountingErrors::rms(errors.square, errors.boards), 2);
}

/// A board that hangs 14 degrees otherwise than the suit says is left where the fit began, and named; unless
/// a rest pose's calibration, not an older movement's, says so too.
TEST_F(GuidedMovement, ABoardWornOtherwiseIsAStrayUnlessTheRestPoseSaysSo) {
    Observations worn = take_->observations;
    const auto b = static_cast<size_t>(worn.suit.findBoard("l_upleg"));
    Board& board = worn.suit.boards[b];
    const Quaterniond truth = take_->stage.body->worn().boards[b].q_segment_board;
    board.q_segment_board = (axisAngle(Vector3d::UnitY(), radians(14)) * truth).normalized();
    MotionSettings settings = plainSettings();
    settings.sigma_mounting_rad = radians(3);
    for (const bool by_rest_pose : {false, true}) {
        BoardCalibration& known = entryOf(worn.calibration, board);
        known.q_segment_board = truth;
        known.made = {{by_rest_pose ? "rest-pose" : "motion", {"2026-11-28T10:00:00Z", "good"}}};
        const auto report = calibrateMotion({worn}, settings, {});
        ASSERT_TRUE(report);
        const double off_deg = degrees(angleBetween(truth, report->boards[b].q_segment_board));
        const bool is_named = reasonsOf(*report).find("left thigh, keeps its place") != std::string::npos;
        EXPECT_EQ(is_named, !by_rest_pose) << reasonsOf(*report);
        if (by_rest_pose)
            EXPECT_LT(off_deg, 0.3);
        else
            EXPECT_NEAR(off_deg, 14, 0.5);
    }
}

TEST_F(GuidedMovement, WithASilentBoardIsNotUsableAndNamesIt) {
    Observations damaged = take_->observations;
    damaged.boards[6].clear();
    MotionSettings settings = plainSettings();
    settings.longest_s = 18;
    const auto report = calibrateMotion({damaged}, settings, {});
    ASSERT_TRUE(report);
    EXPECT_EQ(report->grade(), Grade::kNotUsable);
    EXPECT_EQ(report->findings[0].part, damaged.suit.boards[6].id);
    EXPECT_NE(reasonsOf(*report).find("Board 7"), std::string::npos) << reasonsOf(*report);
    EXPECT_FALSE(report->boards[6].measured);
    EXPECT_TRUE(report->boards[0].measured);
    const Calibration base = damaged.calibration;
    const Calibration found = report->applied(base, damaged.suit);
    EXPECT_FALSE(found.findBoard(damaged.suit.boards[6].id)->q_segment_board);
    EXPECT_FALSE(found.findBoard(damaged.suit.boards[6].id)->sigma_mounting_rad);
    EXPECT_EQ(found.findBoard(damaged.suit.boards[0].id)->sigma_mounting_rad,
              report->boards[0].sigma_turn_rad);
    EXPECT_TRUE(found.findBoard(damaged.suit.boards[0].id)->q_segment_board);
    const Actor measured = report->applied(damaged.actor);
    EXPECT_EQ(measured.skeleton.size(), damaged.actor.skeleton.size());
}

TEST_F(GuidedMovement, MostBoardsSilentIsOneFinding) {
    Observations damaged = take_->observations;
    for (size_t b = 0; b < damaged.boards.size(); ++b)
        if (b % 3 != 0)
            damaged.boards[b].clear();
    MotionSettings settings = plainSettings();
    settings.longest_s = 18;
    const auto report = calibrateMotion({damaged}, settings, {});
    ASSERT_TRUE(report);
    EXPECT_EQ(report->grade(), Grade::kNotUsable);
    EXPECT_NE(reasonsOf(*report).find("12 of 18 boards are heard in only 0 %"), std::string::npos)
        << reasonsOf(*report);
    EXPECT_EQ(reasonsOf(*report).find(", is heard in only"), std::string::npos) << "none by itself";
}

TEST_F(GuidedMovement, CanBeCancelled) {
    CancelFlag cancel;
    cancel.cancel();
    const auto report = calibrateMotion({take_->observations}, plainSettings(), {nullptr, &cancel});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ErrorKind::kCancelled);
}

/// For programs that take motions from files: packaging/acceptance/calibration.py.
TEST(GuidedMovementFile, IsWrittenAsAFile) {
    const char* path = std::getenv("NOCTULE_GUIDED_BVH");
    if (!path)
        GTEST_SKIP() << "set NOCTULE_GUIDED_BVH to the file to write";
    ASSERT_TRUE(writeBvh(path, test::GuidedMotion::clip(asAsked(Scenario::realistic(), 1)), {}, true));
    std::printf("guided movement: %s\n", path);
}

TEST(MotionCalibration, StandingStillIsTooLittleMovement) {
    simulation::StageRequest request = test::stageOf(std::nullopt);
    request.duration_s = 20;
    const auto take = test::observe(request);
    ASSERT_TRUE(take);
    const auto report = calibrateMotion({take->observations}, {}, {});
    ASSERT_TRUE(report);
    EXPECT_EQ(report->grade(), Grade::kNotUsable);
    EXPECT_NE(reasonsOf(*report).find("movement"), std::string::npos) << reasonsOf(*report);
    EXPECT_FALSE(report->boards[0].measured);
}

TEST(MotionCalibration, ATakeWithoutStillnessNamesTheRemedy) {
    auto take = guidedTake(badlyMounted(), 4, kShort);
    ASSERT_TRUE(take);
    Observations& moving = take->observations;
    moving.rest.reset();
    for (auto& readings : moving.boards)
        std::erase_if(readings, [](const CountReading& reading) { return reading.time_s < 5; });
    const auto report = calibrateMotion({moving}, plainSettings(), {});
    ASSERT_TRUE(report);
    EXPECT_EQ(report->grade(), Grade::kNotUsable);
    EXPECT_NE(reasonsOf(*report).find("Stand still"), std::string::npos) << reasonsOf(*report);
}

/// Of one performer, with all effects of a strap-on suit at once.
void addRealistic(const Scenario& scenario, const MotionSettings& settings, int performer,
                  MountingErrors& errors) {
    const auto seed = static_cast<unsigned>(performer + 1);
    const auto take = guidedTake(scenario, seed, asAsked(scenario, seed));
    ASSERT_TRUE(take);
    const auto rest = calibrateRestPose(take->observations, {}, {});
    const auto report = calibrateMotion({take->observations}, settings, {});
    ASSERT_TRUE(rest && report);
    EXPECT_TRUE(report->converged);
    errors.add(*report, *take, &*rest);
}

/// What a performer's movement shows and what it does not, and how much of the error is the flesh's: the same
/// performers once more without any, and solved without it. The truth is how boards sit in the rest pose;
/// their mean over the movement errs alike.
TEST(MotionCalibration, FiguresOfTheRealisticScenario) {
    const char* wanted = std::getenv("NOCTULE_CALIBRATION_TRIALS");
    const int trials = wanted ? std::max(1, std::atoi(wanted) / 10) : 0;
    if (trials == 0)
        GTEST_SKIP() << "a minute each; set NOCTULE_CALIBRATION_TRIALS to ten for each performer";
    Scenario bony = Scenario::realistic();
    bony.soft_tissue.reset();
    MotionSettings without_flesh;
    without_flesh.flesh = false;
    MountingErrors errors, of_bones;
    for (int trial = 0; trial < trials; ++trial) {
        addRealistic(Scenario::realistic(), {}, trial, errors);
        addRealistic(bony, without_flesh, trial, of_bones);
    }
    const auto whole_deg = [](const MountingErrors& of) { return MountingErrors::rms(of.square, of.boards); };
    std::printf(
        "realistic, %d performers: rest pose %.2f deg, movement %.2f deg rms of the whole mounting, %.2f deg "
        "an axis; sigma says %.2f deg in all\n"
        "turns that the movement shows (%d of %d): %.2f deg an axis; left to the rest pose: %.2f deg\n"
        "without soft tissue %.2f deg in all, %.2f deg an axis: %.0f %% of the squared error is soft "
        "tissue\n",
        trials, MountingErrors::rms(errors.before_square, errors.boards), whole_deg(errors), errors.anAxis(),
        MountingErrors::rms(errors.sigma_square, errors.boards), errors.seen, errors.seen + errors.unseen,
        MountingErrors::rms(errors.seen_square, errors.seen),
        MountingErrors::rms(errors.unseen_square, errors.unseen), whole_deg(of_bones), of_bones.anAxis(),
        100 * (1 - of_bones.square / errors.square));
    EXPECT_LT(errors.anAxis(), 0.7);
    EXPECT_LT(MountingErrors::rms(errors.seen_square, errors.seen), 0.5);
    EXPECT_LT(errors.square, 0.25 * errors.before_square);
    EXPECT_LT(errors.square, 1.5 * errors.sigma_square) << "the sigmas are honest";
}

}  // namespace
}  // namespace noctule
