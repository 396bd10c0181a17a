// SPDX-License-Identifier: Apache-2.0
// A world that moves, and sensors that err, exactly as the manifold filter assumes.
#pragma once

#include "core/inertial/reading.h"
#include "core/math/rotation.h"
#include "tests/core/estimation/small_body.h"

namespace noctule::testing {

class World {
public:
    World(const ManifoldParameters& parameters, unsigned seed)
        : p(parameters),
          tree(smallSkeleton(), BallCoordinates::kManifold),
          random(seed),
          suit(mountSuit(smallSuit(), {}, actorOf(smallSkeleton()), tree).value()) {
        for (MountedBoard& board : suit.boards)
            board.sigma_mounting_rad = Vector3d::Zero();  // they hang exactly so
        motion = tree.stateFromPose(smallSkeleton().zeroPose());
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
        Eigen::VectorXd decay =
            Eigen::VectorXd::Constant(tree.freedoms(), std::exp(-dt / p.joint_accel_time_s));
        Eigen::VectorXd sigma = Eigen::VectorXd::Constant(tree.freedoms(), p.joint_accel_rad_per_s2);
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
            m.gyro.add({Vector3d::Unit(i), omega[i] + random(gyro_sigma), gyro_sigma});
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
    double gyro_sigma = kGyroSigma;
    ManifoldParameters p;
    KinematicTree tree;
    Gaussian random;
    SuitModel suit;
    MotionState motion;
    std::vector<Vector3d> gyro_bias, accel_bias;
    std::vector<double> source_offset;
    double sound_scale = 0;
};

/// A filter that believes what is so in this world. It begins 0.6 degrees off: where neighbours read at one
/// instant, gyroscopes find the angle of a hinge within seconds, and from 2 degrees off the first that they
/// say of it is false (1e-3 rad squared times the trunk's 10 rad/s is twice their noise), which no linear
/// update can know: NEES of gyroscopes alone would be 2.
inline ManifoldParameters fittingParameters(const SensorSelection& sensors, bool root_given) {
    ManifoldParameters parameters;
    parameters.sensors = sensors;
    parameters.root_given = root_given;
    parameters.distance_floor_m = 0;
    parameters.steps_per_frame = 4;
    parameters.joints_give = false;
    parameters.root_velocity_prior_m_per_s = 1e6;
    parameters.joint_accel_rad_per_s2 = 5;
    parameters.root_turn_accel_rad_per_s2 = 15;
    parameters.joint_accel_time_s = 0.1;
    parameters.initial_pose_rad = 0.01;
    parameters.motion_noise.memory_s = 1e9;
    return parameters;
}

constexpr int kFine = 8;  ///< steps of the truth per 1/140 s
constexpr double kFineStep_s = 1.0 / (kInertialFramesPerSecond * kFine);
constexpr double kUntilSure_s = 0.5 * kFineStep_s;  ///< after a frame

/// Moves the world and gives an estimator everything that its sensors say. Boards read at the frames: this
/// world's jerk is white, and between readings the filter takes motion for smooth. `at_frame(frame, time_s)`
/// is called 140 times a second with the world as it then is.
template <class AtFrame>
void play(World& world, Estimator& estimator, double seconds, const AtFrame& at_frame) {
    Vector3d emitted = Vector3d::Zero();  // of the pulse under way
    double emission_s = 0;
    int source = 0;
    for (int k = 1; k < seconds / kFineStep_s; ++k) {
        world.move(kFineStep_s);
        const double t = k * kFineStep_s;
        for (int b = 0; b < 4; ++b)
            if (k % kFine == 0)
                estimator.add(world.inertial(b, t));
        const MountedSource& s = world.suit.sources[static_cast<size_t>(source)];
        if (k % kFine == 1) {
            emission_s = t;
            emitted = world.point(s.link, s.p_link_source);
        }
        if (k % kFine ==
            3) {  // the flight takes two fine steps, whatever the distance: only times matter here
            for (int b = 0; b < 4; ++b) {
                const MountedBoard& board = world.suit.boards[static_cast<size_t>(b)];
                const double true_m = (world.point(board.link, board.p_link_mic) - emitted).norm();
                const double measured_m = true_m * (1 + world.sound_scale) +
                                          world.source_offset[static_cast<size_t>(source)] +
                                          world.random(World::kDistanceSigma);
                estimator.add(
                    DistanceMeasurement{0, source, b, emission_s, t, measured_m, World::kDistanceSigma, 1});
            }
            source = 1 - source;
        }
        if (k % kFine != 0)
            continue;
        estimator.add(RootMeasurement{
            t, world.motion.p_world_root + world.random.vector(0.0005),
            world.motion.q_parent_link[0] * expQuaternion(world.random.vector(0.0017)), 0.0005, 0.0017});
        at_frame(static_cast<int64_t>(k / kFine), t);
    }
}

}  // namespace noctule::testing
