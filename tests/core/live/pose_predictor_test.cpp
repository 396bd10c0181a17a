// SPDX-License-Identifier: Apache-2.0
#include "core/live/pose_predictor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/math/rotation.h"
#include "core/suit/default_suit.h"
#include "tests/support/rate.h"

namespace noctule {
namespace {

using test::kRate_hz;

constexpr double kLate_s = 0.015;

/// Every joint swings about an axis of its own by 14 degrees, 1.5 times a second: up to 2.4 rad/s a joint.
Pose swinging(const Actor& actor, double time_s) {
    Pose pose = actor.restPose();
    pose.p_world_root += Vector3d(1.2, 0, 0.5) * time_s;
    for (size_t joint = 0; joint < pose.q_parent_joint.size(); ++joint) {
        const auto n = static_cast<double>(joint);
        const Vector3d axis = Vector3d(std::sin(n), std::cos(2 * n), std::sin(3 * n + 1)).normalized();
        const double angle_rad = 0.25 * std::sin(2 * std::numbers::pi * 1.5 * time_s + n);
        pose.q_parent_joint[joint] = pose.q_parent_joint[joint] * expQuaternion(axis * angle_rad);
    }
    return pose;
}

class PredictedPose : public testing::Test {
protected:
    PredictedPose()
        : suit_(defaultSuit()),
          calibration_(nominalCalibration(suit_)),
          actor_(defaultActor()),
          predictor_(std::move(PosePredictor::create(suit_, calibration_, actor_, kRate_hz).value())) {}

    Vector3d rateOf(const Board& board, double time_s) const {
        constexpr double kStep_s = 1e-4;
        const auto joint = static_cast<size_t>(actor_.skeleton.find(board.segment));
        const auto q = [&](double at_s) {
            return globalPose(actor_.skeleton, swinging(actor_, at_s)).q_world_joint[joint];
        };
        const Vector3d turned = logQuaternion(q(time_s - kStep_s).conjugate() * q(time_s + kStep_s));
        return board.q_segment_board.conjugate() * Vector3d(turned / (2 * kStep_s));
    }

    /// Of all boards, each at instants of its own, up to `until_s`.
    void addReadings(double from_s, double until_s, const std::string& but = {}) {
        for (size_t b = 0; b < suit_.boards.size(); ++b) {
            const Board& board = suit_.boards[b];
            if (board.id == but)
                continue;
            for (int64_t frame = 0;; ++frame) {
                InertialReading reading;
                reading.board = static_cast<int>(b);
                reading.frame = frame;
                reading.sample = static_cast<double>(frame) * kRate_hz / kInertialFramesPerSecond +
                                 57.0 * static_cast<double>(b);
                const double time_s = reading.sample / kRate_hz;
                if (time_s > until_s)
                    break;
                if (time_s < from_s)
                    continue;
                const AxisCalibration& gyro = calibration_.boards[b].gyro;
                const Vector3d counts = gyro.matrix.inverse() * rateOf(board, time_s) + gyro.zero_counts;
                for (size_t axis = 0; axis < 3; ++axis)
                    reading.counts[axis] = std::round(counts[static_cast<Eigen::Index>(axis)]);
                reading.corrected_bits = 0;
                predictor_->add(reading);
            }
        }
    }

    void addPose(double time_s) {
        predictor_->add(TimedPose{std::llround(time_s * 1e9), swinging(actor_, time_s), {}});
    }

    /// Of all segments with a board, in the world, against the truth at the pose's own time.
    double worst_deg(const Pose& pose, double time_s) const {
        const GlobalPose seen = globalPose(actor_.skeleton, pose),
                         truth = globalPose(actor_.skeleton, swinging(actor_, time_s));
        double worst_rad = 0;
        for (const Board& board : suit_.boards) {
            const auto joint = static_cast<size_t>(actor_.skeleton.find(board.segment));
            worst_rad =
                std::max(worst_rad, seen.q_world_joint[joint].angularDistance(truth.q_world_joint[joint]));
        }
        return degrees(worst_rad);
    }

    const Suit suit_;
    const Calibration calibration_;
    const Actor actor_;
    std::unique_ptr<PosePredictor> predictor_;
};

TEST_F(PredictedPose, NothingBeforeThereIsAPose) {
    addReadings(0, 0.1);
    EXPECT_FALSE(predictor_->predict());
}

TEST_F(PredictedPose, IsTheFiltersOwnWhereNoReadingIsNewer) {
    addReadings(0, 0.1);
    addPose(0.2);
    const auto predicted = predictor_->predict();
    ASSERT_TRUE(predicted);
    EXPECT_EQ(predicted->time_ns, 200'000'000);
    EXPECT_EQ(worst_deg(*predicted->pose, 0.2), 0);
}

TEST_F(PredictedPose, LiesAtTheNewestReadingAndFollowsTheGyroscopes) {
    double worst_predicted_deg = 0, worst_held_deg = 0;
    double given_s = 0, read_s = 0;
    for (double now_s = 0.1; now_s < 1.5; now_s += 0.02) {
        for (; given_s < now_s - kLate_s; given_s += 1.0 / kInertialFramesPerSecond)
            addPose(given_s);
        addReadings(read_s + 1e-9, now_s);
        read_s = now_s;
        const auto predicted = predictor_->predict();
        ASSERT_TRUE(predicted);
        const double time_s = static_cast<double>(predicted->time_ns) * 1e-9;
        EXPECT_LE(time_s, now_s + 1e-8);
        EXPECT_GT(time_s, now_s - 0.001) << "18 boards read 140 times a second, each at its own instant";
        worst_predicted_deg = std::max(worst_predicted_deg, worst_deg(*predicted->pose, time_s));
        worst_held_deg = std::max(worst_held_deg, worst_deg(swinging(actor_, given_s), time_s));
        EXPECT_NEAR((predicted->pose->p_world_root - swinging(actor_, time_s).p_world_root).norm(), 0, 1e-6);
    }
    // 44 rad/s^2 a joint, several joints of a chain add up, the newest reading is up to 7 ms old.
    EXPECT_LT(worst_predicted_deg, 0.6);
    EXPECT_GT(worst_held_deg, 2.5) << "the test moves enough to show it";
}

TEST_F(PredictedPose, ABoardThatFellSilentGoesWithItsParent) {
    const auto hand = static_cast<size_t>(actor_.skeleton.find("LeftHand"));
    addReadings(0, 0.5, "l_hand");
    addPose(0.485);
    const auto predicted = predictor_->predict();
    ASSERT_TRUE(predicted);
    EXPECT_TRUE(predicted->pose->q_parent_joint[hand].isApprox(swinging(actor_, 0.485).q_parent_joint[hand]));
    EXPECT_GT(predicted->time_ns, 499'000'000);
}

TEST_F(PredictedPose, IsNotCarriedFartherThanItsLimit) {
    addPose(0.1);
    addReadings(0, 0.5);
    const auto predicted = predictor_->predict();
    ASSERT_TRUE(predicted);
    EXPECT_EQ(predicted->time_ns, 200'000'000);
}

TEST_F(PredictedPose, ARootThatWasMendedIsNotTakenForAMotion) {
    addPose(0.1);
    TimedPose mended{107'000'000, swinging(actor_, 0.107), {}};
    mended.pose->p_world_root.x() += 0.5;
    predictor_->add(mended);
    addReadings(0, 0.12);
    const auto predicted = predictor_->predict();
    ASSERT_TRUE(predicted);
    EXPECT_TRUE(predicted->pose->p_world_root.isApprox(mended.pose->p_world_root));
}

}  // namespace
}  // namespace noctule
