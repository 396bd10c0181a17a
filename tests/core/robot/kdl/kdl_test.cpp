// SPDX-License-Identifier: Apache-2.0
// Forward kinematics and Jacobians against Orocos KDL, which reads the same URDF with a parser of its own.
#include <filesystem>
#include <fstream>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl_parser/kdl_parser.hpp>
#include <sstream>

#include "core/robot/inverse_kinematics.h"
#include "tests/core/robot/robots.h"

namespace noctule::robot {
namespace {

constexpr int kPostures = 200;

struct ChainOf {
    const char *file, *base, *tip;
};
constexpr ChainOf kChains[] = {{"panda/panda.urdf", "panda_link0", "panda_link8"},
                               {"ur5/ur5.urdf", "base_link", "tool0"},
                               {"baxter/baxter.urdf", "base", "right_wrist"},
                               {"robonaut2/r2.urdf", "waist_center", "right_palm"},
                               {"unitree_g1/g1_29dof_rev_1_0.urdf", "torso_link", "right_wrist_yaw_link"},
                               {"unitree_g1/g1_29dof_rev_1_0.urdf", "pelvis", "left_ankle_roll_link"}};

std::string textOf(const std::string& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

class AgainstKdl : public WithRobots, public testing::WithParamInterface<ChainOf> {};

TEST_P(AgainstKdl, ForwardKinematicsAndJacobianAreTheSame) {
    const ChainOf& one = GetParam();
    const Chain ours = chain(one.file, one.base, one.tip);
    KDL::Tree tree;
    ASSERT_TRUE(kdl_parser::treeFromString(textOf(kRobots + one.file), tree));
    KDL::Chain theirs;
    ASSERT_TRUE(tree.getChain(one.base, one.tip, theirs));
    const auto joints = static_cast<unsigned>(ours.size());
    ASSERT_EQ(theirs.getNrOfJoints(), joints);
    KDL::ChainFkSolverPos_recursive place(theirs);
    KDL::ChainJntToJacSolver slope(theirs);
    RandomPostures random(21);
    ChainState state;
    PointJacobian of_place, of_turn;
    for (int i = 0; i < kPostures; ++i) {
        const JointVector q = random.next(ours);
        KDL::JntArray kdl_q(joints);
        kdl_q.data = q;
        KDL::Frame tip;
        KDL::Jacobian J(joints);
        ASSERT_GE(place.JntToCart(kdl_q, tip), 0);
        ASSERT_GE(slope.JntToJac(kdl_q, J), 0);
        ours.forward(q, state);
        for (int r = 0; r < 3; ++r) {
            ASSERT_NEAR(state.p_base_tip[r], tip.p[r], 1e-9);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(state.R_base_tip(r, c), tip.M(r, c), 1e-9);
        }
        ours.pointJacobian(state, ours.size() - 1, state.p_base_tip, of_place);
        ours.turnJacobian(state, ours.size() - 1, of_turn);
        ASSERT_LT((of_place - J.data.topRows(3)).cwiseAbs().maxCoeff(), 1e-9);
        ASSERT_LT((of_turn - J.data.bottomRows(3)).cwiseAbs().maxCoeff(), 1e-9);
    }
}

std::string nameOf(const testing::TestParamInfo<ChainOf>& info) {
    return std::filesystem::path(info.param.file).parent_path().string() + "_" + info.param.tip;
}

INSTANTIATE_TEST_SUITE_P(Robots, AgainstKdl, testing::ValuesIn(kChains), nameOf);

}  // namespace
}  // namespace noctule::robot
