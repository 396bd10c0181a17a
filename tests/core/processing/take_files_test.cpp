// SPDX-License-Identifier: Apache-2.0
// Out of a take (export, inspect) and into it (attach).
#include "tests/support/take_files.h"

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

/// As imports without names of segments are. Only a room's boards are not judged.
TEST_F(TakeFiles, InspectJudgesBoardsThatSitOnNoSegment) {
    runSql(path(),
           "UPDATE suit SET json=json_set(json,'$.boards[0].segment',NULL,'$.boards[1].segment',NULL,"
           "'$.sources[0].segment',NULL)");
    ASSERT_TRUE(Take::open(path())->suit()->isFixed());
    const auto in = inspectTake(path(), {});
    ASSERT_TRUE(in) << in.error().text();
    ASSERT_EQ(in->board_quality.size(), 2u);
    EXPECT_EQ(in->board_quality[1].frames_lost, 100);
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

void expectSame(const Quaterniond& a, const Quaterniond& b) {
    EXPECT_EQ(a.coeffs(), b.coeffs());
}

/// To the bit.
void expectSame(const AttachedMotion& a, const AttachedMotion& b) {
    EXPECT_EQ(a.meta, b.meta);
    ASSERT_EQ(a.reference.size(), b.reference.size());
    for (size_t i = 0; i < a.reference.size(); ++i) {
        SCOPED_TRACE(i);
        EXPECT_EQ(a.reference[i].time_ns, b.reference[i].time_ns);
        const Pose &one = *a.reference[i].pose, &other = *b.reference[i].pose;
        EXPECT_EQ(one.p_world_root, other.p_world_root);
        ASSERT_EQ(one.q_parent_joint.size(), other.q_parent_joint.size());
        for (size_t joint = 0; joint < one.q_parent_joint.size(); ++joint)
            expectSame(one.q_parent_joint[joint], other.q_parent_joint[joint]);
    }
    ASSERT_EQ(a.external_root.size(), b.external_root.size());
    for (size_t i = 0; i < a.external_root.size(); ++i) {
        SCOPED_TRACE(i);
        EXPECT_EQ(a.external_root[i].time_ns, b.external_root[i].time_ns);
        EXPECT_EQ(a.external_root[i].p_world_root, b.external_root[i].p_world_root);
        expectSame(a.external_root[i].q_world_root, b.external_root[i].q_world_root);
        EXPECT_EQ(a.external_root[i].sigma_p_m, b.external_root[i].sigma_p_m);
        EXPECT_EQ(a.external_root[i].sigma_q_rad, b.external_root[i].sigma_q_rad);
    }
}

/// A take to which nothing was attached has nothing again, nor anything that is said of it.
TEST_F(TakeFiles, WhatWasAttachedIsTakenOutAndPutBack) {
    ExportRequest out;
    out.take_path = path();
    out.bvh_path = file("optical.bvh");
    ASSERT_TRUE(exportTake(out, {}));
    for (const AttachAs as : {AttachAs::kReference, AttachAs::kExternalRoot}) {
        SCOPED_TRACE(as == AttachAs::kReference ? "reference" : "external root");
        const auto attached = [&] { return attachedMotion(path(), as, {}).value(); };
        const AttachedMotion none = attached();
        ASSERT_FALSE(none.isThere());
        AttachRequest request;
        request.take_path = path();
        request.as = as;
        request.source_name = out.bvh_path;
        request.motion = toClip(readBvh(out.bvh_path).value(), BvhUnit::kCentimetre).value();
        request.shift_s = 0;
        ASSERT_TRUE(attachReference(request, {}));
        const AttachedMotion some = attached();
        ASSERT_TRUE(some.isThere());
        EXPECT_EQ(some.meta.contains("reference_kind"), as == AttachAs::kReference);

        ASSERT_TRUE(putBackAttached(path(), none, {}));
        EXPECT_FALSE(attached().isThere());
        expectSame(attached(), none);
        ASSERT_TRUE(putBackAttached(path(), some, {}));
        expectSame(attached(), some);
        ASSERT_TRUE(putBackAttached(path(), none, {}));
    }
}

/// File systems allow names of 255 bytes.
TEST_F(TakeFiles, ALongNameOfAReferenceComesBackWhole) {
    addReference(0);
    const std::string name = std::string(206, 'n') + ".bvh";
    runSql(path(), "INSERT INTO meta VALUES('reference_name','" + name + "')");
    const AttachedMotion before = attachedMotion(path(), AttachAs::kReference, {}).value();
    ExportRequest out;
    out.take_path = path();
    out.bvh_path = file("optical.bvh");
    ASSERT_TRUE(exportTake(out, {}));
    AttachRequest request;
    request.take_path = path();
    request.source_name = out.bvh_path;
    request.motion = toClip(readBvh(out.bvh_path).value(), BvhUnit::kCentimetre).value();
    request.shift_s = 0;
    request.overwrite = true;
    ASSERT_TRUE(attachReference(request, {}));
    EXPECT_EQ(Take::open(path())->meta().at("reference_name"), "optical.bvh");
    ASSERT_TRUE(putBackAttached(path(), before, {}));
    EXPECT_EQ(Take::open(path())->meta().at("reference_name"), name);
}

}  // namespace
}  // namespace noctule::test
