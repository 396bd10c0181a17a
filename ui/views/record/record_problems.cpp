// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/record_problems.h"

#include <QVBoxLayout>

#include "ui/style/words.h"
#include "ui/views/readiness_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {
namespace {

/// The take will end by itself so soon that it should be said.
constexpr double kWarnBefore_s = 40;
constexpr size_t kMostTakeCards = 3;

}  // namespace

RecordProblems::RecordProblems(Studio& studio, QWidget* parent)
    : QWidget(parent), studio_(studio), column_(makeColumn(this, {12, 0, 12, 0}, 8)), more_(new Label) {
    more_->setRole(TextRole::kSecondary);
    more_->setInk(Ink::kHint);
    column_->addWidget(new SectionHeader(tr("To look at")));
    column_->addWidget(more_);
    hide();
}

std::vector<RecordProblems::Problem> RecordProblems::ofTake() const {
    std::vector<Problem> problems;
    const auto recording = studio_.suit().recording();
    const auto hello = studio_.suit().status()->hello;
    if (!recording || !hello)
        return problems;
    if (const auto left_s = studio_.suits().storageLeft_s(); left_s && *left_s < kWarnBefore_s)
        problems.push_back(
            {Tone::kError,
             tr("The disk has %1 left").arg(durationWords(*left_s)),
             tr("Recording stops by itself then, and the take is complete. Free some space, or choose "
                "another folder."),
             -1,
             {},
             {}});
    if (recording->lost_samples > 0) {
        const double lost_s = static_cast<double>(recording->lost_samples) / hello->sample_rate_hz;
        problems.push_back({Tone::kWarn,
                            tr("%1 are missing in this take").arg(secondsText(lost_s, 1)),
                            tr("They are marked as %n gap(s), and time does not shift.", nullptr,
                               static_cast<int>(recording->gaps)),
                            -1,
                            {},
                            {}});
    }
    return problems;
}

std::vector<RecordProblems::Problem> RecordProblems::ofSuit() const {
    const SuitCheck& check = studio_.check();
    std::vector<Problem> problems;
    const bool runs = studio_.suit().phase() == LiveSuit::Phase::kRecording;
    for (const ReadinessProblem& judged : check.readiness().problems) {
        // While a take runs its recorder knows better how long the disk lasts.
        if (judged.accepted || (runs && judged.kind == ProblemKind::kStorageShort))
            continue;
        const HindranceWords words = wordsOf(judged, check);
        Problem problem{judged.hinders ? Tone::kError : Tone::kWarn,
                        words.title,
                        words.text,
                        judged.board,
                        judged,
                        words};
        if (runs && judged.kind == ProblemKind::kLinkLost)
            problem.text +=
                ' ' + tr("The take is safe up to here and goes on when the box is back; the gap will "
                         "be marked.");
        problems.push_back(std::move(problem));
    }
    return problems;
}

void RecordProblems::refresh() {
    std::vector<Problem> problems = ofTake();
    std::ranges::move(ofSuit(), std::back_inserter(problems));
    std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
        return a.tone == Tone::kError && b.tone != Tone::kError;
    });
    count_ = static_cast<int>(problems.size());
    beside_fit_ = static_cast<int>(std::ranges::count_if(problems, [](const Problem& problem) {
        return problem.words.repair != Repair::kCalibrate && problem.words.repair != Repair::kCheck;
    }));
    worst_ = problems.empty() ? Tone::kNeutral : problems.front().tone;
    showCards(problems);
}

/// Cards stay while their titles do; what they say may go on changing.
void RecordProblems::showCards(const std::vector<Problem>& problems) {
    const size_t count = std::min(problems.size(), kMostTakeCards);
    const bool runs = studio_.suit().phase() == LiveSuit::Phase::kRecording;
    bool same = count == cards_.size() && std::exchange(made_while_recording_, runs) == runs;
    for (size_t i = 0; same && i < count; ++i)
        same = cards_[i]->title() == problems[i].title;
    if (!same) {
        for (ProblemCard* card : cards_) {
            card->hide();
            card->deleteLater();
        }
        cards_.clear();
        for (size_t i = 0; i < count; ++i)
            cards_.push_back(makeCard(problems[i]));
    }
    for (size_t i = 0; i < count; ++i)
        cards_[i]->setTexts(problems[i].title, problems[i].text);
    more_->setText(tr("%n more", "things to look at", static_cast<int>(problems.size() - count)));
    more_->setVisible(problems.size() > count);
    setVisible(count > 0);
}

ProblemCard* RecordProblems::makeCard(const Problem& problem) {
    auto* card = new ProblemCard(problem.tone, problem.title, problem.text);
    if (problem.board >= 0)
        connect(card->addAction(tr("Show on body")), &QPushButton::clicked, this,
                [this, board = problem.board] { studio_.selection().setPair(-1, board); });
    if (problem.words.repair == Repair::kCalibrate)
        connect(card->addAction(problem.words.action, problem.words.action_icon), &QPushButton::clicked, this,
                [this] { studio_.goTo(Step::kCalibrate); });
    const bool runs = studio_.suit().phase() == LiveSuit::Phase::kRecording;
    if (problem.words.repair == Repair::kCheck && !runs)
        connect(card->addAction(problem.words.action, problem.words.action_icon), &QPushButton::clicked,
                &studio_, &Studio::checkSuit);
    if (problem.judged && !problem.words.accept.isEmpty())
        connect(
            card->addAction(problem.words.accept), &QPushButton::clicked, this,
            [this, judged = *problem.judged] { studio_.check().goOnWithout(judged); }, Qt::QueuedConnection);
    column_->insertWidget(column_->indexOf(more_), card);
    return card;
}

}  // namespace noctule::ui
