// SPDX-License-Identifier: Apache-2.0
// What step Record offers where the disk has no room for a take.
#include <QFile>

#include "tests/ui/views/record_fixture.h"
#include "ui/models/live_steps.h"

namespace noctule::ui {
namespace {

using RecordDisk = test::RecordFixture;

ReadinessProblem roomFor(double seconds) {
    ReadinessProblem problem;
    problem.kind = ProblemKind::kStorageShort;
    problem.hinders = true;
    problem.value = seconds;
    return problem;
}

TEST_F(RecordDisk, OffersNoTakeThatWouldEndAtOnce) {
    const SuitCheck& check = studio_->suits().current().check;
    const RecordObstacle full = obstacleOf(roomFor(0), check, "/media/stage");
    EXPECT_FALSE(full.may_record_anyway);
    EXPECT_TRUE(full.is_of_disk);
    EXPECT_TRUE(full.text.contains("/media/stage")) << full.text.toStdString();
    const RecordObstacle scarce = obstacleOf(roomFor(40), check, "/media/stage");
    EXPECT_TRUE(scarce.may_record_anyway);
    EXPECT_FALSE(scarce.is_of_disk);
}

/// Of one suit, and of two into one file.
TEST_F(RecordDisk, ATakeThatEndedBeforeAnythingWasRecordedIsRemoved) {
    for (const size_t suits : {1, 2}) {
        RecorderState recorded;
        recorded.path = folder_.filePath("take_001.noctule").toStdString();
        const auto isThere = [&] { return QFile::exists(QString::fromStdString(recorded.path)); };
        QFile file(QString::fromStdString(recorded.path));
        ASSERT_TRUE(file.open(QFile::WriteOnly));
        file.close();
        recorded.samples = 3000;
        std::vector<RecordReport> parts(suits);
        for (RecordReport& part : parts) {
            part.sample_rate_hz = 150000;
            part.stream.recording = recorded;
        }
        EXPECT_FALSE(endOfTake(parts, false).is_empty) << "the operator ended it";
        RecorderState& last = *parts.back().stream.recording;
        last.trouble = Error{ErrorKind::kDisk, "The disk is full", "Free some space"};
        parts.front().stream.recording->samples = 30000;
        EXPECT_FALSE(endOfTake(parts, true).is_empty) << "something is there of one of them";
        EXPECT_TRUE(isThere());
        EXPECT_TRUE(endOfTake(parts, true).trouble.startsWith("The disk is full"));
        parts.front().stream.recording->samples = 3000;
        parts.emplace_back();
        EXPECT_FALSE(endOfTake(parts, true).is_empty) << "of one of them nothing is known";
        EXPECT_TRUE(isThere());
        parts.pop_back();
        const TakeEnd end = endOfTake(parts, true);
        EXPECT_TRUE(end.is_empty);
        EXPECT_TRUE(end.trouble.endsWith("Nothing was recorded, and the take was removed."));
        EXPECT_FALSE(isThere());
    }
}

TEST_F(RecordDisk, WhatADeviceTellsIsTheTroubleOfATakeThatNobodyStopped) {
    std::vector<RecordReport> parts(2);
    parts.back().stream.trouble = Error{ErrorKind::kDevice, "The box is gone", "Switch it on"};
    EXPECT_EQ(endOfTake(parts, false).trouble, "");
    EXPECT_TRUE(endOfTake(parts, true).trouble.startsWith("The box is gone"));
}

}  // namespace
}  // namespace noctule::ui
