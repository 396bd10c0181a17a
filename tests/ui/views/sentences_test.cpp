// SPDX-License-Identifier: Apache-2.0
// Sentences that operators asked for, where they are said.
#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>

#include "tests/ui/views/reviewed_session.h"
#include "ui/views/export/export_form.h"
#include "ui/views/performer/performer_editor.h"
#include "ui/views/performer/performer_list_panel.h"
#include "ui/views/readiness_words.h"
#include "ui/views/review/reprocess_dialog.h"

namespace noctule::ui {
namespace {

using SentencesTest = test::ReviewedSession;

QStringList saidBy(const QWidget& widget) {
    QStringList said;
    for (const auto* label : widget.findChildren<QLabel*>())
        said += label->text();
    for (const auto* button : widget.findChildren<QAbstractButton*>())
        said += button->text();
    for (const auto* box : widget.findChildren<QComboBox*>())
        for (int item = 0; item < box->count(); ++item)
            said += box->itemText(item);
    return said;
}

TEST_F(SentencesTest, AreSaidWhereTheyAreNeeded) {
    openTake("swing_001");
    const ReprocessDialog dialog(*studio_, *studio_->take().overview());
    const ExportForm form(*studio_);
    PerformerEditor editor(studio_->session());
    const PerformerListPanel performers(editor);
    editor.add();
    const auto number = studio_->session().session().performers.size();
    ASSERT_EQ(editor.index() + 1, static_cast<int>(number));
    const struct {
        QStringList said;
        QString sentence;
    } table[] = {
        {saidBy(performers), QString("Put the suit on Performer %1").arg(number)},
        {saidBy(form), "Common (Hips, Spine, LeftArm)"},
        {saidBy(dialog), "From another system"},
        {saidBy(dialog), "Its hips are used."},
        {{batteryLeft(12, 45 * 60)},
         QString("12\u00A0% is left, about 45 min. Charge it before a long take.")},
        {{batteryLeft(12, {})}, QString("12\u00A0% is left. Charge it before a long take.")},
    };
    for (const auto& [said, sentence] : table)
        EXPECT_TRUE(said.contains(sentence))
            << sentence.toStdString() << " in " << said.join(" | ").toStdString();
}

TEST_F(SentencesTest, WhatBefallsAllBoardsIsSaidOnceAndBlamesNone) {
    ReadinessProblem problem;
    problem.kind = ProblemKind::kBoardLosesFrames;
    problem.value = 90;
    problem.alike = {0, 1, 2, 3};
    const HindranceWords words = wordsOf(problem, studio_->check());
    EXPECT_EQ(words.title, "The stream loses frames");
    EXPECT_TRUE(words.text.startsWith("4 boards bring about 90 of ")) << words.text.toStdString();
    EXPECT_TRUE(words.text.contains("the link or this computer is too slow")) << words.text.toStdString();
    EXPECT_FALSE(words.text.contains("plug")) << "no board is at fault";
}

}  // namespace
}  // namespace noctule::ui
