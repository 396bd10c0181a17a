// SPDX-License-Identifier: Apache-2.0
// Out of a take (export, inspect) and into it (attach).
#include "core/formats/bvh.h"
#include "core/processing/attached_motion.h"
#include "core/processing/export_take.h"
#include "core/processing/inspect_take.h"
#include "tests/core/processing/made_take.h"

namespace noctule::test {
namespace {

class TakeFiles : public MadeTake {
protected:
    void SetUp() override {
        MadeTake::SetUp();
        addRuns("mine");
    }
    MotionClip exported(ExportRequest request) {
        request.take_path = path();
        request.bvh_path = file("x.bvh");
        request.overwrite = true;
        const auto summary = exportTake(request, {});
        EXPECT_TRUE(summary) << summary.error().text();
        return toClip(readBvh(request.bvh_path).value(), BvhUnit::kCentimetre).value();
    }
};

TEST_F(TakeFiles, ExportSamplesTheRunAtItsTimes) {
    ExportRequest request;
    request.frames_per_second = 70;
    request.from_s = 0.5;
    request.to_s = 1.5;
    const MotionClip clip = exported(request);
    ASSERT_EQ(clip.frames.size(), 71u);
    const auto arm = static_cast<size_t>(clip.skeleton.find("RightArm"));
    const auto own_arm = static_cast<size_t>(actor_.skeleton.find("RightArm"));
    for (size_t i = 0; i < clip.frames.size(); ++i) {
        const Pose expected = poseAt(0.5 + static_cast<double>(i) / 70);
        EXPECT_LT((clip.frames[i].p_world_root - expected.p_world_root).norm(), 1e-6);
        EXPECT_LT(angleBetween(clip.frames[i].q_parent_joint[arm], expected.q_parent_joint[own_arm]), 1e-6);
    }
}

TEST_F(TakeFiles, RootCanStayInPlaceAndFaceForward) {
    ExportRequest request;
    request.root = RootMotion::kInPlace;
    const MotionClip in_place = exported(request);
    request.root = RootMotion::kHeading;
    const MotionClip heading = exported(request);
    for (size_t i = 0; i < in_place.frames.size(); ++i) {
        const Pose expected = poseAt(static_cast<double>(i) / 120);
        const Vector3d p = in_place.frames[i].p_world_root;
        EXPECT_LT((p - Vector3d(0, expected.p_world_root.y(), 0)).norm(), 1e-4);
        EXPECT_LT(angleBetween(in_place.frames[i].q_parent_joint[0], expected.q_parent_joint[0]), 1e-4);
        EXPECT_LT(angleBetween(heading.frames[i].q_parent_joint[0], axisAngle(Vector3d::UnitX(), 0.1)), 1e-4);
    }
}

TEST_F(TakeFiles, NothingToExportIsAnError) {
    ExportRequest request;
    request.take_path = path();
    request.csv_path = file("x.csv");
    request.from_s = 100;
    const auto refused = exportTake(request, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_FALSE(std::filesystem::exists(request.csv_path));
}

TEST_F(TakeFiles, InspectCountsWhatIsThere) {
    const auto in = inspectTake(path(), {});
    ASSERT_TRUE(in) << in.error().text();
    EXPECT_NEAR(in->duration_s, 2, 1e-9);
    EXPECT_EQ(in->pulses, kPulses);
    EXPECT_EQ(in->runs.size(), 2u);
    ASSERT_EQ(in->pairs.size(), 2u);
    EXPECT_NEAR(in->pairs[0].heard_share, 0.8, 1e-9);
    EXPECT_NEAR(in->pairs[0].used_share, 0.4, 1e-9);
    EXPECT_EQ(in->pairs[1].heard_share, 0);
    ASSERT_EQ(in->board_quality.size(), 2u);
    EXPECT_EQ(in->board_quality[1].frames_lost, 100);
    ASSERT_EQ(in->problems.size(), 1u);
    EXPECT_NE(in->problems[0].find("without calibration"), std::string::npos) << in->problems[0];
    EXPECT_TRUE(toJson(*in).contains("quality"));
}

TEST_F(TakeFiles, AttachedRootOfPointsIsTheRoot) {
    PositionTable table;
    for (const char* joint : {"LeftUpLeg", "Hips", "Head", "RightUpLeg", "Spine"})
        table.joints.push_back(joint);
    for (int i = 0; i < 100; ++i) {
        const double t_s = i / 100.0;
        table.time_s.push_back(t_s);
        const GlobalPose global = globalPose(actor_.skeleton, poseAt(t_s + 0.25));
        for (const std::string& joint : table.joints)
            table.p_world_m.push_back(global.p_world_joint[static_cast<size_t>(actor_.skeleton.find(joint))]);
    }
    AttachRequest request;
    request.take_path = path();
    request.positions = table;
    request.as = AttachAs::kExternalRoot;
    request.shift_s = 0.25;
    const auto summary = attachReference(request, {});
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_EQ(summary->rows, 100);
    const auto rows = Take::open(path())->externalRoot();
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), 100u);
    for (const ExternalRootRow& row : *rows) {
        const Pose expected = poseAt(static_cast<double>(row.time_ns) * 1e-9);
        EXPECT_LT((row.p_world_root - expected.p_world_root).norm(), 1e-9);
        EXPECT_LT(angleBetween(row.q_world_root, expected.q_parent_joint[0]), 1e-7);
    }
    const auto again = attachReference(request, {});
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().kind, ErrorKind::kUsage);
    request.overwrite = true;
    request.shift_s = 100;
    EXPECT_EQ(attachReference(request, {}).error().kind, ErrorKind::kUnusable) << "outside the take";
    EXPECT_EQ(Take::open(path())->externalRoot()->size(), 100u) << "what was there stays";
}

