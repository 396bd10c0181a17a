// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/math/rotation.h"
#include "core/robot/inverse_kinematics.h"
#include "tests/core/robot/robots.h"
#include "tests/support/jacobian_checker.h"

namespace noctule::robot {
namespace {

JointVector vectorOf(const nlohmann::json& list) {
    JointVector q(static_cast<Eigen::Index>(list.size()));
    for (size_t i = 0; i < list.size(); ++i)
        q[static_cast<Eigen::Index>(i)] = list[i].get<double>();
    return q;
}

class RobotKinematics : public WithRobots {};

TEST_F(RobotKinematics, AgreesWithTheGoldenFile) {
    std::ifstream file(kRobots + "fk_golden.json");
    const nlohmann::json golden = nlohmann::json::parse(file);
    ASSERT_EQ(golden.size(), 10u);
    for (const auto& one : golden) {
        const Chain arm = chain(one["file"], one["base"], one["tip"]);
        ASSERT_EQ(static_cast<size_t>(arm.size()), one["joints"].size());
        for (int i = 0; i < arm.size(); ++i)
            EXPECT_EQ(arm.joint(i).name, one["joints"][static_cast<size_t>(i)].get<std::string>());
        EXPECT_LT((arm.lower() - vectorOf(one["lower"])).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_LT((arm.upper() - vectorOf(one["upper"])).cwiseAbs().maxCoeff(), 1e-12);
        ChainState state;
        for (const auto& posture : one["cases"]) {
            arm.forward(vectorOf(posture["q"]), state);
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(state.p_base_tip[i], posture["p"][static_cast<size_t>(i)].get<double>(), 1e-9);
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c) {
                    const auto& row = posture["R"][static_cast<size_t>(r)];
                    EXPECT_NEAR(state.R_base_tip(r, c), row[static_cast<size_t>(c)].get<double>(), 1e-9);
                }
        }
    }
}

/// A chain whose prismatic joint and skew axes no robot of the data has.
constexpr const char* kSkewArm = R"(<robot name="skew">
 <link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/>
 <joint name="turn" type="revolute"><parent link="a"/><child link="b"/><axis xyz="1 2 3"/>
  <origin xyz="0.1 0.2 0.3" rpy="0.3 -0.2 0.5"/><limit lower="-2" upper="2" velocity="1" effort="1"/></joint>
 <joint name="slide" type="prismatic"><parent link="b"/><child link="c"/><axis xyz="0 -1 1"/>
  <origin xyz="0 0.1 0" rpy="0 0.7 0"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
 <joint name="spin" type="continuous"><parent link="c"/><child link="d"/><axis xyz="0 0 -1"/>
  <origin xyz="0.2 0 0.1"/></joint>
 <joint name="tool" type="fixed"><parent link="d"/><child link="e"/><origin xyz="0 0 0.2" rpy="0 1 0"/></joint>
</robot>)";

void expectChainJacobians(const Chain& chain, const JointVector& q, const std::string& what) {
    ChainState state, moved;
    chain.forward(q, state);
    PointJacobian J;
    for (int last = 0; last < chain.size(); ++last) {
        const auto at = static_cast<size_t>(last);
        const Vector3d p_link(0.1, -0.2, 0.3);
        // A point that the joint carries: behind a prismatic joint it slides along.
        const auto pointAt = [&](const ChainState& s) {
            return Vector3d(last + 1 < chain.size() ? s.p_base_joint[at + 1] : s.p_base_tip);
        };
        chain.pointJacobian(state, last, pointAt(state), J);
        testing::expectJacobian(
            [&](const Eigen::VectorXd& d) -> Eigen::VectorXd {
                chain.forward(q + d, moved);
                return pointAt(moved);
            },
            J, what + ", point behind " + chain.joint(last).name);
        chain.turnJacobian(state, last, J);
        testing::expectJacobian(
            [&](const Eigen::VectorXd& d) -> Eigen::VectorXd {
                chain.forward(q + d, moved);
                return logQuaternion(Quaterniond(moved.R_base_link[at] * state.R_base_link[at].transpose()));
            },
            J, what + ", turn of " + chain.joint(last).name);
    }
}

TEST(RobotJacobian, OfAChainWithASlideAgreesWithDifferences) {
    const auto model = parseUrdf(kSkewArm, "skew arm");
    ASSERT_TRUE(model) << model.error().text();
    const auto chain = Chain::make(*model, "a", "e");
    ASSERT_TRUE(chain);
    RandomPostures random(7);
    expectChainJacobians(*chain, JointVector::Zero(3), "at zero");
    for (int i = 0; i < 5; ++i)
        expectChainJacobians(*chain, random.next(*chain), "at random");
}

TEST_F(RobotKinematics, JacobiansOfRobonautAgreeWithDifferences) {
    const Chain arm = chain("robonaut2/r2.urdf", "waist_center", "right_palm");
    RandomPostures random(8);
    for (int i = 0; i < 5; ++i)
        expectChainJacobians(arm, random.next(arm), "Robonaut 2");
}

TEST(RobotJacobian, OfTheTurnErrorAgreesWithDifferences) {
    for (const double angle : {0.0, 1e-6, 1e-3, 0.5, 2.0, 3.1}) {
        const Matrix3d R = expQuaternion(Vector3d(0.3, -0.8, 0.4)).toRotationMatrix();
        const Vector3d axis = Vector3d(1, -2, 0.5).normalized();
        const Matrix3d R_target = expQuaternion(axis * angle).toRotationMatrix() * R;
        testing::expectJacobian(
            [&](const Eigen::VectorXd& d) -> Eigen::VectorXd {
                return turnError(R_target, expQuaternion(Vector3d(d)).toRotationMatrix() * R).error;
            },
            turnError(R_target, R).by_turn, "turn error at " + std::to_string(angle), 1e-6);
    }
}

struct ArmOf {
    const char *file, *base, *tip;
};
constexpr ArmOf kArms[] = {{"panda/panda.urdf", "panda_link0", "panda_link8"},
                           {"ur5/ur5.urdf", "base_link", "tool0"},
                           {"baxter/baxter.urdf", "base", "right_wrist"},
                           {"robonaut2/r2.urdf", "waist_center", "right_palm"},
                           {"unitree_g1/g1_29dof_rev_1_0.urdf", "torso_link", "right_wrist_yaw_link"}};

// The protocol of TRAC-IK: reachable targets, from the middle pose. Time is counted in iterations.
TEST_F(RobotKinematics, FindsAPostureForNearlyEveryReachablePlace) {
    constexpr int kTargets = 1000;
    for (const ArmOf& one : kArms) {
        const Chain arm = chain(one.file, one.base, one.tip);
        RandomPostures random(11);
        ChainState state;
        int arrived = 0;
        int64_t iterations = 0;
        for (int i = 0; i < kTargets; ++i) {
            arm.forward(random.next(arm), state);
            const FoundPosture found = findPosture(arm, state.R_base_tip, state.p_base_tip, arm.middle());
            iterations += found.iterations;
            arrived += found.arrived;
            EXPECT_TRUE(((found.q - arm.lower()).array() >= 0).all() &&
                        ((arm.upper() - found.q).array() >= 0).all());
        }
        RecordProperty(one.file, arrived);
        std::printf("%-36s %d of %d, %.1f iterations\n", one.file, arrived, kTargets,
                    static_cast<double>(iterations) / kTargets);
        EXPECT_GE(arrived, 998) << one.file;
    }
}

TEST_F(RobotKinematics, APlaceOutOfReachIsSaidAndTheNearestPostureReturned) {
    const Chain arm = chain("panda/panda.urdf", "panda_link0", "panda_link8");
    const FoundPosture found =
        findPosture(arm, Matrix3d::Identity(), Vector3d(3, 0, 0), arm.middle(), {1e-5, 1e-5, 300, 40, 1});
    EXPECT_FALSE(found.arrived);
    EXPECT_GT(found.distance_m, 1);
    EXPECT_LE(found.iterations, 300);
    EXPECT_TRUE(found.q.allFinite());
}

}  // namespace
}  // namespace noctule::robot
