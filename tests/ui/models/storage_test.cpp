// SPDX-License-Identifier: Apache-2.0
#include "ui/models/storage.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QSignalSpy>

#include "tests/ui/support/wait.h"

namespace noctule::ui {
namespace {

TEST(StorageWatchTest, AFolderIsAskedOnceAtATimeAndTheLatestCounts) {
    Jobs jobs;
    QString folder = QDir::tempPath();
    StorageWatch watch(jobs, [&] { return folder; });
    QSignalSpy changed(&watch, &StorageWatch::changed);
    ASSERT_TRUE(waitFor([&] { return changed.count() == 1 && jobs.idle(); }));
    EXPECT_GT(watch.freeBytes(), 0);
    watch.look();
    watch.look();
    ASSERT_TRUE(waitFor([&] { return jobs.idle(); }));
    EXPECT_EQ(changed.count(), 2) << "the first has not answered yet";
    watch.look();
    folder = QDir::rootPath();
    watch.look();
    ASSERT_TRUE(waitFor([&] { return jobs.idle(); }));
    EXPECT_EQ(changed.count(), 3) << "nobody asks for the folder before";
}

}  // namespace
}  // namespace noctule::ui
