// SPDX-License-Identifier: Apache-2.0
// Files dragged from the desktop onto the window.
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>

#include "tests/ui/main_window/studio_fixture.h"

namespace noctule::ui {
namespace {

class Drop : public test::StudioWindow {
protected:
    QString makeTake(const QString& name) {
        const QString path = folder_.filePath(name + ".noctule");
        EXPECT_TRUE(test::makeQuickTake(path.toStdString(), {}));
        return path;
    }
    QString makeSession(const QString& name) {
        QDir().mkpath(home());
        QString folder = QDir(home()).filePath(name);
        EXPECT_TRUE(studio_->session().create(folder, name));
        return folder;
    }
    /// Whether the window took them.
    bool drop(const QStringList& paths) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& path : paths)
            urls.append(QUrl::fromLocalFile(path));
        data.setUrls(urls);
        const QPoint middle = window_->rect().center();
        QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        enter.ignore();
        QApplication::sendEvent(window_.get(), &enter);
        if (!enter.isAccepted())
            return false;
        QDropEvent released(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &released);
        return true;
    }
};

TEST_F(Drop, ASessionOpens) {
    const QString folder = makeSession("Dropped");
    studio_->session().close();
    ASSERT_TRUE(drop({folder}));
    EXPECT_TRUE(waitFor([this] { return studio_->session().isOpen(); }));
}

TEST_F(Drop, ATakeOpensInReview) {
    ASSERT_TRUE(drop({makeTake("walk_001")}));
    ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen(); }));
    EXPECT_EQ(window_->step(), Step::kReview);
}

TEST_F(Drop, TakesAreCopiedIntoTheOpenSession) {
    makeSession("Stage tests");
    const QStringList takes{makeTake("walk_001"), makeTake("walk_002")};
    ASSERT_TRUE(drop(takes));
    ASSERT_TRUE(waitFor([this] { return studio_->session().session().takes.size() == 2; }));
    EXPECT_EQ(window_->step(), Step::kReview);
    for (const QString& take : takes)
        EXPECT_TRUE(QFile::exists(take)) << "the originals stay";
}

TEST_F(Drop, WhatTheStudioDoesNotKnowIsNotTaken) {
    const QString letter = folder_.filePath("letter.odt");
    QFile file(letter);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    EXPECT_FALSE(drop({letter}));
    EXPECT_FALSE(drop({folder_.path()})) << "a folder without a session";
    EXPECT_EQ(window_->notices().count(), 0);
}

}  // namespace
}  // namespace noctule::ui
