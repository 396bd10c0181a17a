// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/prediction.h"

#include <cmath>

#include "core/math/rotation.h"

namespace noctule {
namespace {

// Below a microradian a component is rounding of an axis that the joint does not have.
constexpr double kLeastVariance = 1e-12;

/// How the error of one link's rotation (3 coordinates from `first`) is carried over a step in which it
/// turns.
struct Turn {
    int first;
    Matrix3d exp_u_transposed, right_jacobian;
};

/// x := F x for one column of the covariance: theta' = E^T theta + J (dt rate + dt^2/2 accel), rate' = rate +
/// dt accel, accel' = decay * accel; E and J are identity except in `turns`.
void transitionColumn(double* x, Eigen::Index n, double dt, const Eigen::VectorXd& decay,
                      const std::vector<Turn>& turns) {
    Eigen::Map<Eigen::VectorXd> theta(x, n), rate(x + n, n), accel(x + 2 * n, n);
    for (const Turn& turn : turns) {
        const Vector3d gained =
            dt * rate.segment<3>(turn.first) + 0.5 * dt * dt * accel.segment<3>(turn.first);
        // Written so that the plain gain below completes it.
        theta.segment<3>(turn.first) =
            turn.exp_u_transposed * theta.segment<3>(turn.first) + turn.right_jacobian * gained - gained;
    }
    theta += dt * rate + 0.5 * dt * dt * accel;
    rate += dt * accel;
    accel.array() *= decay.array();
}

void addProcessNoise(Eigen::MatrixXd& P, Eigen::Index n, double dt, const Eigen::VectorXd& decay,
                     const Eigen::VectorXd& variance) {
    for (Eigen::Index i = 0; i < n; ++i) {
        // White jerk of density q over the step; for steps short against the decay time the exact integrals
        // of the Ornstein-Uhlenbeck process differ from these in relative order dt / decay time.
        const double per_step = (1 - decay[i] * decay[i]) * variance[i];
        const double q = per_step / dt;
        const Eigen::Index r = n + i, a = 2 * n + i;
        P(i, i) += q * std::pow(dt, 5) / 20;
        P(i, r) += q * std::pow(dt, 4) / 8;
        P(r, i) = P(i, r);
        P(i, a) += q * dt * dt * dt / 6;
        P(a, i) = P(i, a);
        P(r, r) += q * dt * dt * dt / 3;
        P(r, a) += q * dt * dt / 2;
        P(a, r) = P(r, a);
        P(a, a) += per_step;
    }
}

/// P := F P F^T. Both sides of one link's columns at a time: the matrix is as large as a processor's cache,
/// and each pass over it costs as much as the arithmetic.
void transition(const KinematicTree& tree, Eigen::MatrixXd& P, double dt, const Eigen::VectorXd& decay,
                const std::vector<Turn>& turns) {
    const Eigen::Index n = tree.freedoms();
    Eigen::Matrix<double, Eigen::Dynamic, 3> gained(P.rows(), 3), turned(P.rows(), 3);
    auto turn = turns.begin();
    for (const Link& link : tree.links()) {
        for (Eigen::Index i = link.first; i < link.first + link.count; ++i)
            for (Eigen::Index c : {i, n + i, 2 * n + i})
                transitionColumn(P.col(c).data(), n, dt, decay, turns);
        if (turn != turns.end() && turn->first < link.first + link.count) {
            gained =
                dt * P.middleCols<3>(n + turn->first) + 0.5 * dt * dt * P.middleCols<3>(2 * n + turn->first);
            turned = P.middleCols<3>(turn->first).lazyProduct(turn->exp_u_transposed.transpose());
            turned += gained.lazyProduct((turn->right_jacobian - Matrix3d::Identity()).transpose());
            P.middleCols<3>(turn->first) = turned;
            ++turn;
        }
        for (Eigen::Index i = link.first; i < link.first + link.count; ++i) {
            P.col(i) += dt * P.col(n + i) + 0.5 * dt * dt * P.col(2 * n + i);
            P.col(n + i) += dt * P.col(2 * n + i);
            P.col(2 * n + i) *= decay[i];
        }
    }
    for (Eigen::Index c = 3 * n; c < P.cols(); ++c)
        transitionColumn(P.col(c).data(), n, dt, decay, turns);
}

}  // namespace

void predictMotion(const KinematicTree& tree, MotionState& motion, Eigen::MatrixXd& P, double dt_s,
                   const Eigen::VectorXd& decay, const Eigen::VectorXd& acceleration_variance) {
    const Eigen::Index n = tree.freedoms();
    std::vector<Turn> turns;
    const Eigen::VectorXd advance = dt_s * motion.rate + 0.5 * dt_s * dt_s * motion.accel;
    for (const Link& link : tree.links()) {
        const int first = link.first + (link.type == LinkType::kFree ? 3 : 0);
        if (link.type == LinkType::kBall || (link.type == LinkType::kFree && link.count == 6)) {
            const Vector3d u = advance.segment<3>(first);
            turns.push_back({first, expQuaternion(u).toRotationMatrix().transpose(), rightJacobian(u)});
        }
    }
    transition(tree, P, dt_s, decay, turns);
    addProcessNoise(P, n, dt_s, decay, acceleration_variance);
    tree.retract(motion, advance);
    motion.rate += dt_s * motion.accel;
    motion.accel.array() *= decay.array();
}

std::vector<double> jointSigmas(const KinematicTree& tree, const Skeleton& skeleton,
                                const MotionState& motion, const Eigen::MatrixXd& P, double flesh_rad2) {
    std::vector<double> sigmas;
    for (int j = 0; j < skeleton.size(); ++j) {
        // Columns: how the joint's rotation (right perturbation) follows the coordinates of its links, last
        // first.
        Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> axes(3, 0);
        std::vector<int> indices;
        Matrix3d R_link_joint = Matrix3d::Identity();
        for (int l = tree.linkOfJoint(j); l >= 0 && tree.link(l).joint == j; l = tree.link(l).parent) {
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
        for (int i = 0; i < 3; ++i)
            sigmas.push_back(covariance(i, i) > kLeastVariance ? std::sqrt(covariance(i, i) + flesh_rad2)
                                                               : 0);
    }
    return sigmas;
}

}  // namespace noctule
