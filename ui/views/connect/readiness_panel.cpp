// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/readiness_panel.h"

#include <QPointer>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/words.h"
#include "ui/views/newer_values.h"
#include "ui/views/number_rows.h"
#include "ui/views/readiness_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/suit_cards.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/verdict_header.h"

namespace noctule::ui {
namespace {

constexpr size_t kMostCards = 3;

bool isSameProblem(const ReadinessProblem& a, const ReadinessProblem& b) {
    return a.kind == b.kind && a.board == b.board && a.source == b.source && a.accepted == b.accepted &&
           a.alike.size() == b.alike.size() && a.step == b.step;
}

Tone worst(const Readiness& readiness, bool of_boards) {
    Tone tone = Tone::kNeutral;
    for (const ReadinessProblem& problem : readiness.problems)
        if ((of_boards ? problem.board : problem.source) >= 0 && tone != Tone::kError)
            tone = problem.hinders && !problem.accepted ? Tone::kError : Tone::kWarn;
    return tone;
}

}  // namespace

ReadinessPanel::ReadinessPanel(CaptureContext& capture, QWidget* parent)
    : QWidget(parent),
      capture_(capture),
      suits_(new SuitCards(capture)),
      verdict_(new VerdictHeader),
      problems_(new QWidget),
      problem_column_(makeColumn(problems_, {}, 8)),
      newer_(new NewerValues(capture)),
      ways_(makeWaysWithoutSuit()),
      more_(makeButton(ButtonKind::kText, {})),
      numbers_(new NumberRows),
      boards_(numbers_->addRow("board", tr("Boards"))),
      sources_(numbers_->addRow("source", tr("Sources"))),
      pairs_(numbers_->addRow("pairs", tr("Good pairs"))),
      battery_(numbers_->addRow("battery", tr("Battery"))),
      storage_(numbers_->addRow("disk", tr("Storage"))),
      calibration_(numbers_->addRow("ruler", tr("Calibration"))),
      way_on_(makeButton(ButtonKind::kPrimary, tr("Continue"))) {
    auto* content = new QWidget;
    auto* scrolled = makeColumn(content, {12, 16, 12, 12}, 12);
    scrolled->addWidget(suits_);
    scrolled->addWidget(verdict_);
    scrolled->addWidget(ways_);
    scrolled->addWidget(problems_);
    addRow(scrolled)->addWidget(more_, 0, Qt::AlignLeft);
    scrolled->addWidget(newer_);
    auto* guest = new QWidget;
    guest_column_ = makeColumn(guest);
    scrolled->addWidget(guest);
    scrolled->addStretch();
    auto* column = makeColumn(this);
    column->addWidget(new ScrollArea(content), 1);
    column->addWidget(new Divider);
    auto* foot = new QWidget;
    auto* foot_column = makeColumn(foot, {12, 12, 12, 12}, 16);
    foot_column->addWidget(numbers_);
    foot_column->addWidget(way_on_);
    column->addWidget(foot);
    more_->hide();
    capture_.suits().follow(&SuitCheck::changed, this, &ReadinessPanel::show);
    capture_.suits().forEach(this, [this](SuitInUse& worn) {
        connect(&worn.check, &SuitCheck::changed, this, &ReadinessPanel::showVerdict);
    });
    capture_.suits().follow(&LiveSuit::phaseChanged, this, &ReadinessPanel::show);
    capture_.suits().follow(&LiveSuit::blinkingChanged, this, &ReadinessPanel::showBlinking);
    connect(&capture_.finder(), &SuitFinder::changed, this, &ReadinessPanel::showWaysWithoutSuit);
    capture_.suits().follow(&CalibrationShelf::changed, this, &ReadinessPanel::showNumbers);
    connect(more_, &QPushButton::clicked, this, [this] {
        shows_all_ = !shows_all_;
        show();
    });
    connect(way_on_, &QPushButton::clicked, this, [this] { capture_.shared().goTo(way_on_to_); });
    show();
}

/// What can be done while nothing is connected. The filled button connects a box that was found.
QWidget* ReadinessPanel::makeWaysWithoutSuit() {
    auto* ways = new QWidget;
    auto* column = makeColumn(ways, {}, 8);
    const auto add = [&](ButtonKind kind, const QString& text, const QString& icon, auto act) {
        Button* button = makeButton(kind, text, icon);
        connect(button, &QPushButton::clicked, this, act);
        column->addWidget(button);
        return button;
    };
    connect_ = add(ButtonKind::kPrimary, {}, "link", [this] { capture_.suit().connectTo(found_address_); });
    start_virtual_ = add(ButtonKind::kPrimary, tr("Start the virtual suit"), "play",
                         [this] { capture_.startVirtualSuit(); });
    start_virtual_beside_ = add(ButtonKind::kOutlined, tr("Start the virtual suit"), "play",
                                [this] { capture_.startVirtualSuit(); });
    add(ButtonKind::kOutlined, tr("Performer and suit"), "mesh",
        [this] { capture_.shared().goTo(Step::kPerformer); });
    add(ButtonKind::kOutlined, tr("Put the suit on"), "note", [this] { emit putSuitOnRequested(); });
    showWaysWithoutSuit();
    return ways;
}

void ReadinessPanel::showWaysWithoutSuit() {
    const auto found = capture_.finder().connectable();
    found_address_ = found ? QString::fromStdString(found->device.address) : QString();
    connect_->setVisible(found.has_value());
    if (found)
        connect_->setText(tr("Connect %1").arg(found->shownName()));
    const bool is_available = capture_.virtualSuit().isAvailable();
    start_virtual_->setVisible(is_available && !found);
    start_virtual_beside_->setVisible(is_available && found);
}

void ReadinessPanel::setGuest(QWidget* guest) {
    if (guest && guest_column_->indexOf(guest) < 0)
        guest_column_->addWidget(guest);
}

void ReadinessPanel::show() {
    showVerdict();
    showProblems();
    showNumbers();
    showWayOn();
}

/// Of all suits; what stands below it is of the one that is looked at.
void ReadinessPanel::showVerdict() {
    const VerdictWords words = verdictOf(capture_.suits());
    verdict_->setVerdict(words.tone, words.verdict, words.text);
    verdict_text_ = words.verdict;
    verdict_sentences_ = words.text;
}

/// Cards stay where they are while the same problems last: only their words are renewed.
void ReadinessPanel::showProblems() {
    const std::vector<ReadinessProblem>& problems = capture_.check().readiness().problems;
    if (!std::ranges::equal(problems, shown_, isSameProblem)) {
        for (ProblemCard* card : cards_)
            card->deleteLater();
        cards_.clear();
        blink_buttons_.clear();
        for (const ReadinessProblem& problem : problems)
            if (!problem.accepted)
                addCard(problem);
    }
    shown_ = problems;
    size_t index = 0;
    for (const ReadinessProblem& problem : problems) {
        if (problem.accepted)
            continue;
        const HindranceWords words = wordsOf(problem, capture_.check());
        cards_[index]->setTexts(words.title, words.text);
        cards_[index]->setVisible(shows_all_ || index < kMostCards);
        ++index;
    }
    const int hidden = static_cast<int>(cards_.size()) - static_cast<int>(kMostCards);
    more_->setVisible(hidden > 0);
    more_->setText(shows_all_ ? tr("Show the worst only") : tr("%n more", "problems", hidden));
}

void ReadinessPanel::addCard(const ReadinessProblem& problem) {
    const HindranceWords words = wordsOf(problem, capture_.check());
    auto* card = new ProblemCard(problem.hinders ? Tone::kError : Tone::kWarn, words.title, words.text);
    if (!words.action.isEmpty()) {
        Button* button = card->addAction(words.action, words.action_icon);
        if (words.repair == Repair::kBlinkBoard)
            blink_buttons_.push_back({button, problem});
        connect(button, &QPushButton::clicked, this,
                [this, problem, repair = words.repair] { this->repair(repair, problem); });
    }
    if (!words.accept.isEmpty())
        connect(
            card->addAction(words.accept), &QPushButton::clicked, this,
            [this, problem] { capture_.check().goOnWithout(problem); }, Qt::QueuedConnection);
    problem_column_->addWidget(card);
    cards_.push_back(card);
}

void ReadinessPanel::repair(Repair repair, const ReadinessProblem& problem) {
    switch (repair) {
        case Repair::kBlinkBoard:
            capture_.suit().blinkBoard(problem.board);
            emit boardChosen(problem.board);
            break;
        case Repair::kPlaySource:
            capture_.suit().playSource(problem.source);
            break;
        case Repair::kCalibrate:
            capture_.shared().goTo(Step::kCalibrate);
            break;
        case Repair::kCheck:
            capture_.shared().checkSuit();
            break;
        case Repair::kNone:
            break;
    }
}

/// The lamp is lit for some seconds; the button that lit it says so meanwhile.
void ReadinessPanel::showBlinking() {
    for (const auto& [button, problem] : blink_buttons_)
        button->setText(wordsOf(problem, capture_.check()).action);
}

void ReadinessPanel::showNumbers() {
    const SuitCheck& check = capture_.check();
    const Readiness& readiness = check.readiness();
    const bool is_silent = check.suit().isSilent();
    const bool known =
        readiness.verdict != Readiness::Verdict::kWaiting && !readiness.boards.empty() && !is_silent;
    const auto of = [](int some, size_t all) { return tr("%1 of %2").arg(some).arg(all); };
    const auto faint =
        std::ranges::count(readiness.problems, ProblemKind::kSourceFaint, &ReadinessProblem::kind);
    const QString sources = of(readiness.sources_heard, readiness.source_good_pairs.size());
    const size_t pairs = readiness.pair_is_good.size();
    numbers_->setValue(boards_, known ? of(readiness.boards_there, readiness.boards.size()) : QString(),
                       worst(readiness, true));
    numbers_->setValue(sources_,
                       !known       ? QString()
                       : faint == 0 ? sources
                                    : tr("%1, %n faint", nullptr, static_cast<int>(faint)).arg(sources),
                       worst(readiness, false));
    numbers_->setValue(pairs_, known ? of(readiness.good_pairs, pairs) : QString(), Tone::kNeutral,
                       known && pairs > 0 ? readiness.good_pairs / static_cast<double>(pairs) : -1);
    const auto frame = check.suit().frame();
    QString battery;
    if (frame && frame->health.suit.battery_percent)
        battery = percentText(*frame->health.suit.battery_percent / 100);
    if (const auto left_s = check.batteryLeft_s(); left_s && !battery.isEmpty() && !is_silent)
        battery = tr("%1, %2", "charge, time left").arg(battery, durationWords(*left_s));
    numbers_->setValue(battery_, battery);
    numbers_->setHint(battery_, is_silent ? lastKnownInShort() : QString());
    const auto storage_s = capture_.suits().storageLeft_s();
    numbers_->setValue(storage_, storage_s ? durationWords(*storage_s) : QString());
    showCalibration();
}

void ReadinessPanel::showCalibration() {
    const LiveSuit& suit = capture_.suit();
    if (suit.phase() == LiveSuit::Phase::kNone || !suit.status()->hello)
        return numbers_->setValue(calibration_, {});
    const auto& calibration = suit.calibration();
    if (!calibration) {
        numbers_->setHint(calibration_, {});
        return numbers_->setValue(calibration_, tr("none"), Tone::kWarn);
    }
    const QDateTime made =
        QDateTime::fromString(QString::fromStdString(calibration->created_utc), Qt::ISODate);
    numbers_->setValue(calibration_,
                       suit.isKnownExactly() ? tr("known exactly") : dateText(made.toLocalTime()),
                       capture_.check().readiness().lack.isNone() ? Tone::kNeutral : Tone::kWarn);
    numbers_->setHint(calibration_,
                      capture_.calibrations().remembered()
                          ? tr("of this suit, from an earlier session (%1)", "an age").arg(ageText(made))
                          : QString());
}

/// Without a calibration the way on is to make one; recording stays possible on its own page.
void ReadinessPanel::showWayOn() {
    const Readiness& readiness = capture_.check().readiness();
    const LiveSuit::Phase phase = capture_.suit().phase();
    const bool there = phase != LiveSuit::Phase::kNone && phase != LiveSuit::Phase::kRefused;
    way_on_->setVisible(there);
    ways_->setVisible(phase == LiveSuit::Phase::kNone);
    const bool calibrates = readiness.verdict == Readiness::Verdict::kReady && readiness.lack.stopsTheBody();
    way_on_to_ = calibrates ? Step::kCalibrate : Step::kRecord;
    if (calibrates)
        return way_on_->setText(tr("Continue to Calibrate"));
    std::vector<int> without;
    for (const ReadinessProblem& problem : readiness.problems)
        if (problem.kind == ProblemKind::kBoardSilent || problem.kind == ProblemKind::kBoardUnreadable)
            without.insert(without.end(), std::max<size_t>(1, problem.alike.size()), problem.board + 1);
    way_on_->setText(without.size() == 1 ? tr("Continue without board %1").arg(without[0])
                     : without.size() > 1
                         ? tr("Continue without %n boards", nullptr, static_cast<int>(without.size()))
                     : readiness.verdict == Readiness::Verdict::kNotReady ? tr("Continue anyway")
                                                                          : tr("Continue"));
}

}  // namespace noctule::ui
