// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/prediction.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"

namespace noctule {
namespace {

// Below a microradian a component is rounding of an axis that the joint does not have.
constexpr double kLeastVariance = 1e-12;

void addProcessNoise(Eigen::MatrixXd& P, Eigen::Index n, double dt, const Eigen::VectorXd& decay,
                     const Eigen::VectorXd& variance) {
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Array3i all =
            Eigen::Array3i::LinSpaced(3, 0, 2) * static_cast<int>(n) + static_cast<int>(i);
        P(all, all) += motionNoise(dt, decay[i], variance[i]);
    }
}

}  // namespace

LinkTransitions motionTransition(const KinematicTree& tree, const MotionState& motion, double dt_s,
                                 const Eigen::VectorXd& decay, const LinkTransitions& shift) {
    LinkTransitions transitions{tree.freedoms(), dt_s};
    const Eigen::VectorXd advance = dt_s * motion.rate + 0.5 * dt_s * dt_s * motion.accel;
    for (const Link& link : tree.links()) {
        const int turning =
            link.type == LinkType::kBall || (link.type == LinkType::kFree && link.count == 6) ? 3 : 0;
        const int rotation = link.first + link.count - turning;
        for (int i = link.first; i < rotation; ++i) {
            transitions.links.emplace_back();
            transitions.links.back().first = i;
            transitions.links.back().decay[0] = decay[i];
        }
        if (turning > 0) {
            const Vector3d u = advance.segment<3>(rotation);
            transitions.links.push_back({.first = rotation,
                                         .count = turning,
                                         .turn = expQuaternion(u).toRotationMatrix().transpose(),
                                         .jacobian = rightJacobian(u),
                                         .decay = decay.segment<3>(rotation)});
        }
    }
    transitions.beginWith(shift);
    return transitions;
}

Matrix3d motionNoise(double dt, double decay, double variance) {
    // For steps short against the decay time the exact integrals of the Ornstein-Uhlenbeck process differ
    // from these in relative order dt / decay time.
    const double per_step = (1 - decay * decay) * variance;
    const double q = per_step / dt;
    const double theta_rate = q * std::pow(dt, 4) / 8, theta_accel = q * dt * dt * dt / 6,
                 rate_accel = q * dt * dt / 2;
    Matrix3d noise;
    noise << q * std::pow(dt, 5) / 20, theta_rate, theta_accel, theta_rate, q * dt * dt * dt / 3, rate_accel,
        theta_accel, rate_accel, per_step;
    return noise;
}

void predictMotion(const KinematicTree& tree, MotionState& motion, double dt_s,
                   const Eigen::VectorXd& decay) {
    tree.retract(motion, dt_s * motion.rate + 0.5 * dt_s * dt_s * motion.accel);
    motion.rate += dt_s * motion.accel;
    motion.accel.array() *= decay.array();
}

LinkTransitions predictMotion(const KinematicTree& tree, MotionState& motion, Eigen::MatrixXd& P, double dt_s,
                              const Eigen::VectorXd& decay, const Eigen::VectorXd& acceleration_variance,
                              const LinkTransitions& shift) {
    LinkTransitions transition = motionTransition(tree, motion, dt_s, decay, shift);
    transition.carry(P);
    addProcessNoise(P, tree.freedoms(), dt_s, decay, acceleration_variance);
    predictMotion(tree, motion, dt_s, decay);
    return transition;
}

std::vector<double> jointSigmas(const KinematicTree& tree, const Skeleton& skeleton,
                                const MotionState& motion, const Eigen::MatrixXd& P, double flesh_rad2,
                                const std::vector<Matrix3d>& mounting_rad2) {
    std::vector<double> sigmas;
    for (int j = 0; j < skeleton.size(); ++j) {
        // Columns: how the joint's rotation (right perturbation) follows the coordinates of its links, last
        // first.
        Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> axes(3, 0);
        std::vector<int> indices;
        Matrix3d R_link_joint = Matrix3d::Identity();
        int l = tree.linkOfJoint(j);
        const int own = l;
        for (; l >= 0 && tree.link(l).joint == j; l = tree.link(l).parent) {
            const Link& link = tree.link(l);
            const int rotations = link.type == LinkType::kFree ? link.count - 3 : link.count;
            for (int k = 0; k < rotations; ++k) {
                const Vector3d axis = link.type == LinkType::kHinge ? link.axis : Vector3d::Unit(k);
                axes.conservativeResize(3, axes.cols() + 1);
                axes.rightCols<1>() = R_link_joint.transpose() * axis;
                indices.push_back(link.first + link.count - rotations + k);
            }
            R_link_joint = motion.q_parent_link[static_cast<size_t>(l)].toRotationMatrix() * R_link_joint;
        }
        Matrix3d covariance = Matrix3d::Zero();
        for (size_t a = 0; a < indices.size(); ++a)
            for (size_t b = 0; b < indices.size(); ++b)
                covariance += P(indices[a], indices[b]) * axes.col(static_cast<Eigen::Index>(a)) *
                              axes.col(static_cast<Eigen::Index>(b)).transpose();
        for (; l >= 0 && tree.link(l).count == 0; l = tree.link(l).parent)  // a fixed joint, as a neck
            R_link_joint = motion.q_parent_link[static_cast<size_t>(l)].toRotationMatrix() * R_link_joint;
        Matrix3d mountings = Matrix3d::Zero();
        if (!mounting_rad2.empty())
            mountings = mounting_rad2[static_cast<size_t>(own)];
        if (!mounting_rad2.empty() && l >= 0)
            mountings += R_link_joint.transpose() * mounting_rad2[static_cast<size_t>(l)] * R_link_joint;
        for (int i = 0; i < 3; ++i)
            sigmas.push_back(covariance(i, i) > kLeastVariance
                                 ? std::sqrt(covariance(i, i) + std::max(flesh_rad2, mountings(i, i)))
                                 : 0);
    }
    return sigmas;
}

}  // namespace noctule
