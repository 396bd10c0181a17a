// SPDX-License-Identifier: Apache-2.0
#include "core/body/kinematics.h"

#include <gtest/gtest.h>

#include <random>

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "tests/support/jacobian_checker.h"

namespace noctule {
namespace {

using Eigen::VectorXd;
using testing::expectJacobian;

class Moving {
public:
    Moving(BallCoordinates balls, double size, unsigned seed)
        : tree(defaultActor().skeleton, balls), engine_(seed) {
        state = tree.stateFromPose(defaultActor().skeleton.zeroPose());
        tree.retract(state, random(tree.freedoms(), size));
        state.rate = random(tree.freedoms(), 4 * size);
        state.accel = random(tree.freedoms(), 30 * size);
    }
    /// The state with coordinates, rates or accelerations (part 0, 1, 2) perturbed.
    MotionState perturbed(int part, const VectorXd& delta) const {
        MotionState moved = state;
        if (part == 0)
            tree.retract(moved, delta);
        (part == 1 ? moved.rate : moved.accel) += part == 0 ? VectorXd::Zero(delta.size()).eval() : delta;
        return moved;
    }
    VectorXd random(int n, double size) {
        std::normal_distribution<double> normal(0, size);
        return VectorXd::NullaryExpr(n, [&] { return normal(engine_); });
    }

