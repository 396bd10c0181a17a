// SPDX-License-Identifier: Apache-2.0
// Where dialogs for files begin, and that all of them ask here.
#include "ui/models/file_choice.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "ui/models/shared_context.h"

namespace noctule::ui {
namespace {

class FileChoiceTest : public testing::Test {
protected:
    void SetUp() override {
        QSettings().clear();
        FileChoice::setSession({});
        for (const char* folder : {"session", "used", "usual", "given"})
            ASSERT_TRUE(QDir(home_.path()).mkpath(folder));
    }
    void TearDown() override { FileChoice::setSession({}); }
    QString in(const char* name) const { return home_.filePath(name); }

    const QTemporaryDir home_;
};

TEST_F(FileChoiceTest, BeginsWhereAFileOfItsKindWasChosenLast) {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString without = QFileInfo(documents).isDir() ? documents : QDir::homePath();
    FileChoice choice{"reports", "Save"};
    EXPECT_EQ(choice.start(), without) << "never where the program was started";
    FileChoice::setSession(in("session"));
    EXPECT_EQ(choice.start(), in("session"));
    choice.usual = in("usual");
    EXPECT_EQ(choice.start(), in("usual"));
    choice.remember(in("used/report.html"));
    EXPECT_EQ(choice.start(), in("used"));
    EXPECT_EQ((FileChoice{"rooms", "Save"}).start(), in("session")) << "each kind has its own";
    choice.at = in("given");
    EXPECT_EQ(choice.start(), in("given"));
    choice.at.clear();
    choice.remember({});
    EXPECT_EQ(choice.start(), in("used")) << "a dialog that was cancelled changes nothing";
    ASSERT_TRUE(QDir(in("used")).removeRecursively());
    choice.usual = in("not there");
    EXPECT_EQ(choice.start(), in("session")) << "folders that are gone";
}

TEST_F(FileChoiceTest, WhatASessionGivesIsNotWrittenIntoTheOneBefore) {
    for (const char* session : {"session", "used"}) {
        QFile file(in(session) + "/session.json");
        ASSERT_TRUE(QDir(in(session)).mkpath("exports") && file.open(QIODevice::WriteOnly));
    }
    FileChoice::setSession(in("session"));
    const FileChoice report{.kind = "reports", .title = "Save", .name = "report.html"};
    report.remember(in("used/exports/report.html"));
    EXPECT_EQ(report.start(), in("session"));
    EXPECT_EQ((FileChoice{"reports", "Open"}).start(), in("used/exports")) << "one may read there";
    report.remember(in("session/exports/report.html"));
    EXPECT_EQ(report.start(), in("session/exports"));
}

TEST_F(FileChoiceTest, TheOpenSessionIsWhereDialogsBegin) {
    QSettings().setValue("folders/sessions", in("given"));
    SharedContext shared(StudioParts{"test", [] { return std::string("2026-01-01T00:00:00Z"); }, {}});
    const FileChoice choice{"rooms", "Save"};
    ASSERT_TRUE(shared.session().create(in("made"), "made"));
    EXPECT_EQ(QFileInfo(choice.start()).canonicalFilePath(), QFileInfo(in("made")).canonicalFilePath());
    shared.session().close();
    EXPECT_NE(QFileInfo(choice.start()).canonicalFilePath(), QFileInfo(in("made")).canonicalFilePath());
}

TEST_F(FileChoiceTest, NobodyElseAsksForFiles) {
    QStringList askers;
    for (const char* room : {"ui", "app"})
        for (QDirIterator files(QString(NOCTULE_SOURCE_DIR "/") + room, {"*.cpp", "*.h"}, QDir::Files,
                                QDirIterator::Subdirectories);
             files.hasNext();) {
            QFile file(files.next());
            ASSERT_TRUE(file.open(QIODevice::ReadOnly));
            if (file.readAll().contains("QFileDialog::get"))
                askers << QFileInfo(file).fileName();
        }
    EXPECT_EQ(askers, QStringList{"file_choice.cpp"});
}

}  // namespace
}  // namespace noctule::ui
