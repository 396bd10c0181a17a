// SPDX-License-Identifier: Apache-2.0
// Files of Xsens MVN.
#include <gtest/gtest.h>

#include <cmath>

#include "core/body/kinematics.h"
#include "core/import/import_take.h"
#include "core/recording/take.h"
#include "tests/core/import/example_files.h"
#include "tests/support/files.h"

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

/// The example with an element of all frames of the motion taken out.
std::string without(const std::string& element) {
    std::string text = mvnxExample();
    const std::string begin = "<" + element + ">", end = "</" + element + ">";
    const size_t motion = text.find("type=\"normal\"");
    for (size_t at = text.find(begin, motion); at != std::string::npos; at = text.find(begin, at))
        text.erase(at, text.find(end, at) + end.size() - at);
    return text;
}

/// Any child of a frame may be absent: what is there is kept, and no more is said to be.
TEST(Mvnx, FilesWithoutPositionsTellOrientations) {
    const auto whole = readAs({{"walk.mvnx", mvnxExample()}});
    const auto read = readAs({{"walk.mvnx", without("position")}});
    ASSERT_TRUE(whole && read) << read.error().text();
    ASSERT_TRUE(read->reference);
    EXPECT_TRUE(mentions(read->warnings, "has no positions: its reference tells orientations alone"));
    ASSERT_EQ(read->reference->frames.size(), 20u);
    for (size_t i = 0; i < 20; ++i) {
        ASSERT_TRUE(read->reference->frames[i].pose);
        const Pose &pose = *read->reference->frames[i].pose, &known = *whole->reference->frames[i].pose;
        EXPECT_LT((pose.p_world_root - Vector3d(0, 1, 0)).norm(), 1e-9)
            << "where it stood in the identity frame";
        for (size_t j = 0; j < 3; ++j)
            EXPECT_EQ(pose.q_parent_joint[j].coeffs(), known.q_parent_joint[j].coeffs());
    }
}

TEST(Mvnx, FilesWithoutOrientationsBringNoReference) {
    const auto read = readAs({{"walk.mvnx", without("orientation")}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_FALSE(read->reference);
    EXPECT_TRUE(mentions(read->warnings, "so the file brings no reference"));
    EXPECT_TRUE(mentions(read->warnings, "accelerations were derived"));
}

TEST(Mvnx, DerivedAccelerationsAreToldWhereThereAreSome) {
    const auto read = readAs({{"walk.mvnx", without("sensorFreeAcceleration")}});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_FALSE(mentions(read->warnings, "accelerations were derived"));
    EXPECT_TRUE(mentions(read->warnings, "attitudes alone"));
}

TEST(Mvnx, AReferenceWithoutAPoseIsNone) {
    auto read = readAs({{"walk.mvnx", mvnxExample()}});
    ASSERT_TRUE(read && read->reference);
    for (TimedPose& timed : read->reference->frames)
        timed.pose.reset();
    const Folder folder;
    const auto written = writeImportedTake(
        *read, {folder.file("walk.noctule"), "walk", "2026-01-01T00:00:00Z", "test", "u", false}, {});
    ASSERT_TRUE(written) << written.error().text();
    EXPECT_FALSE(written->has_reference);
    EXPECT_FALSE(Take::open(folder.file("walk.noctule"))->meta().contains("reference_kind"));
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
