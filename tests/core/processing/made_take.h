// SPDX-License-Identifier: Apache-2.0
// A small take of known rows: two boards, one source, poses that turn and walk.
#pragma once

#include <gtest/gtest.h>

#include "core/math/rotation.h"
#include "core/recording/take_edit.h"
#include "core/recording/take_writer.h"
#include "tests/support/files.h"

namespace noctule::test {

inline constexpr int kRate_hz = 150000, kInterval = 1200;
inline constexpr int kFrames = 280, kPulses = 240;  // two seconds, the last ten pulses left out

class MadeTake : public testing::Test {
protected:
    void SetUp() override {
        actor_ = defaultActor();
        writePrimary();
    }

    std::string path() const { return file("made_001.noctule"); }
    std::string file(const std::string& name) const { return folder_.file(name); }

    /// Walks along X at 1 m/s and turns about the vertical at 1 rad/s; the right arm swings.
    Pose poseAt(double t_s) const {
        Pose pose = actor_.restPose();
        pose.p_world_root += Vector3d(t_s, 0.1 * std::sin(t_s), 0.5 * t_s);
        pose.q_parent_joint[0] = axisAngle(Vector3d::UnitY(), t_s) * axisAngle(Vector3d::UnitX(), 0.1);
        const auto arm = static_cast<size_t>(actor_.skeleton.find("RightArm"));
        pose.q_parent_joint[arm] = axisAngle(Vector3d::UnitX(), std::sin(2 * t_s));
        return pose;
    }

    void writePrimary() {
        Suit suit{"two", {}, {}};
        for (const char* segment : {"RightForeArm", "LeftHand"}) {
            Board board;
            board.id = std::string("on ") + segment;
            board.segment = segment;
            suit.boards.push_back(board);
        }
        suit.sources = {{"chest", "", "Chest", {0, 0, 0.12}, {0, 0, 1}}};
        TakeHeader header;
        header.name = "made_001";
        header.uuid = "0";
        header.created_utc = "2026-01-01T00:00:00Z";
        header.sample_rate_hz = kRate_hz;
        header.board_count = 2;
        header.source_count = 1;
        auto take = TakeWriter::create(path(), header);
        ASSERT_TRUE(take) << take.error().text();
        ASSERT_TRUE(take->setMeta("level", "readings"));
        ASSERT_TRUE(take->setMeta("sample_count", std::to_string(2 * kRate_hz)));
        ASSERT_TRUE(take->addSuit(suit));
        ASSERT_TRUE(take->addCalibration(nominalCalibration(suit)));
        ASSERT_TRUE(take->addActor(actor_, ""));
        for (int p = 0; p < kPulses; ++p)
            ASSERT_TRUE(take->addPulse(p * kInterval, 0));
        for (int frame = 0; frame < kFrames; ++frame) {
            InertialReading reading{0, frame, frame * kRate_hz / 140.0, {}, {}, 0};
            reading.counts.fill(2048);
            if (frame == 200)
                reading.counts[0] = 4095;
            ASSERT_TRUE(take->addInertial(kPrimaryRun, reading));
            reading.board = 1;
            if (frame % 4 == 3)
                reading = {1, frame, reading.sample, {}, {}, std::nullopt};
            if (frame < 240) {  // then its rows end
                ASSERT_TRUE(take->addInertial(kPrimaryRun, reading));
            }
        }
        ASSERT_TRUE(take->finish());
    }

    /// A pose run of our own with ranges of board 0: of five pulses two used, one gated, one unsure, one
    /// silent.
    /// Right arm off by an angle.
    void addRuns(const std::string& name, double off_rad = 0) {
        auto take = Take::open(path(), Access::kReadWrite);
        ASSERT_TRUE(take) << take.error().text();
        const auto pulses = take->pulses();
        ASSERT_TRUE(pulses);
        auto edit = TakeEdit::begin(*take);
        ASSERT_TRUE(edit);
        const auto range_run = edit->beginRun({0, "range", name, "", "", "", {}, {}});
        ASSERT_TRUE(range_run);
        const std::string settings =
            R"({"sensors":"GD","estimator":"manifold","root":"given","inertial_run":0,)"
            R"("range_run":)" +
            std::to_string(*range_run) + "}";
        const auto pose_run = edit->beginRun({0, "pose", name, "", "", settings, 1, 1});
        ASSERT_TRUE(pose_run);
        constexpr RangeFate kFates[] = {RangeFate::kUsed, RangeFate::kWeighted, RangeFate::kGated,
                                        RangeFate::kNoConfidence};
        for (size_t p = 0; p < pulses->size(); ++p) {
            if (p % 5 == 4)
                continue;
            RangeMeasurement range;
            range.pulse = (*pulses)[p].id;
            range.distance_m = 0.5;
            range.w_s = range.w_t = 0.5;
            range.sigma_m = 0.003;
            range.fate = kFates[p % 5];
            range.innovation_m = 0.002;
            ASSERT_TRUE(edit->addRange(*range_run, range, "inflection"));
        }
        for (int frame = 0; frame < kFrames; ++frame)
            ASSERT_TRUE(edit->addPose(
                *pose_run, {std::llround(frame * 1e9 / 140), withArmOff(frame / 140.0, off_rad), {}}));
        ASSERT_TRUE(edit->commit());
    }

    Pose withArmOff(double t_s, double off_rad) {
        Pose pose = poseAt(t_s);
        Quaterniond& q_parent_arm =
            pose.q_parent_joint[static_cast<size_t>(actor_.skeleton.find("RightArm"))];
        q_parent_arm = q_parent_arm * axisAngle(Vector3d::UnitY(), off_rad);
        return pose;
    }

    /// The truth, from which the right arm of the runs is off by an angle; rest pose until 0.5 s.
    void addReference(double off_rad) {
        auto take = Take::open(path(), Access::kReadWrite);
        ASSERT_TRUE(take);
        auto edit = TakeEdit::begin(*take);
        ASSERT_TRUE(edit);
        ASSERT_TRUE(edit->setMeta("reference_kind", "simulated"));
        ASSERT_TRUE(edit->addMarker({0, "rest", "begin"}));
        ASSERT_TRUE(edit->addMarker({kRate_hz / 2, "rest", "end"}));
        for (int frame = 0; frame < kFrames; ++frame)
            ASSERT_TRUE(edit->addReference(
                {std::llround(frame * 1e9 / 140), withArmOff(frame / 140.0, off_rad), {}}));
        ASSERT_TRUE(edit->commit());
    }

    Folder folder_;
    Actor actor_;
};

}  // namespace noctule::test
