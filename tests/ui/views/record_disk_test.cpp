// SPDX-License-Identifier: Apache-2.0
// What step Record offers where the disk has no room for a take.
#include <QFile>

#include "tests/ui/views/record_fixture.h"

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

TEST_F(RecordDisk, ATakeThatEndedBeforeAnythingWasRecordedIsRemoved) {
    RecorderState recorded;
    recorded.path = folder_.filePath("take_001.noctule").toStdString();
    const auto isThere = [&] { return QFile::exists(QString::fromStdString(recorded.path)); };
    QFile file(QString::fromStdString(recorded.path));
    ASSERT_TRUE(file.open(QFile::WriteOnly));
    file.close();
    recorded.samples = 3000;
    EXPECT_FALSE(LiveSuit::removeWhenEmpty(recorded, 150000)) << "the operator ended it";
    recorded.trouble = Error{ErrorKind::kDisk, "The disk is full", "Free some space"};
    recorded.samples = 30000;
    EXPECT_FALSE(LiveSuit::removeWhenEmpty(recorded, 150000));
    EXPECT_TRUE(isThere());
    recorded.samples = 3000;
    EXPECT_TRUE(LiveSuit::removeWhenEmpty(recorded, 150000));
    EXPECT_FALSE(isThere());
}

}  // namespace
}  // namespace noctule::ui