TEST_F(TakeFiles, TimesInAnotherUnitAreSaidWithCounts) {
    PositionTable table;
    table.joints = {"Hips", "LeftUpLeg", "RightUpLeg"};
    const GlobalPose global = globalPose(actor_.skeleton, poseAt(0));
    for (int i = 0; i < 60; ++i) {
        table.time_s.push_back(50.0 * i);  // milliseconds; the take lasts 2 s
        for (const std::string& joint : table.joints)
            table.p_world_m.push_back(global.p_world_joint[static_cast<size_t>(actor_.skeleton.find(joint))]);
    }
    AttachRequest request;
    request.take_path = path();
    request.source_name = "ms.csv";
    request.positions = table;
    request.as = AttachAs::kExternalRoot;
    request.shift_s = 0;
    const auto refused = attachReference(request, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("59 of 60 rows lie outside the take of 2.000 s"),
              std::string::npos)
        << refused.error().message;
    EXPECT_NE(refused.error().text().find("milliseconds. Name the column time_ms"), std::string::npos);
    EXPECT_TRUE(Take::open(path())->externalRoot()->empty());
    for (double& time_s : request.positions->time_s)
        time_s /= 1000;
    const auto summary = attachReference(request, {});
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_EQ(summary->rows, 41);
    EXPECT_EQ(summary->rows_outside, 19);
    ASSERT_EQ(summary->warnings.size(), 1u);
    EXPECT_NE(summary->warnings[0].find("19 of 60 rows lie outside"), std::string::npos);
}

TEST_F(TakeFiles, AMotionThatDoesNotMatchIsNotAligned) {
    TimedMotion still{actor_.skeleton, {}};
    for (int i = 0; i < 400; ++i)
        still.frames.push_back({i * 10'000'000LL, actor_.restPose(), {}});
    AttachRequest request;
    request.take_path = path();
    request.motion = toClip("still", still, 100);
    request.source_name = "still.bvh";
    const auto refused = attachReference(request, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(refused.error().text().find("still.bvh"), std::string::npos);
}

/// A take that had no reference has none again, nor anything that is said of one.
TEST_F(TakeFiles, WhatWasAttachedIsTakenOutAndPutBack) {
    const auto attached = [this] { return attachedMotion(path(), AttachAs::kReference, {}).value(); };
    const AttachedMotion none = attached();
    ASSERT_FALSE(none.isThere());
    ExportRequest out;
    out.take_path = path();
    out.bvh_path = file("optical.bvh");
    ASSERT_TRUE(exportTake(out, {}));
    AttachRequest request;
    request.take_path = path();
    request.source_name = out.bvh_path;
    request.motion = toClip(readBvh(out.bvh_path).value(), BvhUnit::kCentimetre).value();
    request.shift_s = 0;
    ASSERT_TRUE(attachReference(request, {}));
    const AttachedMotion some = attached();
    ASSERT_TRUE(some.isThere());
    EXPECT_EQ(some.meta.at("reference_kind"), "optical");

    ASSERT_TRUE(putBackAttached(path(), none, {}));
    EXPECT_FALSE(attached().isThere());
    EXPECT_EQ(attached().meta, none.meta);
    ASSERT_TRUE(putBackAttached(path(), some, {}));
    EXPECT_EQ(attached().meta, some.meta);
    ASSERT_EQ(attached().reference.size(), some.reference.size());
    EXPECT_EQ(attached().reference[9].pose->p_world_root, some.reference[9].pose->p_world_root);
}

}  // namespace
}  // namespace noctule::test
