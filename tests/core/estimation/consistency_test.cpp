// SPDX-License-Identifier: Apache-2.0
// Is the filter's covariance honest? Motion and noise are drawn from the filter's own assumptions; then the
// normalised estimation error squared (NEES) of the pose, averaged over runs, must be near 1.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "core/inertial/reading.h"
#include "core/math/rotation.h"
#include "tests/core/estimation/small_body.h"

namespace noctule {
namespace {

using Eigen::VectorXd;
using testing::Gaussian;

struct Outcome {
    double nees = 0;       ///< mean over the last two thirds, per freedom
    double mean_deg = 0;   ///< joint error at the end
    double sigma_deg = 0;  ///< as the filter believes
    int resets = 0;
};

VectorXd coordinateError(const KinematicTree& tree, const MotionState& truth, const MotionState& estimate) {
    VectorXd error(tree.freedoms());
    for (size_t i = 0; i < tree.links().size(); ++i) {
        const Link& link = tree.links()[i];
        const Vector3d turn = logQuaternion(estimate.q_parent_link[i].conjugate() * truth.q_parent_link[i]);
        if (link.type == LinkType::kFree)
            error.segment<6>(link.first) << truth.p_world_root - estimate.p_world_root, turn;
        else if (link.type == LinkType::kBall)
            error.segment<3>(link.first) = turn;
        else if (link.type == LinkType::kHinge)
            error[link.first] = truth.angle_rad[i] - estimate.angle_rad[i];
    }
    return error;
}

class World {
public:
    World(const ManifoldParameters& parameters, unsigned seed)
        : p(parameters),
          tree(testing::smallSkeleton(), BallCoordinates::kManifold),
          random(seed),
          suit(
              mountSuit(testing::smallSuit(), {}, testing::actorOf(testing::smallSkeleton()), tree).value()) {
        motion = tree.stateFromPose(testing::smallSkeleton().zeroPose());
        const int n = tree.freedoms();
        tree.retract(motion, random.vector(n, p.initial_pose_rad));
        motion.rate = random.vector(n, p.initial_rate_rad_per_s);
        motion.accel = random.vector(n, p.initial_accel_rad_per_s2);
        for (int b = 0; b < 4; ++b) {
            gyro_bias.push_back(random.vector(p.gyro_bias_rad_per_s));
            accel_bias.push_back(random.vector(p.accel_bias_m_per_s2));
        }
        source_offset = {random(p.source_offset_m), random(p.source_offset_m)};
        sound_scale = random(p.sound_scale);
    }

    /// Moves by the filter's process, `dt` short.
    void move(double dt) {
        VectorXd decay = VectorXd::Constant(tree.freedoms(), std::exp(-dt / p.joint_accel_time_s));
        VectorXd sigma = VectorXd::Constant(tree.freedoms(), p.joint_accel_rad_per_s2);
        decay.head<3>().setConstant(std::exp(-dt / p.root_accel_time_s));
        sigma.head<3>().setConstant(p.root_accel_m_per_s2);
        sigma.segment<3>(3).setConstant(p.root_turn_accel_rad_per_s2);
        tree.retract(motion, dt * motion.rate + 0.5 * dt * dt * motion.accel);
        motion.rate += dt * motion.accel;
        for (int i = 0; i < tree.freedoms(); ++i)
            motion.accel[i] =
                decay[i] * motion.accel[i] + random(sigma[i] * std::sqrt(1 - decay[i] * decay[i]));
    }

    InertialMeasurement inertial(int board, double time_s) {
        ChainMotion chain;
        const MountedBoard& mounted = suit.boards[static_cast<size_t>(board)];
        chain.evaluate(tree, motion, mounted.link, 0);
        const Matrix3d R_board_world = (chain.end().R_world_link * mounted.R_link_board).transpose();
        const Vector3d omega =
            R_board_world * chain.end().omega_rad_per_s + gyro_bias[static_cast<size_t>(board)];
        const Vector3d force = R_board_world * (chain.point(mounted.p_link_board).a_m_per_s2 +
                                                Vector3d(0, kStandardGravity_m_per_s2, 0)) +
                               accel_bias[static_cast<size_t>(board)];
        InertialMeasurement m{board, time_s, {}, {}};
        for (int i = 0; i < 3; ++i) {
            m.gyro.add({Vector3d::Unit(i), omega[i] + random(kGyroSigma), kGyroSigma});
            m.accel.add({Vector3d::Unit(i), force[i] + random(kAccelSigma), kAccelSigma});
        }
        return m;
    }

    Vector3d point(int link, const Vector3d& p_link) const {
        ChainMotion chain;
        chain.evaluate(tree, motion, link, 0);
        return chain.point(p_link).p_m;
    }

