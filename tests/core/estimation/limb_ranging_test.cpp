// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/limb_ranging.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/math/rotation.h"
#include "tests/core/estimation/small_body.h"

namespace noctule {
namespace {

constexpr double kRange_s = 0.008, kNoise_m = 0.001;

/// A thigh that swings below the world's origin: a microphone on it, one on the shank that it carries, and
/// the knee's hinge, which holds the turn about its own length.
struct SwungThigh {
    double time_s = 0;
    testing::Gaussian random{7};
    const Vector3d p_mic{0.03, -0.2, 0.06}, p_knee{0, -0.42, 0};
    const std::array<Vector3d, 4> sources = {Vector3d(0.1, 0.05, 0.12), Vector3d(-0.12, 0.1, 0.1),
                                             Vector3d(0.15, 0.45, 0.12), Vector3d(-0.1, 0.4, -0.1)};

    Quaterniond attitude() const {
        return axisAngle(Vector3d::UnitX(), 0.8 * std::sin(3 * time_s)) *
               axisAngle(Vector3d::UnitZ(), 0.3 * std::sin(2 * time_s + 1));
    }
    /// What a gyroscope on it reads.
    Vector3d rate() const {
        constexpr double kNear_s = 1e-4;
        SwungThigh before = *this, after = *this;
        before.time_s -= kNear_s;
        after.time_s += kNear_s;
        return logQuaternion(before.attitude().conjugate() * after.attitude()) / (2 * kNear_s);
    }
    /// As an estimate believes that integrates the gyroscope's rate from a wrong beginning: `error` stays in
    /// the world.
    Quaterniond believed(const Quaterniond& error) const { return error * attitude(); }
    /// What the limb carries lies as believed.
    void feed(LimbRanging& ranging, double seconds, double late_share = 0) {
        for (int i = 0; i < seconds / kRange_s; ++i) {
            time_s += kRange_s;
            ranging.turnSeen(time_s, rate());
            const Matrix3d truth = attitude().toRotationMatrix();
            const Vector3d& source = sources[static_cast<size_t>(i) % sources.size()];
            const Vector3d shank(0.02, -0.15, 0.05);
            for (const auto& [carried, turning] :
                 {std::pair(Vector3d(Vector3d::Zero()), p_mic), std::pair(shank, p_knee)}) {
                double distance_m = (carried + truth * turning - source).norm() + random(kNoise_m);
                if (std::fmod(0.618 * ++heard, 1.0) < late_share)
                    distance_m += 0.1 + 0.2 * std::fmod(0.414 * heard, 1.0);
                ranging.add({time_s, distance_m, kNoise_m * kNoise_m, source, carried, turning}, 0);
            }
        }
    }
    /// -1 where nothing contradicts.
    double offAfter(const LimbRanging& ranging, const Quaterniond& error) const {
        const Quaterniond limb_believed = attitude().conjugate() * believed(error);
        const Vector3d axis = limb_believed.conjugate() * Vector3d::UnitX();  // where the shank shows it
        const auto found = ranging.contradict(time_s, believed(error).toRotationMatrix(),
                                              {{axis, Vector3d::UnitY(), 0}, {axis, Vector3d::UnitZ(), 0}});
        return found ? logQuaternion(limb_believed * found->q_believed_limb).norm() : -1;
    }
    int heard = 0;
};

TEST(LimbRanging, ALimbLostInAClipIsFoundHoweverItIsTurned) {
    for (const Vector3d& axis :
         {Vector3d(1, 0, 0), Vector3d(0, 0, 1), Vector3d(1, -1, 1), Vector3d(-1, 2, 0)})
        for (const double angle : {0.7, 1.5, 3.0}) {
            const Quaterniond error = axisAngle(axis.normalized(), angle);
            SwungThigh thigh;
            LimbRanging ranging;
            ranging.breakOff(0);
            thigh.feed(ranging, 1.5);
            const double off = thigh.offAfter(ranging, error);
            EXPECT_GE(off, 0) << axis.transpose() << ", " << angle;
            EXPECT_LT(off, 0.1) << axis.transpose() << ", " << angle;
        }
}

/// A third of the sound comes by way of the floor, as it does at shanks and hands.
TEST(LimbRanging, LateArrivalsDoNotHideALimb) {
    const Quaterniond error = axisAngle(Vector3d(1, -1, 1).normalized(), 1.2);
    SwungThigh thigh;
    LimbRanging ranging;
    ranging.breakOff(0);
    thigh.feed(ranging, 1.5, 0.33);
    const double off = thigh.offAfter(ranging, error);
    EXPECT_GE(off, 0);
    EXPECT_LT(off, 0.1);
}

/// Nobody knows how it turns meanwhile.
TEST(LimbRanging, ASilentLimbIsNotLookedFor) {
    const Quaterniond error = axisAngle(Vector3d::UnitX(), 1.5);
    SwungThigh thigh;
    LimbRanging ranging;
    ranging.breakOff(0);
    thigh.feed(ranging, 1.5);
    ASSERT_GE(thigh.offAfter(ranging, error), 0);
    thigh.time_s += 0.1;
    EXPECT_LT(thigh.offAfter(ranging, error), 0);
}

TEST(LimbRanging, ALimbInItsPlaceStaysThere) {
    for (const double angle : {0.0, 0.1}) {
        SwungThigh thigh;
        LimbRanging ranging;
        ranging.breakOff(0);
        const Quaterniond error = axisAngle(Vector3d::UnitX(), angle);
        thigh.feed(ranging, 1.5);
        EXPECT_LT(thigh.offAfter(ranging, error), 0) << angle;
    }
}

TEST(LimbRanging, NoLimbIsSuspectedWhoseTurnWasSeen) {
    const Quaterniond error = axisAngle(Vector3d::UnitX(), 1.5);
    SwungThigh thigh;
    LimbRanging ranging;
    EXPECT_FALSE(ranging.isSuspected());
    thigh.feed(ranging, 1);
    EXPECT_FALSE(ranging.isSuspected());
    ranging.breakOff(thigh.time_s);
    thigh.feed(ranging, 0.1);
    EXPECT_TRUE(ranging.isSuspected());
    EXPECT_LT(thigh.offAfter(ranging, error), 0) << "too early to say";
    thigh.feed(ranging, 1);
    EXPECT_GE(thigh.offAfter(ranging, error), 0);
    thigh.feed(ranging, 5);
    EXPECT_FALSE(ranging.isSuspected()) << "long ago";
}

TEST(LimbRanging, AHoleInTheReadingsIsAGap) {
    LimbRanging ranging;
    SwungThigh thigh;
    thigh.feed(ranging, 1);
    ranging.turnSeen(thigh.time_s + 0.1, thigh.rate());
    EXPECT_TRUE(ranging.isSuspected());
}

/// A limb that hangs still: nothing shows the turn about the line to the only microphone; it keeps it and
/// says so.
TEST(LimbRanging, WhatNoDistanceTellsStaysUnknown) {
    const Vector3d p_mic(0, -0.2, 0);
    const Quaterniond error = axisAngle(Vector3d::UnitX(), 1.0);
    SwungThigh thigh;
    const Quaterniond truth = thigh.attitude(), believed = thigh.believed(error);
    LimbRanging ranging;
    ranging.breakOff(0);
    double time_s = 0;
    for (int i = 0; i < 200; ++i) {
        time_s += kRange_s;
        ranging.turnSeen(time_s, Vector3d::Zero());
        const Vector3d& source = thigh.sources[static_cast<size_t>(i) % thigh.sources.size()];
        const double distance_m = (truth * p_mic - source).norm() + thigh.random(kNoise_m);
        ranging.add({time_s, distance_m, kNoise_m * kNoise_m, source, Vector3d::Zero(), p_mic}, 0);
    }
    const auto found = ranging.contradict(time_s, believed.toRotationMatrix(), {});
    ASSERT_TRUE(found);
    const Vector3d along = truth.conjugate() * believed * found->q_believed_limb * Vector3d::UnitY();
    EXPECT_LT(std::acos(along.y()), 0.1) << "the line to the microphone is right";
    EXPECT_GT(found->variance_rad2.maxCoeff(), 0.5);
    EXPECT_LT(found->variance_rad2.minCoeff(), 0.01);
}

}  // namespace
}  // namespace noctule
