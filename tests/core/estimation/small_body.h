// SPDX-License-Identifier: Apache-2.0
// A body small enough to check an estimator on many runs: free root, ball, universal and hinge, four boards
// and two sources, and a motion drawn from the very process the filter assumes.
#pragma once

#include <random>

#include "core/body/kinematics.h"
#include "core/estimation/manifold_filter.h"

namespace noctule::testing {

inline Skeleton smallSkeleton() {
    const auto dof = [](const char* name, const Vector3d& axis) { return DegreeOfFreedom{name, axis}; };
    std::vector<Joint> joints;
    joints.push_back({"Hips", -1, {0, 0, 0}, JointType::kFree, {}, {}, {}});
    joints.push_back({"Chest",
                      0,
                      {0, 0.3, 0},
                      JointType::kBall,
                      {dof("x", Vector3d::UnitX()), dof("y", Vector3d::UnitY()), dof("z", Vector3d::UnitZ())},
                      {},
                      {}});
    joints.push_back({"Arm",
                      1,
                      {0.2, 0.2, 0},
                      JointType::kUniversal,
                      {dof("raise", Vector3d::UnitZ()), dof("swing", Vector3d::UnitY())},
                      {},
                      {}});
    joints.push_back(
        {"ForeArm", 2, {0.3, 0, 0}, JointType::kHinge, {dof("flexion", Vector3d::UnitY())}, {}, {}});
    return Skeleton::make(joints).value();
}

inline Suit smallSuit() {
    Suit suit;
    suit.name = "small";
    const auto board = [](const char* id, const char* segment, const Vector3d& p, const Vector3d& turn) {
        Board b;
        b.id = id;
        b.segment = segment;
        b.p_segment_board_m = p;
        b.q_segment_board = Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
        b.p_board_mic_m = Vector3d(0.004, 0.002, 0.003);
        return b;
    };
    suit.boards = {board("hips", "Hips", {0, 0.05, 0.1}, {0.1, 0.4, 0}),
                   board("chest", "Chest", {0.02, 0.1, 0.12}, {1, 0, 0}),
                   board("arm", "Arm", {0.15, 0.03, 0.04}, {0, 0, 2}),
                   board("forearm", "ForeArm", {0.2, 0, 0.03}, {0.5, 0.5, 0})};
    const auto source = [](const char* id, const char* segment, const Vector3d& p) {
        Source s;
        s.id = id;
        s.segment = segment;
        s.p_segment_source_m = p;
        return s;
    };
    suit.sources = {source("belly", "Hips", {0.05, 0.1, 0.12}), source("breast", "Chest", {-0.1, 0.1, 0.12})};
    return suit;
}

inline Actor actorOf(const Skeleton& skeleton) {
    Actor actor;
    actor.skeleton = skeleton;
    actor.rest_q_parent_joint = skeleton.zeroPose().q_parent_joint;
    return actor;
}

class Gaussian {
public:
    explicit Gaussian(unsigned seed) : engine_(seed) {}
    double operator()(double sigma) { return std::normal_distribution<double>(0, 1)(engine_) * sigma; }
    Vector3d vector(double sigma) { return {(*this)(sigma), (*this)(sigma), (*this)(sigma)}; }
    Eigen::VectorXd vector(Eigen::Index n, double sigma) {
        return Eigen::VectorXd::NullaryExpr(n, [&] { return (*this)(sigma); });
    }

private:
    std::mt19937 engine_;
};

}  // namespace noctule::testing
