// SPDX-License-Identifier: Apache-2.0
#include "core/posing/pose_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/body/usual_pose.h"
#include "core/estimation/prediction.h"
#include "core/math/linear_solvers.h"
#include "core/math/rotation.h"

namespace noctule::posing {

namespace {

constexpr int kFirstSteps = 12, kSteps = 3;
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kUntold_rad = 1;    ///< of a joint of which nothing is known
constexpr double kLimit_rad = 0.05;  ///< beyond a hinge's limit

}  // namespace

struct PoseFit::System {
    explicit System(int freedoms)
        : N(Eigen::MatrixXd::Zero(freedoms, freedoms)), right(Eigen::VectorXd::Zero(freedoms)) {}
    Eigen::MatrixXd N;
    Eigen::VectorXd right;

    void add(int index, double error, double sigma) {
        N(index, index) += 1 / (sigma * sigma);
        right[index] += error / (sigma * sigma);
    }
};

PoseFit::PoseFit(const Skeleton& skeleton, const Pose& start, const PoseFitSettings& settings)
    : skeleton_(skeleton),
      tree_(skeleton, BallCoordinates::kManifold),
      settings_(settings),
      now_(tree_.stateFromPose(start)) {
    Pose usual = start;
    usual_sigma_rad_ = Eigen::VectorXd::Constant(tree_.freedoms(), kNever);
    for (int j = 1; j < skeleton.size(); ++j) {
        const auto learned = usualTurn(skeleton.joint(j).name);
        if (learned)
            usual.q_parent_joint[size_t(j)] = learned->q_parent_joint;
        for (int l = tree_.linkOfJoint(j); l >= 0 && tree_.link(l).joint == j; l = tree_.link(l).parent)
            for (int c = 0; c < tree_.link(l).count; ++c)
                usual_sigma_rad_[tree_.link(l).first + c] =
                    learned ? std::max(0.1, learned->sigma_rad.maxCoeff()) : settings.usual_rad;
    }
    usual_sigma_rad_[3] = usual_sigma_rad_[5] = settings.upright_rad;
    usual_ = tree_.stateFromPose(usual);
}

std::vector<Quaterniond> PoseFit::worldTurns() const {
    std::vector<Quaterniond> out;
    for (size_t l = 0; l < tree_.links().size(); ++l) {
        const int parent = tree_.links()[l].parent;
        out.push_back(parent < 0 ? now_.q_parent_link[l] : out[size_t(parent)] * now_.q_parent_link[l]);
    }
    return out;
}

void PoseFit::addAttitudes(const std::vector<SegmentAttitude>& attitudes, System& system) const {
    const auto q_world_link = worldTurns();
    for (const SegmentAttitude& told : attitudes) {
        if (told.weight <= 0)
            continue;
        const int link = tree_.linkOfJoint(told.joint);
        const Vector3d error = logQuaternion(told.q_world_segment * q_world_link[size_t(link)].conjugate());
        const double heading = std::hypot(settings_.heading_rad, told.heading_sigma_rad);
        const Vector3d weight =
            told.weight * Vector3d(settings_.tilt_rad, heading, settings_.tilt_rad).array().pow(-2).matrix();
        std::vector<std::pair<int, Vector3d>> columns;
        for (const int l : tree_.chain(link)) {
            const Link& one = tree_.link(l);
            const Matrix3d R = q_world_link[size_t(l)].toRotationMatrix();
            if (one.type == LinkType::kHinge)
                columns.emplace_back(one.first, R * one.axis);
            else if (one.count > 0)
                for (int c = 0; c < 3; ++c)
                    columns.emplace_back(one.first + one.count - 3 + c, R.col(c));
        }
        for (const auto& [i, a] : columns) {
            system.right[i] += a.dot(weight.cwiseProduct(error));
            for (const auto& [j, b] : columns)
                system.N(i, j) += a.dot(weight.cwiseProduct(b));
        }
    }
}

/// How far the usual pose counts, per joint: not at all where sensors tell both segments.
std::vector<double> PoseFit::untold(const std::vector<SegmentAttitude>& attitudes) const {
    std::vector<double> told(size_t(skeleton_.size()), 0.0);
    for (const SegmentAttitude& one : attitudes)
        told[size_t(one.joint)] = std::max(told[size_t(one.joint)], one.weight);
    std::vector<double> out(told.size());
    for (size_t j = 0; j < told.size(); ++j) {
        const int parent = skeleton_.joint(int(j)).parent;
        out[j] = 1 - std::min(told[j], parent < 0 ? 1.0 : told[size_t(parent)]);
    }
    return out;
}

void PoseFit::addUsual(const std::vector<double>& untold, System& system) const {
    for (size_t l = 0; l < tree_.links().size(); ++l) {
        const Link& link = tree_.links()[l];
        const double share = untold[size_t(link.joint)];
        if (share <= 0 || link.count == 0)
            continue;
        const auto add = [&](int index, double error) {
            if (std::isfinite(usual_sigma_rad_[index]))
                system.add(index, error, usual_sigma_rad_[index] / std::sqrt(share));
        };
        if (link.type == LinkType::kHinge) {
            add(link.first, usual_.angle_rad[l] - now_.angle_rad[l]);
            continue;
        }
        const Quaterniond& q = now_.q_parent_link[l];
        Vector3d usual = logQuaternion(q.conjugate() * usual_.q_parent_link[l]);
        if (link.parent < 0)  // a root without a sensor is held upright, whatever its heading
            usual = Vector3d::UnitY().cross(q.conjugate() * Vector3d::UnitY());
        for (int c = 0; c < 3; ++c)
            add(link.first + link.count - 3 + c, usual[c]);
    }
}

void PoseFit::addSteps(const MotionState& before, double dt_s, System& system) const {
    const double step = settings_.step_rad_per_s * dt_s;
    for (size_t l = 0; l < tree_.links().size(); ++l) {
        const Link& link = tree_.links()[l];
        if (link.type == LinkType::kHinge) {
            const double angle = now_.angle_rad[l];
            system.add(link.first, before.angle_rad[l] - angle, step);
            const double inside = std::clamp(angle, link.min_rad, link.max_rad);
            if (inside != angle)
                system.add(link.first, inside - angle, kLimit_rad);
            continue;
        }
        if (link.count == 0)
            continue;
        const int rotation = link.first + link.count - 3;
        const Quaterniond& q = now_.q_parent_link[l];
        const Vector3d back = logQuaternion(q.conjugate() * before.q_parent_link[l]);
        for (int c = 0; c < 3; ++c)
            system.add(rotation + c, back[c], step);
        for (int c = link.first; c < rotation; ++c)
            system.add(c, 0, 1e-3);
    }
}

FittedPose PoseFit::next(const std::vector<SegmentAttitude>& attitudes, double dt_s) {
    const MotionState before = now_;
    const auto usual_share = untold(attitudes);
    const int steps = started_ ? kSteps : kFirstSteps;
    const double dt = started_ ? dt_s : 10;
    for (int step = 0; step < steps; ++step) {
        System system(tree_.freedoms());
        addAttitudes(attitudes, system);
        addUsual(usual_share, system);
        addSteps(before, dt, system);
        const Eigen::VectorXd change = solvePositive(system.N, system.right);
        tree_.retract(now_, change);
        if (change.norm() < 1e-4)
            break;
    }
    started_ = true;
    // The priors from step to step hold what has no sensor; they are no knowledge of its angle.
    System told(tree_.freedoms());
    addAttitudes(attitudes, told);
    addUsual(usual_share, told);
    for (int i = 0; i < tree_.freedoms(); ++i)
        told.add(i, 0, kUntold_rad);
    const Eigen::MatrixXd P =
        solvePositive(told.N, Eigen::MatrixXd::Identity(tree_.freedoms(), tree_.freedoms()));
    return {tree_.poseFromState(now_), jointSigmas(tree_, skeleton_, now_, P)};
}

}  // namespace noctule::posing
