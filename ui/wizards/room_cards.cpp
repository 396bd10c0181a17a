// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/room_cards.h"

#include <algorithm>

#include "ui/language/core_words.h"
#include "ui/style/lengths.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/bar_meter.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/section_header.h"
#include "ui/wizards/calibration_table_card.h"
#include "ui/wizards/finding_card.h"
#include "ui/wizards/room_drawing.h"
#include "ui/wizards/room_page.h"

namespace noctule::ui {
namespace {

using room_survey::RoomSurvey;
using room_survey::SurveyedAnchor;

AnchorState stateIn(SurveyStage stage, const SurveyedAnchor& anchor) {
    return stage == SurveyStage::kWalking ? stateSoFar(anchor) : stateOf(anchor);
}

/// "2 good, 1 weak"
QString countOf(const RoomSurvey& survey, SurveyStage stage) {
    std::vector<std::pair<QString, int>> counts;
    for (const SurveyedAnchor& anchor : survey.anchors) {
        const QString words = stateIn(stage, anchor).words;
        const auto same = std::ranges::find(counts, words, &std::pair<QString, int>::first);
        if (same == counts.end())
            counts.emplace_back(words, 1);
        else
            ++same->second;
    }
    QStringList list;
    for (const auto& [words, count] : counts)
        list << QStringLiteral("%1 %2").arg(count).arg(words);
    return list.join(", ");
}

Button* choiceButton(size_t index, bool is_out, const AnchorChoice& choice) {
    const QString number = QString::number(index + 1);
    Button* button =
        makeButton(ButtonKind::kText, is_out ? RoomPage::tr("Use anchor %1 again").arg(number)
                                             : RoomPage::tr("Use without anchor %1").arg(number));
    button->setFlush(true);
    button->setDisabledBecause(is_out ? QString() : choice.why_not_without(index));
    // Later: the cards are made anew, this button with them.
    QObject::connect(
        button, &QPushButton::clicked, button,
        [choose = choice.choose, index, is_out] { choose(index, !is_out); }, Qt::QueuedConnection);
    return button;
}

Card* anchorCard(const RoomSurvey& survey, size_t index, SurveyStage stage, const AnchorChoice* choice) {
    const SurveyedAnchor& anchor = survey.anchors[index];
    const AnchorState state = stateIn(stage, anchor);
    auto* card = new Card;
    auto* column = makeColumn(card, {12, 8, 12, 10}, 6);
    auto* head = addRow(column, 8);
    head->addWidget(new Label(RoomPage::tr("Anchor %1").arg(QString::number(index + 1)), TextRole::kBody,
                              Ink::kValue, true));
    head->addWidget(new Label(QString::fromStdString(anchor.id), TextRole::kSecondary, Ink::kHint));
    head->addStretch();
    const Ink ink = inkOf(state.tone);
    head->addWidget(new IconLabel(iconOf(state.tone), [ink] { return colorOf(ink); }));
    head->addWidget(new Label(state.words, TextRole::kSecondary, ink, true));
    auto* numbers = addRow(column, 8);
    if (anchor.placed) {
        numbers->addWidget(new Label(RoomPage::tr("height %1").arg(lengthText(anchor.place_m.y())),
                                     TextRole::kSecondary, Ink::kLabel));
        numbers->addWidget(new Label(QStringLiteral("±%1").arg(millimetresText(anchor.sigma_m)),
                                     TextRole::kSecondary, state.tone == Tone::kOk ? Ink::kLabel : ink));
    }
    numbers->addStretch();
    const QString heard = RoomPage::tr("heard %1 of %2").arg(anchor.heard).arg(anchor.sent);
    numbers->addWidget(new Label(heard, TextRole::kSecondary, Ink::kLabel));
    auto* bar = new BarMeter;
    bar->setValue(anchor.heardShare(), state.tone, heard);
    column->addWidget(bar);
    QStringList hears;
    for (const int other : anchor.hears)
        hears << QString::number(other + 1);
    if (!hears.isEmpty())
        column->addWidget(
            new Label(RoomPage::tr("hears anchor %1", nullptr, int(hears.size())).arg(hears.join(", ")),
                      TextRole::kSecondary, Ink::kHint));
    if (choice)
        column->addWidget(choiceButton(index, anchor.left_out, *choice), 0, Qt::AlignLeft);
    return card;
}

}  // namespace

void showAnchorCards(QBoxLayout& column, const SurveyedTake& surveyed, SurveyStage stage,
                     const AnchorChoice* choice) {
    clearWidgets(column);
    const RoomSurvey& survey = surveyed.survey;
    column.addWidget(new SectionHeader(RoomPage::tr("Anchors"), countOf(survey, stage)));
    for (size_t i = 0; i < survey.anchors.size(); ++i)
        column.addWidget(anchorCard(survey, i, stage, choice));
    const auto& tables = surveyed.result.document.tables;
    if (!survey.distances.empty() && !tables.empty())
        column.addWidget(new CalibrationTableCard(tables.back()));
    column.addStretch();
}

void showFindingCards(QBoxLayout& column, const SurveyedTake& surveyed, SurveyStage stage) {
    clearWidgets(column);
    const std::vector<Finding>& findings = surveyed.result.document.findings;
    if (stage == SurveyStage::kWalking) {
        const auto worst = std::ranges::max_element(findings, {}, &Finding::grade);
        if (worst != findings.end())
            column.addWidget(findingCard(*worst, Tone::kWarn));
        return;
    }
    for (const std::string& warning : surveyed.result.warnings)
        column.addWidget(new ProblemCard(Tone::kWarn, coreWords(warning), {}));
    for (const Finding& finding : findings)
        column.addWidget(findingCard(finding, toneOf(finding)));
}

void showErrorCard(QBoxLayout& column, const Error& error) {
    clearWidgets(column);
    column.addWidget(new ProblemCard(Tone::kError, coreWords(error.message), coreWords(error.remedy + ".")));
}

}  // namespace noctule::ui
