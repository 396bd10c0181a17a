// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record_readiness.h"

#include <QPointer>
#include <QVBoxLayout>

#include "core/acoustics/speed_of_sound.h"
#include "ui/models/part_names.h"
#include "ui/scene/dressed_body.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"
#include "ui/widgets/verdict_header.h"

namespace noctule::ui {
namespace {

constexpr double kSourceHeardFor_s = 0.5, kGoodFor_s = 0.2;
constexpr qint64 kRateEvery_ms = 2000;
constexpr double kLittleTime_s = 40, kLittleStorage_h = 1;
constexpr double kLowBattery = 20, kEmptyBattery = 8;
constexpr int kRefresh_ms = 250, kStorage_ms = 10'000;
constexpr size_t kMostCards = 3;

/// Of a part of a whole: all is well, some want a look, none is an error.
Tone toneOfPart(qint64 part, qint64 whole) {
    return part == whole && whole > 0 ? Tone::kOk : part == 0 ? Tone::kError : Tone::kWarn;
}

double share(qint64 part, qint64 whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

QString partText(qint64 part, qint64 whole) {
    return RecordReadiness::tr("%1 of %2").arg(part).arg(whole);
}

QString durationText(double seconds) {
    if (seconds >= 2 * 3600)
        return RecordReadiness::tr("%1\u00A0h left").arg(numberText(seconds / 3600, 0));
    if (seconds >= 120)
        return RecordReadiness::tr("%1\u00A0min left").arg(numberText(seconds / 60, 0));
    return RecordReadiness::tr("%1\u00A0s left").arg(numberText(seconds, 0));
}

}  // namespace

RecordReadiness::RecordReadiness(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      verdict_(new VerdictHeader),
      to_look_at_(new QWidget),
      more_(new Label({}, TextRole::kSecondary, Ink::kHint)) {
    auto* content = new QWidget;
    auto* column = makeColumn(content, {0, 12, 0, 12}, 12);
    verdict_->setCompact(true);
    addRow(column, 0, {12, 0, 12, 0})->addWidget(verdict_);
    cards_ = makeColumn(to_look_at_, {12, 0, 12, 0}, 8);
    cards_->addWidget(new SectionHeader(tr("To look at")));
    cards_->addWidget(more_);
    column->addWidget(to_look_at_);
    column->addWidget(new Divider);
    column->addWidget(makeFacts());
    column->addWidget(new Divider);
    column->addWidget(makeCalibration());
    column->addStretch();
    makeColumn(this)->addWidget(new ScrollArea(content));
    LiveSuit& suit = studio.suit();
    connect(&suit, &LiveSuit::phaseChanged, this, &RecordReadiness::refresh);
    connect(&suit, &LiveSuit::wearingChanged, this, &RecordReadiness::refresh);
    connect(&studio.session(), &SessionModel::opened, this, &RecordReadiness::lookAtStorage);
    refresh_timer_.setInterval(kRefresh_ms);
    connect(&refresh_timer_, &QTimer::timeout, this, [this] {
        if (isVisible())
            refresh();
    });
    storage_timer_.setInterval(kStorage_ms);
    connect(&storage_timer_, &QTimer::timeout, this, [this] {
        if (isVisible())
            lookAtStorage();
    });
    refresh_timer_.start();
    storage_timer_.start();
    refresh();
}

QWidget* RecordReadiness::makeFacts() {
    auto* rows = new QWidget;
    auto* column = makeColumn(rows, {12, 0, 12, 0}, 12);
    const auto add = [&](Fact fact, const char* icon, const QString& name) {
        facts_[fact] = new FactRow(icon, name);
        column->addWidget(facts_[fact]);
    };
    add(Fact::kBoards, "board", tr("Boards"));
    add(Fact::kSources, "source", tr("Sources"));
    add(Fact::kPairs, "pairs", tr("Good pairs"));
    add(Fact::kLink, "link", tr("Link"));
    add(Fact::kBattery, "battery", tr("Battery"));
    add(Fact::kStorage, "disk", tr("Storage"));
    add(Fact::kAir, "temp", tr("Air"));
    add(Fact::kView, "eye", tr("Live view"));
    return rows;
}

QWidget* RecordReadiness::makeCalibration() {
    auto* part = new QWidget;
    auto* column = makeColumn(part, {12, 0, 12, 0}, 4);
    column->addWidget(new SectionHeader(tr("Calibration in use")));
    auto* rows = new FormRows;
    made_ = rows->addValue(tr("Made"), {});
    offsets_ = rows->addValue(tr("Source offsets"), {});
    boards_ = rows->addValue(tr("Boards"), {});
    column->addWidget(rows);
    return part;
}

const FactRow& RecordReadiness::fact(Fact fact) const {
    return *facts_.at(fact);
}

void RecordReadiness::showEvent(QShowEvent*) {
    lookAtStorage();
    refresh();
}

void RecordReadiness::setScreenDelay(double seconds) {
    screen_delay_s_ = seconds;
}

void RecordReadiness::refresh() {
    showHealth();
    showLink();
    showAir();
    showStorage();
    showCalibration();
    showProblems(problemsNow());
}

void RecordReadiness::showHealth() {
    const auto frame = studio_.suit().frame();
    const QString dash = QChar(0x2013);
    if (!frame) {
        for (const Fact fact : {Fact::kBoards, Fact::kSources, Fact::kPairs, Fact::kView})
            facts_[fact]->setFact({Tone::kNeutral, dash, {}, {}});
        return;
    }
    const HealthReport& health = frame->health;
    const auto boards = std::ssize(health.boards);
    const auto loud = std::count_if(health.boards.begin(), health.boards.end(),
                                    [](const BoardHealth& board) { return !board.silent; });
    facts_[Fact::kBoards]->setFact({toneOfPart(loud, boards), partText(loud, boards), {}, {}});
    const auto sources = boards > 0 ? std::ssize(health.pairs) / boards : 0;
    qint64 heard = 0, good = 0;
    for (int source = 0; source < sources; ++source) {
        bool any = false;
        for (int board = 0; board < boards; ++board) {
            const PairHealth& pair = health.pair(source, board);
            any = any || (pair.age_s && *pair.age_s < kSourceHeardFor_s);
            good += pair.age_s && *pair.age_s < kGoodFor_s && pair.confidence >= kGoodConfidence;
        }
        heard += any;
    }
    facts_[Fact::kSources]->setFact({toneOfPart(heard, sources), partText(heard, sources), {}, {}});
    const auto pairs = std::ssize(health.pairs);
    facts_[Fact::kPairs]->setFact({good > 0 ? Tone::kOk : Tone::kWarn, partText(good, pairs),
                                   tr("About a quarter of them see each other at any moment."),
                                   share(good, pairs)});
    const double behind_s = frame->latency_median_s + screen_delay_s_;
    facts_[Fact::kView]->setFact(
        {Tone::kNeutral,
         frame->poses > 0 ? tr("%1\u00A0ms behind").arg(numberText(behind_s * 1e3, 0)) : dash,
         {},
         {}});
}

void RecordReadiness::showLink() {
    const LiveSuit& suit = studio_.suit();
    const auto status = suit.status();
    const auto frame = suit.frame();
    if (!status->hello) {
        facts_[Fact::kLink]->setFact({Tone::kNeutral, QChar(0x2013), {}, {}});
        return;
    }
    if (!frame || frame->sample < rate_from_sample_ || !since_rate_.isValid()) {
        rate_from_sample_ = frame ? frame->sample : 0;
        since_rate_.start();
        megabytes_per_s_ = 0;
    } else if (since_rate_.elapsed() > kRateEvery_ms) {
        const auto bytes = 2.0 * static_cast<double>(frame->sample - rate_from_sample_) *
                           static_cast<double>(frame->health.boards.size());
        megabytes_per_s_ = bytes / 1e3 / static_cast<double>(since_rate_.restart());
        rate_from_sample_ = frame->sample;
    }
    const link::LinkStatistics link = suit.link();
    const qint64 lost = link.frames.lost_frames,
                 damaged = link.frames.damaged_payloads + link.frames.bad_headers;
    const bool broken = status->link == LinkState::kLost || status->link == LinkState::kStalled;
    facts_[Fact::kLink]->setFact({broken               ? Tone::kError
                                  : lost + damaged > 0 ? Tone::kWarn
                                                       : Tone::kOk,
                                  broken ? tr("broken", "a link")
                                  : megabytes_per_s_ > 0
                                      ? tr("%1\u00A0MB/s").arg(numberText(megabytes_per_s_, 1))
                                      : tr("stands", "a link"),
                                  tr("%1 frames lost, %2 damaged").arg(lost).arg(damaged),
                                  {}});
}

void RecordReadiness::showAir() {
    const auto frame = studio_.suit().frame();
    const SuitStatus told = frame ? frame->health.suit : SuitStatus{};
    if (told.battery_percent)
        facts_[Fact::kBattery]->setFact({*told.battery_percent < kEmptyBattery ? Tone::kError
                                         : *told.battery_percent < kLowBattery ? Tone::kWarn
                                                                               : Tone::kOk,
                                         percentText(*told.battery_percent / 100),
                                         {},
                                         *told.battery_percent / 100});
    else
        facts_[Fact::kBattery]->setFact({Tone::kNeutral, tr("not measured"), {}, {}});
    if (!told.temperature_c)
        return facts_[Fact::kAir]->setFact({Tone::kNeutral, tr("not measured"), {}, {}});
    const double humidity = told.humidity_percent.value_or(SpeedOfSound::kAssumedHumidity_percent);
    const QString air = QStringLiteral("%1\u00A0°C").arg(numberText(*told.temperature_c, 1));
    facts_[Fact::kAir]->setFact(
        {Tone::kNeutral,
         told.humidity_percent ? QStringLiteral("%1, %2").arg(air, percentText(humidity / 100)) : air,
         tr("speed of sound %1\u00A0m/s")
             .arg(numberText(speedOfSoundCramer(*told.temperature_c, humidity), 1)),
         {}});
}

void RecordReadiness::lookAtStorage() {
    const SessionModel& session = studio_.session();
    const QString folder = session.isOpen() ? QString::fromStdString(session.session().folder.string())
                                            : studio_.sessionsFolder();
    studio_.jobs().start<Storage>(
        tr("Room on %1").arg(folder),
        [folder](const JobContext&) -> Result<Storage> { return storageAt(folder); },
        [self = QPointer(this)](Result<Storage> storage) -> QString {
            if (self && storage)
                self->storage_ = *storage;
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void RecordReadiness::showStorage() {
    const auto recording = studio_.suit().recording();
    if (recording && recording->remaining_s) {
        const double left_s = *recording->remaining_s;
        facts_[Fact::kStorage]->setFact({left_s < kLittleTime_s             ? Tone::kError
                                         : left_s < kLittleStorage_h * 3600 ? Tone::kWarn
                                                                            : Tone::kOk,
                                         durationText(left_s),
                                         tr("%1 in this take").arg(bytesText(recording->sound_bytes)),
                                         {}});
    } else if (storage_.free_bytes >= 0) {
        const double hours = storage_.recordingHours();
        facts_[Fact::kStorage]->setFact({hours < 0.1                ? Tone::kError
                                         : hours < kLittleStorage_h ? Tone::kWarn
                                                                    : Tone::kOk,
                                         durationText(hours * 3600),
                                         tr("%1 free").arg(bytesText(storage_.free_bytes)),
                                         {}});
    } else {
        facts_[Fact::kStorage]->setFact({Tone::kNeutral, QChar(0x2013), {}, {}});
    }
}

void RecordReadiness::showCalibration() {
    const LiveSuit& suit = studio_.suit();
    const auto& calibration = suit.calibration();
    if (!calibration) {
        made_->setText(suit.status()->hello ? tr("none") : QString(QChar(0x2013)));
        offsets_->setText(QChar(0x2013));
        boards_->setText(QChar(0x2013));
        return;
    }
    const QDateTime when =
        QDateTime::fromString(QString::fromStdString(calibration->created_utc), Qt::ISODate);
    made_->setText(when.isValid() ? dateText(when) : tr("date unknown"));
    const auto known =
        std::count_if(calibration->sources.begin(), calibration->sources.end(),
                      [](const SourceCalibration& source) { return !source.offsets_s.empty(); });
    offsets_->setText(partText(known, std::ssize(suit.suit().sources)));
    boards_->setText(partText(std::ssize(calibration->boards), std::ssize(suit.suit().boards)));
}

std::vector<RecordReadiness::Problem> RecordReadiness::problemsNow() const {
    std::vector<Problem> problems;
    const LiveSuit& suit = studio_.suit();
    const auto status = suit.status();
    if (!status->hello)
        return problems;
    if (const auto recording = suit.recording()) {
        if (recording->remaining_s && *recording->remaining_s < kLittleTime_s)
            problems.push_back(
                {Tone::kError, tr("The disk is almost full"),
                 tr("It has room for %1\u00A0s more. Recording stops by itself then, and the take is "
                    "complete; free space or choose another folder.")
                     .arg(numberText(std::max(0.0, *recording->remaining_s), 0))});
        if (recording->lost_samples > 0)
            problems.push_back(
                {Tone::kWarn, tr("This take has gaps"),
                 tr("%n gap(s), together %1. They are marked, and time does not shift.", nullptr,
                    static_cast<int>(recording->gaps))
                     .arg(secondsText(
                         static_cast<double>(recording->lost_samples) / status->hello->sample_rate_hz, 2))});
    }
    if (status->link == LinkState::kLost)
        problems.push_back(
            {Tone::kError, tr("The link to %1 is broken").arg(QString::fromStdString(status->hello->serial)),
             suit.phase() == LiveSuit::Phase::kRecording
                 ? tr("The take is safe up to here and goes on when the box is back; the gap will be marked.")
                 : tr("The studio tries again by itself.")});
    return problems;
}

QStringList RecordReadiness::problems() const {
    QStringList titles;
    for (const ProblemCard* card : shown_)
        titles.append(card->title());
    return titles;
}

void RecordReadiness::showProblems(const std::vector<Problem>& problems) {
    const LiveSuit& suit = studio_.suit();
    const bool records = suit.phase() == LiveSuit::Phase::kRecording;
    const auto worst = std::max_element(problems.begin(), problems.end(),
                                        [](const Problem& a, const Problem& b) { return a.tone < b.tone; });
    if (!suit.status()->hello)
        verdict_->setVerdict(Tone::kNeutral, tr("No suit"),
                             tr("Connect one, and this says whether it is ready."));
    else if (problems.empty())
        verdict_->setVerdict(Tone::kOk, records ? tr("Recording well") : tr("Ready to record"), {});
    else
        verdict_->setVerdict(worst->tone, records ? tr("Recording, but look") : tr("Look before you record"),
                             {});
    showCards(problems);
}

/// Cards stay as they are while their words do; a countdown in one changes its words only.
void RecordReadiness::showCards(const std::vector<Problem>& problems) {
    const size_t count = std::min(problems.size(), kMostCards);
    bool same = count == shown_.size();
    for (size_t i = 0; same && i < count; ++i)
        same = shown_[i]->title() == problems[i].title;
    if (!same) {
        qDeleteAll(shown_);
        shown_.clear();
        for (size_t i = 0; i < count; ++i)
            shown_.push_back(makeCard(problems[i]));
    }
    for (size_t i = 0; i < count; ++i)
        shown_[i]->setTexts(problems[i].title, problems[i].text);
    more_->setText(tr("%n more", nullptr, static_cast<int>(problems.size() - count)));
    more_->setVisible(problems.size() > count);
    to_look_at_->setVisible(count > 0);
}

ProblemCard* RecordReadiness::makeCard(const Problem& problem) {
    auto* card = new ProblemCard(problem.tone, problem.title, problem.text);
    if (problem.board >= 0)
        connect(card->addAction(tr("Show on body")), &QPushButton::clicked, this,
                [this, board = problem.board] { studio_.selection().setPair(-1, board); });
    cards_->insertWidget(cards_->indexOf(more_), card);
    return card;
}

}  // namespace noctule::ui
