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
    /// The estimate errs by a constant rotation in the limb's frame; what the limb carries lies as believed.
    void feed(LimbRanging& ranging, double seconds, const Quaterniond& error) {
        for (int i = 0; i < seconds / kRange_s; ++i) {
            time_s += kRange_s;
            ranging.turnSeen(time_s);
            const Matrix3d truth = attitude().toRotationMatrix();
            const Matrix3d believed = (attitude() * error).toRotationMatrix();
            const Vector3d& source = sources[static_cast<size_t>(i) % sources.size()];
            const Vector3d shank(0.02, -0.15, 0.05);
            for (const auto& [carried, turning] :
                 {std::pair(Vector3d(Vector3d::Zero()), p_mic), std::pair(shank, p_knee)}) {
                const double distance_m = (carried + truth * turning - source).norm() + random(kNoise_m);
                ranging.add({time_s, distance_m, kNoise_m * kNoise_m, source, carried, turning, believed}, 0);
            }
        }
    }
    /// The knee's axis, in the thigh as believed: where the shank shows it.
    static std::vector<LimbRanging::Held> kneeOf(const Quaterniond& error) {
        const Vector3d axis = error.conjugate() * Vector3d::UnitX();
        return {{axis, Vector3d::UnitY(), 0}, {axis, Vector3d::UnitZ(), 0}};
    }
    static double offAfter(const LimbRanging& ranging, const Quaterniond& error) {
        const auto found = ranging.contradict(kneeOf(error));
        return found ? logQuaternion(error * found->q_believed_limb).norm() : -1;
    }
};

TEST(LimbRanging, ALimbLostInAClipIsFoundHoweverItIsTurned) {
    for (const Vector3d& axis :
         {Vector3d(1, 0, 0), Vector3d(0, 0, 1), Vector3d(1, -1, 1), Vector3d(-1, 2, 0)})
        for (const double angle : {0.7, 1.5, 3.0}) {
            const Quaterniond error = axisAngle(axis.normalized(), angle);
            SwungThigh thigh;
            LimbRanging ranging;
            ranging.breakOff(0);
            thigh.feed(ranging, 0.6, error);
            const double off = SwungThigh::offAfter(ranging, error);
            EXPECT_GE(off, 0) << axis.transpose() << ", " << angle;
            EXPECT_LT(off, 0.1) << axis.transpose() << ", " << angle;
        }
}

TEST(LimbRanging, ALimbInItsPlaceStaysThere) {
    for (const double angle : {0.0, 0.1}) {
        SwungThigh thigh;
        LimbRanging ranging;
        ranging.breakOff(0);
        const Quaterniond error = axisAngle(Vector3d::UnitX(), angle);
        thigh.feed(ranging, 0.6, error);
        EXPECT_FALSE(ranging.contradict(SwungThigh::kneeOf(error))) << angle;
    }
}

TEST(LimbRanging, NoLimbIsSuspectedWhoseTurnWasSeen) {
    const Quaterniond error = axisAngle(Vector3d::UnitX(), 1.5);
    SwungThigh thigh;
    LimbRanging ranging;
    EXPECT_FALSE(ranging.isSuspected());
    thigh.feed(ranging, 1, error);
    EXPECT_FALSE(ranging.isSuspected());
    ranging.breakOff(thigh.time_s);
    thigh.feed(ranging, 0.1, error);
    EXPECT_TRUE(ranging.isSuspected());
    EXPECT_LT(SwungThigh::offAfter(ranging, error), 0) << "too early to say";
    thigh.feed(ranging, 0.5, error);
    EXPECT_GE(SwungThigh::offAfter(ranging, error), 0);
    thigh.feed(ranging, 5, error);
    EXPECT_FALSE(ranging.isSuspected()) << "long ago";
}

TEST(LimbRanging, AHoleInTheReadingsIsAGap) {
    LimbRanging ranging;
    SwungThigh thigh;
    thigh.feed(ranging, 1, Quaterniond::Identity());
    ranging.turnSeen(thigh.time_s + 0.1);
    EXPECT_TRUE(ranging.isSuspected());
}

/// Where nothing shows the turn about the line to the only microphone, the limb keeps it and says so.
TEST(LimbRanging, WhatNoDistanceTellsStaysUnknown) {
    const Vector3d p_mic(0, -0.2, 0);
    const Quaterniond error = axisAngle(Vector3d::UnitX(), 1.0);
    SwungThigh thigh;
    LimbRanging ranging;
    ranging.breakOff(0);
    for (int i = 0; i < 80; ++i) {
        thigh.time_s += kRange_s;
        ranging.turnSeen(thigh.time_s);
        const Vector3d& source = thigh.sources[static_cast<size_t>(i) % thigh.sources.size()];
        const double distance_m = (thigh.attitude() * p_mic - source).norm() + thigh.random(kNoise_m);
        ranging.add({thigh.time_s, distance_m, kNoise_m * kNoise_m, source, Vector3d::Zero(), p_mic,
                     (thigh.attitude() * error).toRotationMatrix()},
                    0);
    }
    const auto found = ranging.contradict({});
    ASSERT_TRUE(found);
    const Vector3d along = error * found->q_believed_limb * Vector3d::UnitY();
    EXPECT_LT(std::acos(along.y()), 0.1) << "the line to the microphone is right";
    EXPECT_GT(found->variance_rad2.maxCoeff(), 0.5);
    EXPECT_LT(found->variance_rad2.minCoeff(), 0.01);
}

}  // namespace
}  // namespace noctule
