// SPDX-License-Identifier: Apache-2.0
// The documents and the diagnosis, as somebody who needs help meets them.
#include <QDir>
#include <QRegularExpression>

#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/diagnosis.h"
#include "ui/main_window/help_window.h"
#include "ui/models/studio_log.h"
#include "ui/wizards/wizard_task.h"

namespace noctule::ui {
namespace {

using HelpWindowTest = test::StudioWindow;

TEST_F(HelpWindowTest, EveryDocumentOpensWithItsPicturesAndLinks) {
    HelpWindow help;
    for (int row = 0; row < help.contents().count(); ++row) {
        const QString name = help.contents().item(row)->data(Qt::UserRole).toString();
        help.showDocument(name);
        const QString markdown = help.page().document()->toMarkdown();
        const QString text = help.page().toPlainText();
        EXPECT_GT(text.size(), 500) << name.toStdString();
        EXPECT_FALSE(text.contains("|-")) << name.toStdString() << ": a table is shown as it is written";
        QRegularExpression link(R"(\]\(([^)#\s]+)(#[^)]*)?\))");
        for (auto all = link.globalMatch(markdown); all.hasNext();) {
            const QString target = all.next().captured(1);
            if (target.contains("://"))
                continue;
            const QUrl url = help.page().source().resolved(QUrl(target));
            EXPECT_TRUE(QFile::exists(':' + url.path()) || !target.endsWith(".md"))
                << name.toStdString() << ": " << target.toStdString();
        }
    }
    EXPECT_EQ(help.contents().count(),
              QDir(":/noctule/docs").entryList({"*.md"}).size() - 1)  // the index is the list itself
        << "a document is missing in the list";
}

TEST_F(HelpWindowTest, ALinkLeadsToTheOtherDocument) {
    HelpWindow help;
    help.showDocument("guide");
    emit help.page().anchorClicked(QUrl("glossary.md"));
    EXPECT_EQ(help.contents().currentItem()->data(Qt::UserRole).toString(), "glossary");
    EXPECT_TRUE(help.page().source().path().endsWith("/glossary.md"));
}

TEST_F(HelpWindowTest, ADiagnosisSaysWhatHappenedAndNotToWhom) {
    LogFile log(folder_.filePath("state"));
    const StudioLog follows(*studio_, log);
    openSampleTake();
    emit studio_->failed("the disk is full", "Free some space", About::kFile);
    const QString session = QString::fromStdString(studio_->session().session().folder.string());
    const QString text = diagnosisText(*studio_, log);
    EXPECT_TRUE(text.contains("error the disk is full | Free some space"));
    EXPECT_TRUE(text.contains("take opened"));
    EXPECT_TRUE(text.contains("no suit is connected"));
    EXPECT_TRUE(text.contains("Qt 5."));
    EXPECT_FALSE(text.contains(session));
    EXPECT_FALSE(text.contains(folder_.path()));
    EXPECT_FALSE(text.contains(QString::fromStdString(studio_->session().session().performers.front().name)));
}

/// As somebody saves it who has closed the session in which it happened, a log of an earlier version too.
TEST_F(HelpWindowTest, ADiagnosisNamesNobodyOfSessionsThatAreClosed) {
    LogFile log(folder_.filePath("state"));
    const StudioLog follows(*studio_, log);
    openSampleTake();
    const Session& open = studio_->session().session();
    const QString name = QString::fromStdString(open.folder.filename().string());
    const QString take = QString::fromStdString(open.takes.front().name);
    const QString performer = QString::fromStdString(open.performers.front().name);
    studio_->session().close();
    log.write("info", "job begins: Processing " + take);
    log.write("info", "job begins: Opening session " + name);
    log.write("warning", performer + " is not there");
    const QString text = diagnosisText(*studio_, log);
    EXPECT_TRUE(text.contains("job begins: Processing [name"));
    for (const QString& word : {name, take, performer})
        EXPECT_FALSE(text.contains(word)) << word.toStdString() << " is in " << text.toStdString();
}

TEST_F(HelpWindowTest, TheLogItselfHoldsNoNames) {
    LogFile log(folder_.filePath("state"));
    const StudioLog follows(*studio_, log);
    studio_->jobs().start<int>(
        {"Reading %1", "Özil runs.bvh"}, [](const JobContext&) -> Result<int> { return 3; },
        [](const Result<int>&) { return QString(); });
    emit studio_->failed("Özil runs.bvh is torn", "Look at /srv/anna/Özil runs.bvh", About::kFile);
    openSampleTake();
    const Session& open = studio_->session().session();
    emit studio_->warned(QString::fromStdString(open.takes.front().name) + " is short", About::kFile);
    const QString text = log.newest(100'000);
    EXPECT_TRUE(text.contains("job begins: Reading [name-")) << text.toStdString();
    EXPECT_TRUE(text.contains("] is torn | Look at [path]/*")) << text.toStdString();
    EXPECT_TRUE(text.contains("] is short")) << text.toStdString();
    for (const QString& word :
         {QString::fromUtf8("Özil"), QString("srv"), QString::fromStdString(open.takes.front().name)})
        EXPECT_FALSE(text.contains(word)) << word.toStdString() << " is in " << text.toStdString();
}

TEST_F(HelpWindowTest, TheGuideSaysOfCalibrationsWhatTheirPagesSay) {
    QFile file(":/noctule/docs/guide.md");
    ASSERT_TRUE(file.open(QFile::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
    const auto both = [&](const char* row, const QString& of_page, const QString& phrase) {
        const QString in_guide = lines.filter(QStringLiteral("| %1 |").arg(row)).join('\n');
        EXPECT_TRUE(in_guide.contains(phrase)) << in_guide.toStdString();
        EXPECT_TRUE(of_page.contains(phrase, Qt::CaseInsensitive)) << of_page.toStdString();
    };
    both("movement", wordsOf(WizardTask::kMovement).takes, "six exercises, about 2 minutes");
    both("gyroscopes", wordsOf(WizardTask::kGyroscopes).needs.front(), "45, 33 1/3 or 78 turns a minute");
}

}  // namespace
}  // namespace noctule::ui
