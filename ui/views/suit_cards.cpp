// SPDX-License-Identifier: Apache-2.0
#include "ui/views/suit_cards.h"

#include <QVBoxLayout>

#include "ui/language/core_words.h"
#include "ui/style/words.h"
#include "ui/views/readiness_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/suit_state_card.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {
namespace {

QString boxWords(const SuitInUse& worn) {
    const auto hello = worn.suit.status()->hello;
    return hello ? SuitCards::tr("%1, %2 kHz", "serial number and carrier of a driver box")
                       .arg(QString::fromStdString(hello->serial), numberText(hello->drive_hz / 1e3, 0))
                 : worn.suit.address();
}

/// The worst that has not been accepted, and how many more there are.
QString problemWords(const SuitInUse& worn) {
    QStringList titles;
    for (const ReadinessProblem& problem : worn.check.readiness().problems)
        if (!problem.accepted)
            titles << wordsOf(problem, worn.check).title;
    if (titles.size() < 2)
        return titles.join(QString());
    return SuitCards::tr("%1, and %n more", "what is wrong first", titles.size() - 1).arg(titles.front());
}

}  // namespace

SuitStateWords suitStateWords(LiveSuits& suits, const SuitInUse& worn) {
    SuitStateWords words;
    words.letter = suits.letterOf(worn);
    words.name = suits.nameOf(worn);
    words.box = boxWords(worn);
    words.is_shown = &worn == &suits.current();
    words.problem = problemWords(worn);
    const auto status = worn.suit.status();
    const bool takes = worn.suit.isLent() && worn.suit.phase() != LiveSuit::Phase::kStarting;
    const QString so_far = timeText(worn.suit.recordedSeconds(), 0);
    if (takes && (status->link == LinkState::kLost || !status->stream_is_open)) {
        words.tone = Tone::kError;
        words.verdict = SuitCards::tr("Lost at %1", "a time of the take").arg(so_far);
        words.problem = status->stream_is_open
                            ? SuitCards::tr(
                                  "Its box is gone. The others are recorded on, and it goes on when "
                                  "the box is back.")
                            : SuitCards::tr("Its box has ended its part. The others are recorded on.");
        if (worn.suit.phase() == LiveSuit::Phase::kSaving && !status->stream_is_open) {
            words.tone = Tone::kNeutral;
            words.verdict = SuitCards::tr("Being saved", "a suit's part of a take");
            words.problem.clear();
        }
    } else if (takes) {
        words.tone = words.problem.isEmpty() ? Tone::kOk : Tone::kWarn;
        words.verdict = SuitCards::tr("Records, %1", "a time of the take").arg(so_far);
    } else {
        const VerdictWords verdict = verdictOf(worn.check);
        words.tone = verdict.tone;
        words.verdict = verdict.verdict;
    }
    return words;
}

SuitCards::SuitCards(CaptureContext& capture, QWidget* parent)
    : QWidget(parent), capture_(capture), column_(makeColumn(this, {}, 8)) {
    connect(&capture.suits(), &LiveSuits::changed, this, &SuitCards::refresh);
    capture.suits().forEach(this, [this](SuitInUse& worn) {
        connect(&worn.check, &SuitCheck::changed, this, &SuitCards::refresh);
    });
    refresh();
}

void SuitCards::showEvent(QShowEvent*) {
    refresh();
}

void SuitCards::refresh() {
    LiveSuits& suits = capture_.suits();
    const auto connected = suits.areSeveral() ? suits.connected() : std::vector<SuitInUse*>();
    words_.clear();
    for (const SuitInUse* worn : connected)
        words_.push_back(suitStateWords(suits, *worn));
    while (cards_.size() > connected.size()) {
        cards_.back()->hide();
        cards_.back()->deleteLater();
        cards_.pop_back();
    }
    while (cards_.size() < connected.size()) {
        const size_t index = cards_.size();
        cards_.push_back(new SuitStateCard);
        column_->insertWidget(static_cast<int>(index), cards_.back());
        connect(cards_.back(), &SuitStateCard::showWanted, this, [this, index] {
            if (const auto all = capture_.suits().connected(); index < all.size())
                capture_.suits().setCurrent(*all[index]);
        });
    }
    for (size_t i = 0; i < words_.size(); ++i)
        cards_[i]->setWords(words_[i]);
    showApart();
    setVisible(!connected.empty());
}

void SuitCards::showApart() {
    const auto why = capture_.suits().areSeveral() ? capture_.suits().whyNotTogether() : std::nullopt;
    const QString title = why ? coreWords(why->message) : QString();
    if (title == (apart_ ? apart_->title() : QString()))
        return;
    if (apart_)
        apart_->deleteLater();
    apart_ = nullptr;
    if (!why)
        return;
    apart_ = new ProblemCard(Tone::kError, title, coreWords(why->remedy) + '.');
    column_->addWidget(apart_);
}

}  // namespace noctule::ui
