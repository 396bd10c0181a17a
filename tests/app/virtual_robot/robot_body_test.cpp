// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_robot/robot_body.h"

#include <gtest/gtest.h>

#include "app/virtual_robot/control_line.h"
#include "app/virtual_robot/options.h"
#include "core/robot/urdf_reader.h"
#include "tests/support/plain_arm.h"

namespace noctule::virtual_robot {
namespace {

constexpr int64_t kMs = 1'000'000;

robot::DrivenParts plainArms() {
    const auto model = robot::parseUrdf(test::plainArmUrdf(), "arm");
    EXPECT_TRUE(model);
    auto parts = robot::drivenParts(*model, test::plainArmProfile(), {});
    EXPECT_TRUE(parts) << (parts ? "" : parts.error().text());
    return std::move(*parts);
}

/// Commands one posture again and again.
void run(RobotBody& body, int64_t& now_ns, const std::vector<double>& q, int ms) {
    for (int i = 0; i < ms; ++i) {
        now_ns += kMs;
        if (i % 7 == 0)
            body.command(now_ns, static_cast<uint64_t>(now_ns / kMs), q);
        body.advance(now_ns);
    }
}

TEST(RobotBody, FollowsWithinItsSpeedAndLag) {
    RobotBody body(plainArms(), {});
    int64_t now_ns = kMs;
    body.advance(now_ns);
    std::vector<double> q = body.q();
    const double from = q[3];
    q[3] += 0.4;
    run(body, now_ns, q, 100);
    EXPECT_LE(body.q()[3] - from, test::kPlainArmSpeed * 0.1 + 1e-9);
    EXPECT_GT(body.q()[3] - from, 0.9 * test::kPlainArmSpeed * 0.1);
    run(body, now_ns, q, 600);
    EXPECT_NEAR(body.q()[3], q[3], 1e-3);
    EXPECT_FALSE(body.refuses());
}

TEST(RobotBody, LatencyDelaysAndLagSmooths) {
    RobotBody body(plainArms(), {.latency_s = 0.05, .lag_s = 0.1});
    int64_t now_ns = kMs;
    body.advance(now_ns);
    std::vector<double> q = body.q();
    const double from = q[3];
    q[3] += 0.1;
    run(body, now_ns, q, 49);
    EXPECT_EQ(body.q()[3], from);
    run(body, now_ns, q, 101);
    EXPECT_NEAR(body.q()[3] - from, 0.1 * (1 - std::exp(-1.0)), 0.002);
}

TEST(RobotBody, RefusesWhatIsTooFar) {
    RobotBody body(plainArms(), {.refuse_beyond = 0.3});
    int64_t now_ns = kMs;
    body.advance(now_ns);
    const std::vector<double> start = body.q();
    std::vector<double> q = start;
    q[0] += 0.4;
    run(body, now_ns, q, 200);
    EXPECT_TRUE(body.refuses());
    EXPECT_EQ(body.q(), start);
    EXPECT_GT(body.refusedCommands(), 10);
    q[0] = start[0] + 0.2;
    run(body, now_ns, q, 500);
    EXPECT_FALSE(body.refuses());
    EXPECT_NEAR(body.q()[0], q[0], 1e-3);
}

TEST(RobotBody, StandsStillWithoutCommandsAndWhereAJointIsStuck) {
    RobotBody body(plainArms(), {});
    int64_t now_ns = kMs;
    body.advance(now_ns);
    std::vector<double> q = body.q();
    q[3] += 0.45;
    body.command(now_ns, 1, q);
    for (int i = 0; i < 1000; ++i)
        body.advance(now_ns += kMs);
    EXPECT_LT(body.q()[3], q[3] - 0.01) << "the watchdog stops it on its way";
    EXPECT_EQ(body.v()[3], 0);
    EXPECT_TRUE(body.setStuck("e", true));
    EXPECT_FALSE(body.setStuck("nose", true));
    const double stuck_at = body.q()[3];
    run(body, now_ns, q, 300);
    EXPECT_EQ(body.q()[3], stuck_at);
}

TEST(RobotBody, ATipIsReached) {
    const auto parts = plainArms();
    RobotBody body(parts, {});
    int64_t now_ns = kMs;
    body.advance(now_ns);
    robot::ChainState at;
    robot::JointVector q(7);
    for (int i = 0; i < 7; ++i)
        q[i] = body.q()[static_cast<size_t>(i)];
    parts.arms[0].chain.forward(q, at);
    const Vector3d target = at.p_base_tip + Vector3d(0.05, 0.02, 0.03);
    for (int i = 0; i < 1000; ++i) {
        now_ns += kMs;
        if (i % 7 == 0)
            body.commandTip(now_ns, 0, at.R_base_tip, target);
        body.advance(now_ns);
    }
    for (int i = 0; i < 7; ++i)
        q[i] = body.q()[static_cast<size_t>(i)];
    parts.arms[0].chain.forward(q, at);
    EXPECT_LT((at.p_base_tip - target).norm(), 1e-3);
}

TEST(RobotControl, LinesAreUnderstoodOrExplained) {
    EXPECT_EQ(parseControlLine("stall 0.5")->number, 0.5);
    EXPECT_EQ(parseControlLine("joint-stuck right/j0")->joint, "right/j0");
    EXPECT_EQ(parseControlLine("refuse")->kind, FaultKind::kRefuse);
    for (const char* line : {"", "dance", "stall", "stall x", "stall -1", "stall 1 2", "refuse 3",
                             "stall nan", "joint-stuck", "latency 1e9"}) {
        const auto command = parseControlLine(line);
        ASSERT_FALSE(command) << line;
        EXPECT_NE(command.error().remedy, "");
    }
}

TEST(RobotOptions, MistakesAreNamed) {
    using Words = std::vector<std::string>;
    for (const Words& words : {Words{}, Words{"--udp", "127.0.0.1:0"}, Words{"--robot", "r.urdf"},
                               Words{"--robot", "r.urdf", "--udp", "nowhere"}, Words{"r.urdf"},
                               Words{"--robot", "r.urdf", "--rosbridge", "127.0.0.1:0", "--lag-ms", "x"}}) {
        const auto options = parseOptions(words);
        ASSERT_FALSE(options);
        EXPECT_EQ(options.error().kind, ErrorKind::kUsage);
    }
    EXPECT_TRUE(parseOptions({"--robot", "r.urdf", "--rosbridge", "127.0.0.1:0"}));
}

}  // namespace
}  // namespace noctule::virtual_robot
