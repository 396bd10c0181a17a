// SPDX-License-Identifier: Apache-2.0
// Writing: what is written reads back the same, looks as other programs expect it, and replaces nothing by
// mistake.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "core/body/actor.h"
#include "core/formats/bvh.h"
#include "core/job/atomic_file.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

namespace fs = std::filesystem;

/// The default actor tumbling: every joint turns, many through gimbal lock and several whole turns.
MotionClip tumbling(size_t frames) {
    MotionClip clip{"tumble", defaultActor().skeleton, 1.0 / 120, {}, {}};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> rate(-4, 4);
    std::vector<Vector3d> spin_rad_per_s;
    for (int j = 0; j < clip.skeleton.size(); ++j)
        spin_rad_per_s.push_back(Vector3d{rate(random), rate(random), rate(random)});
    for (size_t f = 0; f < frames; ++f) {
        const double t_s = static_cast<double>(f) * clip.frame_time_s;
        Pose pose{Vector3d(0.3 * t_s, 0.95 + 0.01 * std::sin(t_s), -1.234567), {}};
        for (const Vector3d& spin : spin_rad_per_s)
            pose.q_parent_joint.push_back(expQuaternion(spin * t_s) *
                                          expQuaternion(spin.reverse() * 0.3 * t_s));
        clip.frames.push_back(pose);
    }
    return clip;
}

void expectSameMotion(const MotionClip& a, const MotionClip& b, double tolerance_rad, double tolerance_m) {
    ASSERT_EQ(a.frames.size(), b.frames.size());
    EXPECT_EQ(a.frame_time_s, b.frame_time_s);
    for (const Joint& joint : a.skeleton.joints()) {
        const int other = b.skeleton.find(joint.name), own = a.skeleton.find(joint.name);
        ASSERT_GE(other, 0) << joint.name;
        for (size_t f = 0; f < a.frames.size(); ++f)
            ASSERT_LT(angleBetween(a.frames[f].q_parent_joint[static_cast<size_t>(own)],
                                   b.frames[f].q_parent_joint[static_cast<size_t>(other)]),
                      tolerance_rad)
                << joint.name << " in frame " << f;
    }
    for (size_t f = 0; f < a.frames.size(); f += 7) {
        const GlobalPose first = globalPose(a, f), second = globalPose(b, f);
        for (int j = 0; j < a.skeleton.size(); ++j)
            ASSERT_LT((first.p_world_joint[static_cast<size_t>(j)] -
                       second.p_world_joint[static_cast<size_t>(b.skeleton.find(a.skeleton.joint(j).name))])
                          .norm(),
                      tolerance_m);
    }
}

class BvhWriter : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / (std::string("noctule_bvh_writer_") + info->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    fs::path folder_;
};

TEST_F(BvhWriter, RotationsAndPositionsReadBackInEveryOrderAndUnit) {
    const MotionClip clip = tumbling(400);
    for (const EulerOrder& order : {kEulerXYZ, kEulerXZY, kEulerYXZ, kEulerYZX, kEulerZXY, kEulerZYX})
        for (const BvhUnit unit : {BvhUnit::kCentimetre, BvhUnit::kMetre}) {
            ASSERT_TRUE(writeBvh(path("t.bvh"), clip, {metresPer(unit), order}, true).ok());
            const Result<BvhDocument> read = readBvh(path("t.bvh"));
            ASSERT_TRUE(read.ok()) << read.error().text();
            EXPECT_TRUE(read->warnings.empty());
            EXPECT_EQ(chooseUnit(*read).unit, unit);
            expectSameMotion(clip, toClip(*read).value(), radians(1e-6), 1e-6);
        }
}

TEST_F(BvhWriter, LooksAsOtherProgramsExpectIt) {
    MotionClip clip = tumbling(2);
    clip.frame_time_s = 1.0 / 60;
    const std::string text = formatBvh(toDocument(clip).value());
    EXPECT_EQ(text.rfind("HIERARCHY\nROOT Hips\n{\n\tOFFSET 0.00000000 0.00000000 0.00000000\n"
                         "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n\tJOINT ",
                         0),
              0u)
        << text.substr(0, 300);
    EXPECT_NE(text.find("CHANNELS 3 Zrotation Xrotation Yrotation\n"), std::string::npos);
    EXPECT_NE(text.find("\nMOTION\nFrames: 2\nFrame Time: 0.016666666666666666\n"), std::string::npos);
    EXPECT_EQ(text.find("-0.0000000 "), std::string::npos);
    EXPECT_EQ(text.find('\r'), std::string::npos);
}

TEST_F(BvhWriter, OffsetsAreTheZeroPoseAndEveryLeafHasATip) {
    const MotionClip clip = tumbling(1);
    const BvhDocument document = toDocument(clip, {1, kEulerZXY}).value();
    std::vector<bool> has_children(document.joints.size(), false);
    for (const BvhJoint& joint : document.joints) {
        const Joint& from = clip.skeleton.joint(clip.skeleton.find(joint.name));
        EXPECT_EQ(joint.offset, from.offset_m);
        if (joint.parent >= 0)
            has_children[static_cast<size_t>(joint.parent)] = true;
    }
    for (size_t j = 0; j < document.joints.size(); ++j) {
        EXPECT_NE(has_children[j], document.joints[j].end_site.has_value()) << document.joints[j].name;
        EXPECT_GT(document.joints[j].end_site.value_or(Vector3d::UnitY()).norm(), 0.01);
    }
}

