// SPDX-License-Identifier: Apache-2.0
// The written files on the Export page: their cards, and what is said of those that were not written.
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPointer>

#include "core/job/atomic_file.h"
#include "tests/ui/views/export_page_fixture.h"
#include "ui/views/job_progress.h"

namespace noctule::ui {
namespace {

class ExportResultsTest : public test::ExportPageTest {
protected:
    void TearDown() override {
        if (!path_.isNull())
            qputenv("PATH", path_);
        ExportPageTest::TearDown();
    }
    /// What opens files and folders from now on, instead of the desktop's own; told_ has what went wrong.
    void openBy(const QString& script) {
        QFile opener(outsideFile("xdg-open"));
        ASSERT_TRUE(opener.open(QFile::WriteOnly));
        opener.write(("#!/bin/sh\n" + script).toLocal8Bit());
        opener.close();
        opener.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        QObject::connect(studio_.get(), &Studio::failed, [this](const QString& what) { told_ += what; });
        path_ = qgetenv("PATH");
        qputenv("PATH", outsideFile("").toLocal8Bit() + ":" + path_);
    }

    QStringList told_;

private:
    QByteArray path_;
};

TEST_F(ExportResultsTest, AnyChangeBringsWriteBackAndReturnOpensNoFolder) {
    write();
    EXPECT_FALSE(page_->writeButton()->isVisible()) << "the files are there";
    const QString said = "No file manager could be started";
    QStringList told;
    QObject::connect(studio_.get(), &Studio::failed, [&](const QString& what) { told += what; });
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", outsideFile("nothing").toLocal8Bit());
    QTest::keyClick(page_.get(), Qt::Key_Return);
    QTest::qWait(100);
    EXPECT_TRUE(told.isEmpty()) << "Return opened the folder";
    page_->openFolder();
    EXPECT_TRUE(waitFor([&] { return told == QStringList{said}; }));
    qputenv("PATH", path);

    page_->form().frames->setCurrentIndex(page_->form().frames->findData(60.0));
    EXPECT_TRUE(page_->writeButton()->isVisible());
    EXPECT_TRUE(page_->writeButton()->text().contains('1'));
    page_->form().frames->setCurrentIndex(page_->form().frames->findData(120.0));
    EXPECT_FALSE(page_->writeButton()->isVisible()) << "as it was written";
    page_->form().also[ExportFormat::kGlb]->setChecked(true);
    EXPECT_TRUE(page_->writeButton()->isVisible()) << "another format";
    page_->form().also[ExportFormat::kGlb]->setChecked(false);
    EXPECT_FALSE(page_->writeButton()->isVisible());
    page_->form().run->setCurrentIndex(1);  // last of each take
    EXPECT_TRUE(page_->writeButton()->isVisible()) << "another choice of results";
    page_->form().run->setCurrentIndex(0);  // as shown
    EXPECT_FALSE(page_->writeButton()->isVisible());
    page_->choosePreset("web");
    EXPECT_TRUE(page_->writeButton()->isVisible());
    QTest::keyClick(page_.get(), Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] {
        return QFile::exists(QString::fromStdString(exported("swing_001_60.glb"))) && jobsAreDone();
    }));
    EXPECT_EQ(page_->resultsPanel().cardCount(), 3) << "the new file, a heading, and the file before";
    page_->enter();
    EXPECT_EQ(page_->resultsPanel().cardCount(), 3) << "they stay when the page is left";
}

TEST_F(ExportResultsTest, AFileManagerThatFailsLateIsToldToo) {
    write();
    openBy("sleep 6\nexit 4\n");
    page_->openFolder();
    EXPECT_TRUE(waitFor([this] { return told_ == QStringList{"No file manager could be started"}; }));
}

TEST_F(ExportResultsTest, AWrittenFileIsOpenedFromItsCardAndATrialIsNot) {
    const auto openers = [this] {
        QList<Button*> found;
        for (Button* button : page_->resultsPanel().findChildren<Button*>())
            if (button->text() == "Open")
                found += button;
        return found;
    };
    page_->tryOneFrame();
    ASSERT_TRUE(waitFor([this] { return page_->resultsPanel().cardCount() == 1 && jobsAreDone(); }));
    EXPECT_TRUE(openers().isEmpty()) << "its file is deleted";
    write();
    ASSERT_EQ(openers().size(), 1);
    const QString opened = outsideFile("opened");
    openBy("echo \"$1\" > '" + opened + "'\nexit 3\n");
    openers().front()->click();
    EXPECT_TRUE(waitFor([this] { return told_ == QStringList{"No program opened swing_001_120.bvh"}; }));
    const auto given = readWholeFile(opened.toStdString());
    ASSERT_TRUE(given);
    EXPECT_EQ(std::string(given->begin(), given->end()), exported("swing_001_120.bvh") + "\n");
    told_.clear();
    QFile::remove(QString::fromStdString(exported("swing_001_120.bvh")));
    openers().front()->click();
    EXPECT_EQ(told_, QStringList{QString::fromStdString(exported("swing_001_120.bvh")) + " is not there"});
}

TEST_F(ExportResultsTest, WhyFilesWereNotWrittenIsForgottenWhenOthersAreAskedFor) {
    const std::filesystem::path exports = studio_->session().session().exportsFolder();
    std::filesystem::remove_all(exports);
    ASSERT_TRUE(writeFileAtomically(exports.string(), "a file in the way", true));
    QTest::mouseClick(page_->writeButton(), Qt::LeftButton);
    const auto* progress = page_->findChild<JobProgress*>();
    ASSERT_TRUE(waitFor([&] { return progress->isVisible() && jobsAreDone(); })) << "it says why";
    page_->enter();
    EXPECT_TRUE(progress->isVisible()) << "nothing has changed";
    page_->form().frames->setCurrentIndex(page_->form().frames->findData(60.0));
    EXPECT_FALSE(progress->isVisible());
}

TEST_F(ExportResultsTest, NothingIsOverwritten) {
    write();
    page_->write();
    ASSERT_TRUE(
        waitFor([this] { return QFile::exists(QString::fromStdString(exported("swing_001_120_2.bvh"))); }));
    EXPECT_TRUE(QFile::exists(QString::fromStdString(exported("swing_001_120.bvh"))));
}

TEST_F(ExportResultsTest, OneFrameLeavesNoFile) {
    page_->tryOneFrame();
    ASSERT_TRUE(waitFor([this] { return page_->resultsPanel().cardCount() == 1 && jobsAreDone(); }));
    EXPECT_FALSE(page_->results()) << "a trial is no export";
    EXPECT_FALSE(QFile::exists(QString::fromStdString(exported("swing_001_120.bvh"))));
}

}  // namespace
}  // namespace noctule::ui
