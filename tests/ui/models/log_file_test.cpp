// SPDX-License-Identifier: Apache-2.0
#include "ui/models/log_file.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QTemporaryDir>

namespace noctule::ui {
namespace {

TEST(LogFileTest, KeepsALinePerEventAndReadsTheNewest) {
    const QTemporaryDir folder;
    LogFile log(folder.filePath("state/noctule"));
    log.write("info", "one");
    log.write("error", "two\nwith a break\x1b[31m");
    const QStringList lines = log.newest(10'000).split('\n', Qt::SkipEmptyParts);
    ASSERT_EQ(lines.size(), 2);
    EXPECT_TRUE(lines[0].endsWith("Z info one")) << lines[0].toStdString();
    EXPECT_TRUE(lines[1].endsWith("Z error two with a break [31m")) << lines[1].toStdString();
    EXPECT_EQ(QFile::permissions(log.path()) & (QFile::ReadGroup | QFile::ReadOther), 0);
    EXPECT_EQ(log.newest(lines[1].toUtf8().size() + 5), lines[1] + '\n') << "no line is cut";
}

TEST(LogFileTest, NeverGrowsBeyondThreeFiles) {
    const QTemporaryDir folder;
    LogFile log(folder.path());
    const QString text(1900, 'x');
    for (int i = 0; i < 2500; ++i)
        log.write("info", QString::number(i) + ' ' + text);
    qint64 bytes = 0;
    const QFileInfoList files = QDir(folder.path()).entryInfoList(QDir::Files);
    for (const QFileInfo& file : files)
        bytes += file.size();
    EXPECT_EQ(files.size(), 1 + LogFile::kKept);
    EXPECT_LT(bytes, (1 + LogFile::kKept) * (LogFile::kLargest_bytes + 4000));
    EXPECT_TRUE(log.newest(5000).contains(" 2499 ")) << "the newest stays";
    EXPECT_GT(log.newest(2'500'000).size(), 2'400'000) << "older files are read too";
}

TEST(LogFileTest, WhereItCannotBeWrittenNothingFails) {
    LogFile nowhere{QString()};
    nowhere.write("info", "lost");
    EXPECT_TRUE(nowhere.newest(1000).isEmpty());
    LogFile impossible("/proc/noctule");
    impossible.write("info", "lost");
    EXPECT_TRUE(impossible.newest(1000).isEmpty());
}

}  // namespace
}  // namespace noctule::ui