    static constexpr double kGyroSigma = 0.005, kAccelSigma = 0.05, kDistanceSigma = 0.002;
    ManifoldParameters p;
    KinematicTree tree;
    Gaussian random;
    SuitModel suit;
    MotionState motion;
    std::vector<Vector3d> gyro_bias, accel_bias;
    std::vector<double> source_offset;
    double sound_scale = 0;
};

/// `truth` draws the world, `parameters` is what the filter believes.
Outcome run(const ManifoldParameters& truth, const ManifoldParameters& parameters, unsigned seed,
            double seconds) {
    World world(truth, seed);
    ManifoldFilter filter(testing::smallSkeleton(), world.suit, parameters);
    filter.start(testing::smallSkeleton().zeroPose(), {}, nullptr);
    constexpr int kFine = 8;  // steps of the truth per 1/140 s; boards read at different ones
    const double dt = 1.0 / (kInertialFramesPerSecond * kFine);
    Outcome outcome;
    std::vector<Vector3d> emitted;  // of the pulse under way
    double emission_s = 0;
    int source = 0, counted = 0;
    for (int k = 1; k < seconds / dt; ++k) {
        world.move(dt);
        const double t = k * dt;
        for (int b = 0; b < 4; ++b)
            if (k % kFine == 2 * b)
                filter.add(world.inertial(b, t));
        const MountedSource& s = world.suit.sources[static_cast<size_t>(source)];
        if (k % kFine == 1) {
            emission_s = t;
            emitted = {world.point(s.link, s.p_link_source)};
        }
        if (k % kFine ==
            3) {  // the flight takes two fine steps, whatever the distance: only times matter here
            for (int b = 0; b < 4; ++b) {
                const MountedBoard& board = world.suit.boards[static_cast<size_t>(b)];
                const double true_m = (world.point(board.link, board.p_link_mic) - emitted[0]).norm();
                const double measured_m = true_m * (1 + world.sound_scale) +
                                          world.source_offset[static_cast<size_t>(source)] +
                                          world.random(World::kDistanceSigma);
                filter.add(
                    DistanceMeasurement{0, source, b, emission_s, t, measured_m, World::kDistanceSigma, 1});
            }
            source = 1 - source;
        }
        if (k % kFine == 0)
            filter.add(RootMeasurement{
                t, world.motion.p_world_root + world.random.vector(0.0005),
                world.motion.q_parent_link[0] * expQuaternion(world.random.vector(0.0017)), 0.0005, 0.0017});
        if (k % (kFine * 7) != 0 || t < seconds / 3)
            continue;
        filter.advanceTo(t + 0.5 * dt + 0.5 / 140 / parameters.steps_per_frame);
        const VectorXd error = coordinateError(world.tree, world.motion, filter.state().motion);
        // With a free root its yaw and position are unobservable, and an EKF that holds velocity in the
        // world's frame gains false knowledge of them as its linearisation point moves; the joints are judged
        // alone there.
        const Eigen::Index n = error.size(), judged = parameters.root_given ? n : n - 6;
        const Eigen::MatrixXd P = filter.covariance().topLeftCorner(n, n);
        outcome.nees +=
            error.tail(judged).dot(P.bottomRightCorner(judged, judged).ldlt().solve(error.tail(judged))) /
            static_cast<double>(judged);
        outcome.mean_deg = degrees(error.tail(n - 6).cwiseAbs().mean());
        outcome.sigma_deg = degrees(P.diagonal().tail(n - 6).cwiseSqrt().mean());
        ++counted;
    }
    outcome.nees /= counted;
    outcome.resets = filter.resets();
    return outcome;
}

void expectConsistent(bool a, bool g, bool d, bool root_given, double lower, double upper) {
    ManifoldParameters parameters;
    parameters.sensors = {a, g, d};
    parameters.root_given = root_given;
    parameters.distance_floor_m = 0;
    parameters.steps_per_frame = 4;
    parameters.joints_give = false;
    parameters.root_velocity_prior_m_per_s = 1e6;
    parameters.joint_accel_rad_per_s2 = 5;
    parameters.root_turn_accel_rad_per_s2 = 15;
    double nees = 0;
    constexpr int kRuns = 12;
    for (unsigned seed = 1; seed <= kRuns; ++seed) {
        const Outcome outcome = run(parameters, parameters, seed, 4);
        nees += outcome.nees / kRuns;
        EXPECT_EQ(outcome.resets, 0);
        EXPECT_LT(outcome.mean_deg, 30) << "diverged, seed " << seed;
    }
    // The pose has 12 freedoms; its errors are correlated over about a second, so a run counts as a few
    // samples: the mean of 12 runs spreads by about 0.1.
    EXPECT_GT(nees, lower) << a << g << d;
    EXPECT_LT(nees, upper) << a << g << d;
}

TEST(Consistency, GyroscopesRootGiven) {
    expectConsistent(false, true, false, true, 0.7, 1.3);
}
TEST(Consistency, GyroscopesAndDistancesRootGiven) {
    expectConsistent(false, true, true, true, 0.7, 1.3);
}
TEST(Consistency, AccelerometersAndGyroscopesRootGiven) {
    expectConsistent(true, true, false, true, 0.7, 1.3);
}
TEST(Consistency, AllSensorsRootGiven) {
    expectConsistent(true, true, true, true, 0.7, 1.3);
}
TEST(Consistency, AllSensorsRootFree) {
    expectConsistent(true, true, true, false, 0.7, 1.3);
}

TEST(Consistency, OverconfidenceIsNoticed) {
    // The check itself must be able to fail: biases ten times as large as the filter believes.
    ManifoldParameters truth;
    truth.sensors = {false, true, false};
    truth.root_given = true;
    truth.joint_accel_rad_per_s2 = 15;
    truth.joints_give = false;
    ManifoldParameters believed = truth;
    believed.gyro_bias_rad_per_s = truth.gyro_bias_rad_per_s / 10;
    believed.initial_pose_rad = truth.initial_pose_rad / 3;
    double nees = 0;
    for (unsigned seed = 1; seed <= 4; ++seed)
        nees += run(truth, believed, seed, 4).nees / 4;
    EXPECT_GT(nees, 2);
}

}  // namespace
}  // namespace noctule
