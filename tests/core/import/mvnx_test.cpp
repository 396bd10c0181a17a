// SPDX-License-Identifier: Apache-2.0
// Files of Xsens MVN.
#include <gtest/gtest.h>

#include <cmath>

#include "core/body/kinematics.h"
#include "tests/core/import/example_files.h"

namespace noctule::test {
namespace {

TEST(Mvnx, SensorsAndTheResultAreRead) {
    const auto read = readAs({{"walk.mvnx", mvnxExample()}});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->sensors.size(), 2u);
    EXPECT_EQ(read->sensors[0].samples.rate_hz, 60);
    EXPECT_EQ(read->sensors[0].samples.size(), 20u);
    // 1 m/s^2 upwards besides gravity; the turn is about the vertical.
    EXPECT_LT(
        (read->sensors[1].samples.accel_m_per_s2[7] - Vector3d(0, 0, 1 + kStandardGravity_m_per_s2)).norm(),
        1e-5);
    ASSERT_TRUE(read->reference);
    const Skeleton& skeleton = read->reference->skeleton;
    ASSERT_EQ(skeleton.size(), 3);
    EXPECT_EQ(skeleton.joint(0).name, "Hips");
    EXPECT_EQ(skeleton.joint(1).name, "RightUpLeg");
    EXPECT_LT((skeleton.joint(1).offset_m - Vector3d(-0.1, -0.1, 0)).norm(), 1e-9) << "right is -X, down -Y";
    const GlobalPose pose = globalPose(skeleton, *read->reference->frames[10].pose);
    // Forward kinematics gives the file's positions: x right of (1, 2), turned by 0.1 rad.
    EXPECT_LT(
        (pose.p_world_joint[1] - Vector3d(2 - 0.1 * std::cos(0.1), 0.9, 1 + 0.1 * std::sin(0.1))).norm(),
        1e-5);
    std::string unjoined = mvnxExample();
    const size_t joints = unjoined.find("<joints>");
    ASSERT_NE(joints, std::string::npos);
    unjoined.erase(joints, unjoined.find("</joints>") + 9 - joints);
    const auto same = readAs({{"walk.mvnx", unjoined}});
    ASSERT_TRUE(same && same->reference) << "MVN's body is known without its joints";
    EXPECT_EQ(same->reference->skeleton.joint(1).offset_m, skeleton.joint(1).offset_m);
}

TEST(Mvnx, TimesThatJumpAreSaid) {
    std::string text = mvnxExample();
    ASSERT_TRUE(readAs({{"walk.mvnx", text}}));
    EXPECT_FALSE(mentions(readAs({{"walk.mvnx", text}})->warnings, "its time goes on"));
    const std::string stated = "time=\"" + std::to_string(10 * 1000 / 60) + "\"";
    text.replace(text.find(stated), stated.size(), "time=\"5166\"");
    const auto read = readAs({{"walk.mvnx", text}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(mentions(read->warnings, "From frame 9 to 10 its time goes on by 5.016 s"))
        << read->warnings.back();
}

TEST(Mvnx, CutFilesKeepWholeFramesAndWrongCountsAreErrors) {
    const std::string whole = mvnxExample();
    const auto cut = readAs({{"walk.mvnx", whole.substr(0, whole.size() * 3 / 4)}});
    ASSERT_TRUE(cut) << cut.error().text();
    EXPECT_LT(cut->sensors[0].samples.size(), 20u);
    EXPECT_TRUE(mentions(cut->warnings, "ends in the middle"));
    std::string wrong = whole;
    wrong.replace(wrong.rfind("<position>1 2 1"), 15, "<position>1 2 1 4");
    const auto refused = readAs({{"walk.mvnx", wrong}});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("frame 19, position: 10 numbers"), std::string::npos)
        << refused.error().message;
    const auto entity =
        readAs({{"x.mvnx", "<?xml version=\"1.0\"?><!DOCTYPE mvnx [<!ENTITY a \"b\">]><mvnx>&a;</mvnx>"}});
    ASSERT_FALSE(entity);
    EXPECT_NE(entity.error().message.find("document type"), std::string::npos) << entity.error().message;
}

/// Gloves bring segments and joints of their own.
TEST(Mvnx, FingersAreNotCountedAsTheBodys) {
    std::string text = mvnxExample();
    const auto put = [&](const std::string& behind, const std::string& more) {
        text.insert(text.find(behind) + behind.size(), more);
    };
    put("</segments>",
        "<fingerTrackingSegmentsLeft segmentCount=\"2\"><segment label=\"LeftCarpus\" id=\"1\"/>"
        "<segment label=\"LeftFirstMC\" id=\"2\"/></fingerTrackingSegmentsLeft>");
    put("</joints>",
        "<fingerTrackingJointsLeft><joint label=\"jLeftFirstCMC\"><connector1>LeftCarpus/a</connector1>"
        "<connector2>LeftFirstMC/a</connector2></joint></fingerTrackingJointsLeft>");
    const auto read = readAs({{"walk.mvnx", text}});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_TRUE(read->reference);
    EXPECT_EQ(read->reference->skeleton.size(), 3);
}

}  // namespace
}  // namespace noctule::test