TEST_F(BvhWriter, AnglesRunOnWithoutJumps) {
    const MotionClip clip = tumbling(1200);
    const BvhDocument document = toDocument(clip).value();
    size_t jumps = 0;
    for (size_t v = document.channel_count; v < document.values.size(); ++v)
        jumps += std::abs(document.values[v] - document.values[v - document.channel_count]) > 181;
    EXPECT_EQ(jumps, 0u);  // beside gimbal lock a curve may turn by half a turn, never by a whole one
}

TEST_F(BvhWriter, JointsThatMoveInTheirParentGetPositionChannels) {
    MotionClip clip = tumbling(3);
    const int moving = clip.skeleton.find("Head");
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        std::vector<Vector3d> places;
        for (const Joint& joint : clip.skeleton.joints())
            places.push_back(joint.offset_m);
        places[static_cast<size_t>(moving)].y() += 0.01 * static_cast<double>(f);
        clip.p_parent_joint_m.push_back(places);
    }
    const BvhDocument document = toDocument(clip).value();
    size_t with_positions = 0;
    for (const BvhJoint& joint : document.joints)
        with_positions += joint.channels.size() == 6;
    EXPECT_EQ(with_positions, 2u);  // Hips and Head
    expectSameMotion(clip, toClip(document).value(), 1e-9, 1e-9);
}

TEST_F(BvhWriter, JointsNeedNotStandInDepthFirstOrder) {
    const auto joint = [](const char* name, int parent, const Vector3d& offset_m) {
        Joint j{name, parent, offset_m, JointType::kBall, {}, {}, {}};
        for (int axis = 0; axis < 3; ++axis)
            j.dof.push_back({std::string(1, "xyz"[axis]), Vector3d::Unit(axis)});
        return j;
    };
    std::vector<Joint> joints{{"Hips", -1, Vector3d::Zero(), JointType::kFree, {}, {}, {}},
                              joint("LeftLeg", 0, {0.1, -0.5, 0}),
                              joint("RightLeg", 0, {-0.1, -0.5, 0}),
                              joint("LeftFoot", 1, {0, -0.5, 0}),
                              joint("RightFoot", 2, {0, -0.5, 0})};
    MotionClip clip{"legs", Skeleton::make(joints).value(), 0.01, {}, {}};
    Pose pose = clip.skeleton.zeroPose();
    for (size_t j = 0; j < joints.size(); ++j)
        pose.q_parent_joint[j] = axisAngle(Vector3d::UnitX(), 0.1 * static_cast<double>(j + 1));
    clip.frames = {pose};
    ASSERT_TRUE(writeBvh(path("legs.bvh"), clip, {}, false).ok());
    expectSameMotion(clip, toClip(readBvh(path("legs.bvh")).value(), BvhUnit::kCentimetre).value(), 1e-7,
                     1e-7);
}

TEST_F(BvhWriter, NamesThatWouldBreakTheFileAreReplaced) {
    std::vector<Joint> joints = defaultActor().skeleton.joints();
    joints[1].name = "Lower {Spine}";
    joints[2].name = "Lower__Spine_";
    MotionClip clip{"names", Skeleton::make(joints).value(), 0.01, {}, {}};
    clip.frames = {clip.skeleton.zeroPose()};
    ASSERT_TRUE(writeBvh(path("names.bvh"), clip, {}, false).ok());
    const BvhDocument document = readBvh(path("names.bvh")).value();
    EXPECT_EQ(document.joints[1].name, "Lower__Spine_");
    EXPECT_EQ(document.joints[2].name, "Lower__Spine__2");
}

TEST_F(BvhWriter, DocumentsOfOtherProgramsAreWrittenAsTheyWere) {
    const fs::path folder = NOCTULE_SOURCE_DIR "/../shared/data/bvh/peers";
    if (!fs::exists(folder))
        GTEST_SKIP() << folder << " is missing";
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".bvh") {
            const BvhDocument document = readBvh(entry.path().string()).value();
            const Status written = writeBvh(path("copy.bvh"), document, true);
            EXPECT_TRUE(written.ok()) << entry.path() << ": " << (written.ok() ? "" : written.error().text());
        }
}

TEST_F(BvhWriter, RefusesWhatIsNotFinite) {
    MotionClip clip = tumbling(5);
    clip.frames[3].q_parent_joint[2].x() = std::numeric_limits<double>::quiet_NaN();
    const Status failed = writeBvh(path("nan.bvh"), clip, {}, false);
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(failed.error().message.find("frame 4 of joint Chest"), std::string::npos)
        << failed.error().message;
    EXPECT_FALSE(fs::exists(path("nan.bvh")));
    clip.frames.clear();
    EXPECT_EQ(writeBvh(path("nan.bvh"), clip, {}, false).error().kind, ErrorKind::kUnusable);
}

TEST_F(BvhWriter, ReplacesOnlyWhenAsked) {
    const MotionClip clip = tumbling(2);
    ASSERT_TRUE(writeBvh(path("a.bvh"), clip, {}, false).ok());
    EXPECT_EQ(writeBvh(path("a.bvh"), clip, {}, false).error().kind, ErrorKind::kUsage);
    EXPECT_TRUE(writeBvh(path("a.bvh"), clip, {}, true).ok());
    EXPECT_EQ(writeBvh(path("no/a.bvh"), clip, {}, false).error().kind, ErrorKind::kDisk);
}

TEST_F(BvhWriter, WhatDoesNotReadBackTheSameGetsNoName) {
    BvhDocument document = toDocument(tumbling(2)).value();
    document.joints[1].name = "a name\nwith a line break";
    const Status failed = writeBvh(path("bad.bvh"), document, false);
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().kind, ErrorKind::kDisk);
    EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace noctule