    KinematicTree tree;
    MotionState state;

private:
    std::mt19937 engine_;
};

/// Position, velocity, acceleration of a point, angular velocity, and the rotation against `R0` as one
/// vector.
VectorXd quantities(const KinematicTree& tree, const MotionState& state, int link, double offset_s,
                    const Vector3d& p_link, const Matrix3d& R0) {
    ChainMotion chain;
    chain.evaluate(tree, state, link, offset_s);
    const auto point = chain.point(p_link);
    const Quaterniond turn((chain.end().R_world_link * R0.transpose()).eval());
    VectorXd all(15);
    all << point.p_m, point.v_m_per_s, point.a_m_per_s2, chain.end().omega_rad_per_s, logQuaternion(turn);
    return all;
}

void checkAllJacobians(const Moving& moving, const std::string& joint, double offset_s) {
    const int link = moving.tree.linkOfJoint(defaultActor().skeleton.find(joint));
    const Vector3d p_link(0.05, -0.11, 0.07);
    ChainMotion chain;
    chain.evaluate(moving.tree, moving.state, link, offset_s);
    const auto point = chain.point(p_link);
    const Eigen::Index n = static_cast<Eigen::Index>(chain.coordinates().size());
    ChainMotion::Columns columns{Eigen::MatrixXd::Zero(15, n), Eigen::MatrixXd::Zero(15, n),
                                 Eigen::MatrixXd::Zero(15, n)};
    for (Eigen::Index k = 0; k < n; ++k) {
        const auto& c = chain.coordinates()[static_cast<size_t>(k)];
        const auto d = chain.pointDerivative(c, point);
        const Vector3d axis = chain.rotationByTheta(c);
        columns.theta.col(k) << d.p_theta, d.v_theta, d.a_theta, chain.omegaByTheta(c), axis;
        columns.rate.col(k) << Vector3d::Zero(), d.v_rate, d.a_rate, axis, Vector3d::Zero();
        columns.accel.col(k) << Vector3d::Zero(), Vector3d::Zero(), d.a_accel, Vector3d::Zero(),
            Vector3d::Zero();
    }
    chain.transportToState(columns);
    const Matrix3d R0 = chain.end().R_world_link;
    for (int part = 0; part < 3; ++part) {
        Eigen::MatrixXd full = Eigen::MatrixXd::Zero(15, moving.tree.freedoms());
        const auto& part_columns = part == 0 ? columns.theta : part == 1 ? columns.rate : columns.accel;
        for (Eigen::Index k = 0; k < n; ++k)
            full.col(chain.coordinates()[static_cast<size_t>(k)].index) = part_columns.col(k);
        expectJacobian(
            [&](const VectorXd& delta) {
                return quantities(moving.tree, moving.perturbed(part, delta), link, offset_s, p_link, R0);
            },
            full, joint + ", part " + std::to_string(part));
    }
}

TEST(Kinematics, JacobiansOfManifoldCoordinates) {
    for (double size : {0.0, 1e-6, 0.3, 1.0, 2.5})
        for (const char* joint : {"Hips", "Head", "LeftHand", "RightFoot", "LeftToeBase"})
            for (double offset_s : {0.0, -0.008, 0.05})
                checkAllJacobians(Moving(BallCoordinates::kManifold, size, 7), joint, offset_s);
}

TEST(Kinematics, JacobiansOfEulerCoordinates) {
    for (double size : {0.0, 0.3, 1.0})
        for (const char* joint : {"Hips", "RightHand", "LeftFoot"})
            checkAllJacobians(Moving(BallCoordinates::kEuler, size, 11), joint, 0.0);
}

TEST(Kinematics, VelocityAndAccelerationAreTimeDerivatives) {
    const Moving moving(BallCoordinates::kManifold, 0.7, 3);
    const int link = moving.tree.linkOfJoint(defaultActor().skeleton.find("LeftHand"));
    const Vector3d p_link(0.1, 0.02, -0.03);
    const auto at = [&](double t) {
        ChainMotion chain;
        chain.evaluate(moving.tree, moving.state, link, t);
        return chain;
    };
    // The state is carried with a constant rotation vector rate, which is exact to first order in alpha x
    // omega; compare at the state's own time with small steps.
    const double h = 1e-4;
    const auto p = [&](double t) { return at(t).point(p_link).p_m; };
    const auto now = at(0).point(p_link);
    EXPECT_LT(((p(h) - p(-h)) / (2 * h) - now.v_m_per_s).norm(), 1e-4 * now.v_m_per_s.norm());
    EXPECT_LT(((p(h) - 2 * p(0) + p(-h)) / (h * h) - now.a_m_per_s2).norm(), 1e-4 * now.a_m_per_s2.norm());
    const Matrix3d spin = (at(h).end().R_world_link - at(-h).end().R_world_link) / (2 * h) *
                          at(0).end().R_world_link.transpose();
    EXPECT_LT((spin - skew(at(0).end().omega_rad_per_s)).norm(), 1e-4 * at(0).end().omega_rad_per_s.norm());
}

TEST(Kinematics, AgreesWithGlobalPose) {
    for (BallCoordinates balls : {BallCoordinates::kManifold, BallCoordinates::kEuler}) {
        const Moving moving(balls, 0.8, 5);
        const Skeleton& skeleton = defaultActor().skeleton;
        const Pose pose = moving.tree.poseFromState(moving.state);
        const GlobalPose global = globalPose(skeleton, pose);
        for (int j = 0; j < skeleton.size(); ++j) {
            ChainMotion chain;
            chain.evaluate(moving.tree, moving.state, moving.tree.linkOfJoint(j), 0);
            EXPECT_LT((chain.end().p_m - global.p_world_joint[static_cast<size_t>(j)]).norm(), 1e-12);
            const Quaterniond q(chain.end().R_world_link);
            EXPECT_LT(angleBetween(q, global.q_world_joint[static_cast<size_t>(j)]), 1e-7);
        }
    }
}

TEST(Kinematics, PoseSurvivesTheWayThroughTheState) {
    for (BallCoordinates balls : {BallCoordinates::kManifold, BallCoordinates::kEuler}) {
        const Moving moving(balls, 0.5, 9);
        const Pose pose = moving.tree.poseFromState(moving.state);
        const Pose again = moving.tree.poseFromState(moving.tree.stateFromPose(pose));
        for (size_t j = 0; j < pose.q_parent_joint.size(); ++j)
            EXPECT_LT(angleBetween(pose.q_parent_joint[j], again.q_parent_joint[j]), 1e-6) << j;
    }
}

}  // namespace
}  // namespace noctule
