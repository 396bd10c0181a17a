// SPDX-License-Identifier: Apache-2.0
// What the filter believes of joints while gyroscopes are at the end of their range.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/estimation/small_world.h"

namespace noctule {
namespace {

using testing::World;

constexpr double kRange_rad_per_s = 17.5, kBetweenReadings_s = 1.0 / kInertialFramesPerSecond;

struct UnseenRates : ::testing::Test {
    UnseenRates() {
        parameters.sensors = {false, true, false};
        parameters.root_given = true;
        parameters.joints_give = false;
    }
    /// The small body, which does not move but for a root that turns about the vertical.
    struct Turning {
        explicit Turning(const ManifoldParameters& parameters)
            : world(parameters, 1), filter(testing::smallSkeleton(), world.suit, parameters) {
            world.motion = world.tree.stateFromPose(testing::smallSkeleton().zeroPose());
            world.gyro_bias.assign(4, Vector3d::Zero());
            const RootMeasurement root = rootAt(0);
            filter.start(testing::smallSkeleton().zeroPose(), {}, &root);
        }
        RootMeasurement rootAt(double at_s) const {
            return {at_s, world.motion.p_world_root, world.motion.q_parent_link[0], 0.001, 0.001};
        }
        /// From one rate to another and, at most half a second, steadily.
        void turn(double rate_rad_per_s, double seconds, const std::vector<int>& clipped_boards = {}) {
            const double from_s = time_s, change = rate_rad_per_s - world.motion.rate[4],
                         first = world.motion.rate[4];
            for (const double until_s = time_s + seconds; time_s < until_s; time_s += kBetweenReadings_s) {
                const double share = std::min(1.0, (time_s - from_s) / 0.5);
                world.motion.rate[4] = first + change * share * share * (3 - 2 * share);
                world.motion.accel.setZero();
                world.tree.retract(world.motion, kBetweenReadings_s * world.motion.rate);
                filter.add(rootAt(time_s + kBetweenReadings_s));
                for (int b = 0; b < 4; ++b) {
                    InertialMeasurement reading = world.inertial(b, time_s + kBetweenReadings_s);
                    const bool always =
                        std::find(clipped_boards.begin(), clipped_boards.end(), b) != clipped_boards.end();
                    for (AxisReading& axis : reading.gyro.axes)
                        if (always || std::abs(axis.value) > kRange_rad_per_s) {
                            axis.beyond = axis.value < 0 ? -1 : 1;
                            axis.value = axis.beyond * kRange_rad_per_s;
                        }
                    filter.add(reading);
                }
                filter.advanceTo(time_s);
            }
        }
        World world;
        ManifoldFilter filter;
        double time_s = 0;
    };
    /// How far the chest is believed to have turned against the hips after the body has spun as one.
    double apart_deg() {
        Turning body(parameters);
        body.turn(2, 2);
        body.turn(40, 0.7);
        body.turn(2, 1);
        return degrees(logQuaternion(body.filter.state().motion.q_parent_link[1]).norm());
    }

    ManifoldParameters parameters;
};

TEST_F(UnseenRates, ATrunkThatSpinsAsOneDoesNotComeApart) {
    parameters.unseen.least_rad_per_s = 1;
    const double held_deg = apart_deg();
    parameters.unseen.least_rad_per_s = 1e6;
    EXPECT_LT(held_deg, 15);
    EXPECT_GT(apart_deg(), 3 * held_deg);
}

TEST_F(UnseenRates, AJointThatRunsAwayIsBroughtBack) {
    Turning body(parameters);
    body.turn(1, 0.5);
    ManifoldFilter::Memory memory = body.filter.memory();
    memory.state.motion.rate[7] = 500;  // of the chest, about the vertical
    body.filter.recall(memory);
    const int resets = body.filter.resets();
    FilterTape tape;  // which is told what was pulled to which value
    body.filter.setTape(&tape);
    body.turn(1, 0.1, {1, 2, 3});
    EXPECT_GT(body.filter.resets(), resets);
    EXPECT_LT(body.filter.state().motion.rate.cwiseAbs().maxCoeff(), 200);
    EXPECT_TRUE(body.filter.covariance().allFinite());
    for (const auto& event : tape)
        if (const auto* update = std::get_if<ObservedUpdate>(&event))
            for (const ObservationBlock& block : update->blocks)
                if (block.origin.kind == ObservationOrigin::Kind::kPull) {
                    EXPECT_NEAR(block.origin.target.cwiseAbs().maxCoeff(), 0, 1e-9)
                        << "all are pulled to rest";
                }
}

}  // namespace
}  // namespace noctule
