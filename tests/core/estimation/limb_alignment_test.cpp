// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/limb_alignment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kReading_s = 1.0 / 140;

/// A limb whose turn is integrated finely, on a joint that is carried about, with a board 10 cm away.
struct SwungLimb {
    double swing = 1;  ///< 0: it hangs still
    double time_s = 0;
    Quaterniond q_world_limb = axisAngle(Vector3d(1, 2, -1).normalized(), 0.9);
    Vector3d p_m{0.02, -0.1, 0.01};

    Vector3d rate(double t) const {
        return swing * Vector3d(6 * std::sin(9 * t), 4 * std::cos(7 * t), -5 * std::sin(5 * t + 1));
    }
    Vector3d turnAccel(double t) const {
        return swing * Vector3d(54 * std::cos(9 * t), -28 * std::sin(7 * t), -25 * std::cos(5 * t + 1));
    }
    Vector3d forceOfJoint() const {
        return Vector3d(swing * 4 * std::sin(8 * time_s), kStandardGravity_m_per_s2,
                        swing * 3 * std::cos(6 * time_s));
    }
    void advance() {
        constexpr int kFine = 50;
        for (int i = 0; i < kFine; ++i)
            q_world_limb = q_world_limb *
                           expQuaternion(rate(time_s + (i + 0.5) * kReading_s / kFine) * kReading_s / kFine);
        time_s += kReading_s;
    }
    LimbAlignment::Reading reading() const {
        const Vector3d w = rate(time_s);
        return {
            time_s, w,
            q_world_limb.conjugate() * forceOfJoint() + turnAccel(time_s).cross(p_m) + w.cross(w.cross(p_m)),
            p_m};
    }
    void feed(LimbAlignment& alignment, double seconds) {
        for (int i = 0; i < seconds / kReading_s; ++i) {
            advance();
            alignment.add(reading(), forceOfJoint());
        }
    }
    Matrix3d believed(const Quaterniond& error) const { return (q_world_limb * error).toRotationMatrix(); }
};

class LimbAlignmentTest : public ::testing::Test {
protected:
    /// The gyroscope has just come back into its range.
    void clip() { alignment.breakOff(limb.time_s); }
    double offAfter(const Quaterniond& error) const {
        const auto found = alignment.contradict(limb.believed(error));
        return found ? logQuaternion(error * found->q_believed_limb).norm() : -1;
    }

    SwungLimb limb;
    LimbAlignment alignment;
};

TEST_F(LimbAlignmentTest, ALimbLostInAClipIsFoundHoweverItIsTurned) {
    clip();
    limb.feed(alignment, 0.5);
    for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1), Vector3d(1, -1, 1)})
        for (const double angle : {0.7, 1.5, 3.0}) {
            const double off = offAfter(axisAngle(axis.normalized(), angle));
            EXPECT_GE(off, 0) << axis.transpose() << ", " << angle;
            EXPECT_LT(off, 0.03) << axis.transpose() << ", " << angle;
        }
}

TEST_F(LimbAlignmentTest, WhatItSaysOfItsErrorIsNeitherNothingNorEverything) {
    clip();
    limb.feed(alignment, 0.5);
    const auto found = alignment.contradict(limb.believed(axisAngle(Vector3d::UnitX(), 1.5)));
    ASSERT_TRUE(found);
    EXPECT_GT(found->variance_rad2.minCoeff(), std::pow(0.02, 2));
    EXPECT_LT(found->variance_rad2.maxCoeff(), std::pow(0.5, 2));
}

TEST_F(LimbAlignmentTest, ALimbInItsPlaceStaysThere) {
    clip();
    limb.feed(alignment, 0.5);
    EXPECT_FALSE(alignment.contradict(limb.believed(Quaterniond::Identity())));
    EXPECT_FALSE(alignment.contradict(limb.believed(axisAngle(Vector3d::UnitX(), 0.3))));
}

TEST_F(LimbAlignmentTest, NoLimbIsSuspectedWhoseTurnWasSeen) {
    const Quaterniond error = axisAngle(Vector3d::UnitX(), 1.5);
    limb.feed(alignment, 1);
    EXPECT_LT(offAfter(error), 0);
    clip();
    limb.feed(alignment, 0.1);
    EXPECT_LT(offAfter(error), 0) << "too early to say";
    limb.feed(alignment, 1);
    EXPECT_GE(offAfter(error), 0);
    limb.feed(alignment, 5);
    EXPECT_LT(offAfter(error), 0) << "long ago";
}

TEST_F(LimbAlignmentTest, AHoleInTheReadingsIsAGap) {
    limb.feed(alignment, 1);
    for (int i = 0; i < 10; ++i)
        limb.advance();
    limb.feed(alignment, 0.5);
    EXPECT_GE(offAfter(axisAngle(Vector3d::UnitX(), 1.5)), 0);
}

TEST_F(LimbAlignmentTest, AStillLimbTellsItsTiltAndKeepsItsHeading) {
    limb.swing = 0;
    clip();
    limb.feed(alignment, 0.5);
    const Vector3d up = limb.q_world_limb.conjugate() * Vector3d::UnitY();
    EXPECT_FALSE(alignment.contradict(limb.believed(axisAngle(up, 1.5)))) << "nothing shows the heading";
    const Quaterniond tilt = axisAngle(up.unitOrthogonal(), 1.2);
    EXPECT_LT(offAfter(tilt), 0.03);
    EXPECT_GE(offAfter(tilt), 0);
}

TEST_F(LimbAlignmentTest, AWobblingBoardAccusesNobody) {
    clip();
    for (int i = 0; i < 140; ++i) {
        limb.advance();
        auto reading = limb.reading();
        const double blow = 40 * std::exp(-std::fmod(limb.time_s, 0.4) / 0.05);
        reading.force_m_per_s2 +=
            blow * Vector3d(std::sin(75 * limb.time_s), 0.7, std::cos(75 * limb.time_s));
        alignment.add(reading, limb.forceOfJoint());
        EXPECT_FALSE(alignment.contradict(limb.believed(Quaterniond::Identity()))) << limb.time_s;
    }
}

}  // namespace
}  // namespace noctule
