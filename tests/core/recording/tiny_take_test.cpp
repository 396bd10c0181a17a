// SPDX-License-Identifier: Apache-2.0
// The take that somebody else wrote after the specification.
#include <gtest/gtest.h>

#include <array>

#include "core/recording/take_edit.h"
#include "tests/core/recording/collect.h"

namespace noctule {
namespace {

using test::Folder;
using test::kTinyTake;

class TinyTake : public testing::Test {
protected:
    const Result<Take> take = Take::open(kTinyTake);
    void SetUp() override { ASSERT_TRUE(take) << take.error().text(); }
    void TearDown() override { EXPECT_TRUE(take->skippedRows().empty()) << take->skippedRows()[0].first; }
};

TEST_F(TinyTake, Header) {
    EXPECT_EQ(take->meta().size(), 17u);
    const TakeHeader& header = take->header();
    EXPECT_EQ(header.uuid, "f97b272e-ff9f-5bcf-88e3-0d38a13b348a");
    EXPECT_EQ(header.created_utc, "2026-11-12T11:17:00Z");
    EXPECT_EQ(header.software, "golden vectors");
    EXPECT_EQ(*take->sampleRate_hz(), 150000);
    EXPECT_EQ(header.pulse_interval_samples, 1200);
    EXPECT_EQ(header.pulse_cycles, 10);
    EXPECT_EQ(header.drive_hz, 40000);
    EXPECT_EQ(header.take_kind, "motion");
    EXPECT_EQ(take->level(), TakeLevel::kSignal);
    EXPECT_EQ(*take->sampleCount(), 302500);
    EXPECT_TRUE(take->missingParts()->empty());
}

TEST_F(TinyTake, SuitCalibrationActor) {
    EXPECT_EQ(take->suitIds(), std::vector<int>{1});
    const Result<Suit> suit = take->suit();
    ASSERT_TRUE(suit) << suit.error().text();
    EXPECT_EQ(suit->boards[1].id, "l_hand");
    EXPECT_EQ(suit->sources[0].id, "chest_l");
    EXPECT_EQ(*take->boardCount(), 2);
    EXPECT_EQ(*take->sourceCount(), 2);
    EXPECT_EQ(take->suitClock().rate, 1);
    const auto calibration = take->calibrationInForce();
    ASSERT_TRUE(calibration) << calibration.error().text();
    EXPECT_EQ(calibration->id, 1);
    EXPECT_EQ(calibration->value.findSource("belly_l")->offsets_s.at("inflection"), 0.00015425519481203904);
    EXPECT_EQ(calibration->value.findBoard("l_hand")->accel.matrix(2, 1), -0.0016473159797719902);
    const auto actor = take->actorInForce();
    ASSERT_TRUE(actor) << actor.error().text();
    EXPECT_EQ(actor->value.name, "syn-performer");
    EXPECT_EQ(actor->value.skeleton.size(), 21);
    EXPECT_EQ(take->actors()->size(), 1u);
    EXPECT_EQ(take->calibrations()->at(0).created_utc, "2026-11-12T11:17:00Z");
    EXPECT_FALSE(take->suit(2));
    EXPECT_EQ(take->calibrationInForce(2).error().kind, ErrorKind::kUnusable);
}

TEST_F(TinyTake, Sound) {
    int64_t next = 0, sum = 0;
    int blocks = 0;
    std::array<int16_t, 4> first{}, last{};
    const Status walked = take->forEachBlock(1, [&](const AdcBlock& block) {
        EXPECT_EQ(block.first_sample, next);
        next += static_cast<int64_t>(block.values.size()) / 2;
        if (blocks++ == 0)
            std::copy_n(block.values.begin(), 4, first.begin());
        std::copy_n(block.values.end() - 4, 4, last.begin());
        for (const int16_t value : block.values)
            sum += value;
        return true;
    });
    ASSERT_TRUE(walked) << walked.error().text();
    EXPECT_EQ(blocks, 51);
    EXPECT_EQ(next, 302500);
    EXPECT_EQ(first, (std::array<int16_t, 4>{-31, 2, -18, -25}));
    EXPECT_EQ(last, (std::array<int16_t, 4>{256, -419, 147, -364}));
    EXPECT_EQ(sum, 10184385);
}

TEST_F(TinyTake, SoundCanStopEarly) {
    int blocks = 0;
    EXPECT_TRUE(take->forEachBlock(1, [&](const AdcBlock&) { return ++blocks < 3; }));
    EXPECT_EQ(blocks, 3);
}

TEST_F(TinyTake, Rows) {
    const auto pulses = take->pulses();
    ASSERT_EQ(pulses->size(), 251u);
    EXPECT_EQ(pulses->front().sample, 1200);
    EXPECT_EQ(pulses->back().id, 251);
    EXPECT_EQ(pulses->back().sample, 301200);
    EXPECT_EQ((*pulses)[1].source, 1);
    const auto status = take->statusRows();
    ASSERT_EQ(status->size(), 3u);
    EXPECT_EQ(status->back().sample, 300000);
    EXPECT_EQ(status->front().temperature_c, 22.7);
    EXPECT_EQ(status->back().humidity_percent, 43);
    EXPECT_EQ(status->back().battery_v, 4.05);
    EXPECT_EQ(status->back().battery_percent, 85);
    EXPECT_TRUE(take->gaps()->empty());
    const auto markers = take->markers();  // the table has no column `suit`
    ASSERT_EQ(markers->size(), 2u);
    EXPECT_EQ(markers->back().label, "end");
    EXPECT_TRUE(take->markers(2)->empty());
    EXPECT_EQ(take->notes()->at(0).text, "two boards, two sources, two seconds");
    const auto rest = take->restInterval();
    ASSERT_TRUE(*rest);
    EXPECT_EQ((*rest)->first, 0);
    EXPECT_EQ((*rest)->last, 74999);
}

TEST_F(TinyTake, ReferenceAndExternalRoot) {
    const auto reference = take->reference();
    ASSERT_TRUE(reference) << reference.error().text();
    EXPECT_EQ(reference->skeleton.size(), 21);
    ASSERT_EQ(reference->frames.size(), 283u);
    EXPECT_EQ(reference->frames[1].time_ns, 7142857);
    const TimedPose& last = reference->frames.back();
    EXPECT_EQ(last.time_ns, 2014285714);
    ASSERT_TRUE(last.pose);
    EXPECT_EQ(last.pose->p_world_root,
              Vector3d(-0.01916315197146969, 0.9568233254781604, 0.0026004253179530727));
    EXPECT_NEAR(last.pose->q_parent_joint[0].y(), 0.05810066387205111, 1e-15);
    EXPECT_EQ(last.pose->q_parent_joint[20].w(), 1);
    const auto root = take->externalRoot();
    ASSERT_EQ(root->size(), 242u);
    EXPECT_EQ(root->back().time_ns, 2008333333);
    EXPECT_NEAR(root->back().q_world_root.x(), 0.004899484290310386, 1e-15);
    EXPECT_EQ(root->back().sigma_p_m, 0.0005);
    EXPECT_EQ(root->back().sigma_q_rad, 0.0017);
}

TEST_F(TinyTake, HasNothingDerivedYet) {
    EXPECT_TRUE(take->derivedRuns()->empty());
    auto readings = take->readings(kPrimaryRun);
    ASSERT_TRUE(readings);
    EXPECT_TRUE(test::collect(*readings).empty());
    auto ranges = take->ranges(kPrimaryRun);
    ASSERT_TRUE(ranges);
    EXPECT_TRUE(test::collect(*ranges).empty());
    EXPECT_EQ(take->poses(1).error().kind, ErrorKind::kUnusable);
}

Pose poseOf(int joints, double x) {
    Pose pose;
    pose.p_world_root = {x, 1, 2};
    pose.q_parent_joint.assign(static_cast<size_t>(joints), Quaterniond(0.5, 0.5, -0.5, 0.5));
    return pose;
}

TEST(TakeEdit, DerivedRunIsReadBack) {
    const Folder folder;
    Result<Take> take = Take::open(tinyTake(folder), Access::kReadWrite);
    ASSERT_TRUE(take);
    Result<TakeEdit> edit = TakeEdit::begin(*take);
    ASSERT_TRUE(edit) << edit.error().text();
    const auto inertial =
        edit->beginRun({0, "inertial", "decoded", "2026-01-01T00:00:00Z", "test", "", {}, {}});
    const auto range = edit->beginRun({0, "range", "heard", "", "", "", 1, {}});
    const auto pose = edit->beginRun({0, "pose", "AGD", "", "", "{\"sensors\":\"AGD\"}", 1, 1});
    ASSERT_TRUE(inertial && range && pose);
    EXPECT_EQ(*inertial, 1);
    EXPECT_EQ(*pose, 3);
    for (int frame = 0; frame < 3; ++frame)
        for (int board = 0; board < 2; ++board) {
            InertialReading reading{board, frame, 550.0 - 400 * board + 1071.25 * frame, {}, {}, {}};
            if (frame != 1) {
                reading.counts = {2048, 2049.5, std::nullopt, 0, 4095, 1};
                reading.corrected_bits = frame;
            }
            ASSERT_TRUE(edit->addInertial(*inertial, reading));
        }
    const RangeMeasurement measured{2, 2400, 1, 1, 2551.25, 0.348, 1, 0.5, 0.25, 0.003};
    ASSERT_TRUE(edit->addRange(*range, measured, "inflection"));
    const std::vector<double> sigma(63, 0.25);
    ASSERT_TRUE(edit->addPose(*pose, {7142857, poseOf(21, 0.5), sigma}));
    ASSERT_TRUE(edit->addPose(*pose, {0, poseOf(21, 0.25), {}}));
    ASSERT_TRUE(edit->setMeta("x_shop", "here"));
    ASSERT_TRUE(edit->commit());

    const Result<Take> again = Take::open(take->path());
    const auto runs = again->derivedRuns();
    ASSERT_EQ(runs->size(), 3u);
    EXPECT_EQ((*runs)[0].settings_json, "{}");
    EXPECT_EQ((*runs)[2].settings_json, "{\"sensors\":\"AGD\"}");
    EXPECT_EQ((*runs)[2].actor_id, 1);
    EXPECT_FALSE((*runs)[0].calibration_id);
    EXPECT_EQ(again->meta().at("x_shop"), "here");
    EXPECT_EQ(take->meta().at("x_shop"), "here");

    auto cursor = again->readings(*inertial);
    const auto readings = test::collect(*cursor);
    ASSERT_EQ(readings.size(), 6u);
    for (size_t i = 1; i < 6; ++i)
        EXPECT_GT(readings[i].sample, readings[i - 1].sample) << "both boards in one order of time";
    EXPECT_EQ(readings[0].board, 1);
    EXPECT_EQ(readings[0].counts[1], 2049.5);
    EXPECT_FALSE(readings[0].counts[2]);
    EXPECT_EQ(readings[0].counts[4], 4095);
    EXPECT_FALSE(readings[2].corrected_bits);
    EXPECT_EQ(readings[5].corrected_bits, 2);

    auto range_cursor = again->ranges(*range);
    const auto ranges = test::collect(*range_cursor);
    ASSERT_EQ(ranges.size(), 1u);
    EXPECT_EQ(range_cursor->detector(), "inflection");
    EXPECT_EQ(ranges[0].pulse_sample, 2400);
    EXPECT_EQ(ranges[0].source, 1);
    EXPECT_EQ(ranges[0].arrival_sample, 2551.25);
    EXPECT_EQ(ranges[0].confidence(), 0.125);
    EXPECT_EQ(ranges[0].sigma_m, 0.003);

    const auto motion = again->poses(*pose);
    ASSERT_TRUE(motion) << motion.error().text();
    ASSERT_EQ(motion->frames.size(), 2u);
    EXPECT_TRUE(motion->frames[0].sigma_rad.empty());
    EXPECT_EQ(motion->frames[1].sigma_rad, sigma);
    EXPECT_EQ(motion->frames[1].pose->p_world_root.x(), 0.5);
    EXPECT_EQ(motion->frames[1].pose->q_parent_joint[3].y(), -0.5);
}

TEST(TakeEdit, WithoutCommitNothingChanges) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    {
        Result<Take> take = Take::open(path, Access::kReadWrite);
        Result<TakeEdit> edit = TakeEdit::begin(*take);
        const auto run = edit->beginRun({0, "pose", "half", "", "", "", {}, {}});
        for (int i = 0; i < 5000; ++i)
            ASSERT_TRUE(edit->addPose(*run, {i, poseOf(21, i), {}}));
        ASSERT_TRUE(edit->removeReference());
        ASSERT_TRUE(edit->setMeta("name", "other"));
    }
    EXPECT_EQ(test::readBytes(path), test::readBytes(kTinyTake));
    EXPECT_EQ(folder.names().size(), 1u);
}

TEST(TakeEdit, DropsRunsButNeverPrimaryRows) {
    const Folder folder;
    Result<Take> take = Take::open(tinyTake(folder), Access::kReadWrite);
    {
        Result<TakeEdit> edit = TakeEdit::begin(*take);
        ASSERT_TRUE(edit->addInertial(kPrimaryRun, {0, 0, 129, {}, {}, 0}));
        ASSERT_EQ(*edit->beginRun({0, "inertial", "one", "", "", "", {}, {}}), 1);
        ASSERT_EQ(*edit->beginRun({0, "inertial", "two", "", "", "", {}, {}}), 2);
        ASSERT_TRUE(edit->addInertial(1, {0, 0, 129, {}, {}, 0}));
        ASSERT_TRUE(edit->addInertial(2, {0, 0, 129, {}, {}, 0}));
        ASSERT_TRUE(edit->commit());
    }
    Result<TakeEdit> edit = TakeEdit::begin(*take);
    EXPECT_EQ(edit->dropRun(kPrimaryRun).error().kind, ErrorKind::kUsage);
    ASSERT_TRUE(edit->dropRun(1));
    ASSERT_TRUE(edit->commit());
    const auto runs = take->derivedRuns();
    ASSERT_EQ(runs->size(), 1u);
    EXPECT_EQ((*runs)[0].name, "two");
    for (const auto& [run, count] : {std::pair{0, 1u}, {1, 0u}, {2, 1u}}) {
        auto cursor = take->readings(run);
        EXPECT_EQ(test::collect(*cursor).size(), count) << run;
    }
}

TEST(TakeEdit, NewestCalibrationIsInForce) {
    const Folder folder;
    Result<Take> take = Take::open(tinyTake(folder), Access::kReadWrite);
    Result<TakeEdit> edit = TakeEdit::begin(*take);
    Calibration newer = nominalCalibration(*take->suit());
    newer.created_utc = "2027-01-01T00:00:00Z";
    const auto id = edit->addCalibration(newer);
    ASSERT_TRUE(id) << id.error().text();
    EXPECT_EQ(*id, 2);
    Calibration others = newer;
    others.created_utc = "2028-01-01T00:00:00Z";
    ASSERT_TRUE(edit->addCalibration(others, 2));
    ASSERT_TRUE(edit->addExternalRoot({123, {1, 2, 3}, Quaterniond::Identity(), 0.1, 0.2}));
    ASSERT_TRUE(edit->commit());
    EXPECT_EQ(take->calibrationInForce()->value.created_utc, "2027-01-01T00:00:00Z");
    EXPECT_EQ(take->calibrationInForce(2)->id, 3);
    EXPECT_EQ(take->calibration(1)->created_utc, "2026-11-12T11:17:00Z");
    EXPECT_EQ(take->externalRoot()->size(), 243u);
}

TEST(TakeEdit, NumbersThatAreNoneStopAtTheBorder) {
    const Folder folder;
    Result<Take> take = Take::open(tinyTake(folder), Access::kReadWrite);
    Result<TakeEdit> edit = TakeEdit::begin(*take);
    RangeMeasurement range;
    range.distance_m = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(edit->addRange(1, range, "x").error().kind, ErrorKind::kInternal);
    TimedPose timed{0, poseOf(21, std::numeric_limits<double>::infinity()), {}};
    EXPECT_FALSE(edit->addPose(1, timed));
    EXPECT_FALSE(edit->addReference(timed));
    range.distance_m = 1;
    EXPECT_TRUE(edit->addRange(1, range, "x")) << "a refused row must not spoil the next";
}

}  // namespace
}  // namespace noctule
