// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/record_readiness.h"

#include <QVBoxLayout>
#include <set>

#include "core/acoustics/speed_of_sound.h"
#include "ui/scene/live_scene.h"
#include "ui/style/lengths.h"
#include "ui/style/words.h"
#include "ui/views/fit_words.h"
#include "ui/views/number_rows.h"
#include "ui/views/readiness_words.h"
#include "ui/views/record/record_problems.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/suit_cards.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"
#include "ui/widgets/verdict_header.h"

namespace noctule::ui {
namespace {

constexpr double kLowBattery_percent = 20;

Tone toneOfPart(qint64 part, qint64 whole) {
    return part == whole && whole > 0 ? Tone::kOk : part == 0 ? Tone::kError : Tone::kWarn;
}

QString partText(qint64 part, qint64 whole) {
    return RecordReadiness::tr("%1 of %2").arg(part).arg(whole);
}

double shareOf(qint64 part, qint64 whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}  // namespace

RecordReadiness::RecordReadiness(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      suits_(new SuitCards(studio)),
      verdict_(new VerdictHeader),
      problems_(new RecordProblems(studio)),
      of_suit_(new QWidget),
      numbers_(new NumberRows) {
    auto* content = new QWidget;
    auto* column = makeColumn(content, {0, 12, 0, 12}, 12);
    addRow(column, 0, {12, 0, 12, 0})->addWidget(suits_);
    in_row_ = (new Label(tr("Live, performers stand in a row, %1 apart. Where they really are to each other "
                            "comes with processing, after the take.")
                             .arg(lengthText(LiveScene::kApart_m)),
                         TextRole::kSecondary, Ink::kHint))
                  ->wrapped();
    addRow(column, 0, {12, 0, 12, 0})->addWidget(in_row_);
    connect(&studio.suits(), &LiveSuits::changed, this, &RecordReadiness::showRow);
    verdict_->setCompact(true);
    addRow(column, 0, {12, 0, 12, 0})->addWidget(verdict_);
    column->addWidget(problems_);
    auto* of_suit = makeColumn(of_suit_, {}, 12);
    of_suit->addWidget(new Divider);
    addFacts();
    addRow(of_suit, 0, {12, 0, 12, 0})->addWidget(numbers_);
    of_suit->addWidget(new Divider);
    of_suit->addWidget(makeCalibration());
    column->addWidget(of_suit_);
    column->addStretch();
    makeColumn(this)->addWidget(new ScrollArea(content));
    studio.suits().follow(&SuitCheck::changed, this, &RecordReadiness::refresh);
    studio.suits().forEach(this, [this](SuitInUse& worn) {
        connect(&worn.check, &SuitCheck::changed, this, &RecordReadiness::showVerdict);
    });
    studio.suits().follow(&LiveSuit::phaseChanged, this, &RecordReadiness::refresh);
    studio.suits().follow(&LiveSuit::wearingChanged, this, &RecordReadiness::refresh);
    connect(&studio.suits(), &LiveSuits::checkedChanged, this, &RecordReadiness::refresh);
    refresh();
    showRow();
}

/// In the order of Fact.
void RecordReadiness::addFacts() {
    numbers_->addRow("board", tr("Boards"));
    numbers_->addRow("source", tr("Sources"));
    numbers_->addRow("pairs", tr("Good pairs"));
    numbers_->addRow("link", tr("Link"));
    numbers_->addRow("battery", tr("Battery"));
    numbers_->addRow("disk", tr("Storage"));
    numbers_->addRow("temp", tr("Air"));
    numbers_->addRow("eye", tr("Live view"));
}

void RecordReadiness::setFact(Fact fact, const QString& value, const QString& hint, Tone tone, double share) {
    numbers_->setValue(static_cast<int>(fact), value, tone, share);
    numbers_->setHint(static_cast<int>(fact), hint);
}

QString RecordReadiness::value(Fact fact) const {
    return numbers_->value(static_cast<int>(fact));
}

QWidget* RecordReadiness::makeCalibration() {
    auto* part = new QWidget;
    auto* column = makeColumn(part, {12, 0, 12, 0}, 4);
    column->addWidget(new SectionHeader(tr("Calibration in use")));
    auto* rows = new FormRows;
    made_ = rows->addValue(tr("Made"), {});
    offsets_ = rows->addValue(tr("Source offsets"), {});
    boards_ = rows->addValue(tr("Boards"), {});
    checked_ = rows->addValue(tr("Checked"), {});
    column->addWidget(rows);
    check_ = makeButton(ButtonKind::kOutlined, tr("Check the suit"), "rest_pose");
    check_->setToolTip(tr("Stand still for three seconds: says whether a strap has moved"));
    connect(check_, &QPushButton::clicked, &studio_, &Studio::checkSuit);
    auto* row = addRow(column, 8, {0, 8, 0, 0});
    row->addWidget(check_);
    row->addStretch();
    return part;
}

/// What the picture cannot know.
void RecordReadiness::showRow() {
    in_row_->setVisible(studio_.suits().areSeveral());
}

void RecordReadiness::setScreenDelay(double seconds) {
    screen_delay_s_ = seconds;
}

void RecordReadiness::showEvent(QShowEvent*) {
    refresh();
}

void RecordReadiness::refresh() {
    showHealth();
    showLink();
    showSupplies();
    showAir();
    showCalibration();
    problems_->refresh();
    showVerdict();
}

void RecordReadiness::showHealth() {
    const Readiness& readiness = studio_.check().readiness();
    const bool is_silent = studio_.suit().isSilent();
    if (is_silent || readiness.verdict == Readiness::Verdict::kWaiting) {
        for (const Fact fact : {Fact::kBoards, Fact::kSources, Fact::kPairs})
            setFact(fact, {});
        return setFact(Fact::kView, is_silent ? kNoValue : QString());
    }
    const auto boards = std::ssize(readiness.boards), sources = std::ssize(readiness.source_good_pairs);
    const int there = readiness.boards_there, heard = readiness.sources_heard, good = readiness.good_pairs;
    setFact(Fact::kBoards, partText(there, boards), {}, toneOfPart(there, boards));
    setFact(Fact::kSources, partText(heard, sources), {}, toneOfPart(heard, sources));
    setFact(Fact::kPairs, partText(good, boards * sources),
            tr("the body hides the others; a quarter is usual"), good > 0 ? Tone::kOk : Tone::kWarn,
            shareOf(good, boards * sources));
    const auto frame = studio_.suit().frame();
    const bool moves = frame && frame->poses > 0 && studio_.suit().canMoveBody();
    const double behind_s = frame ? frame->latency_median_s + screen_delay_s_ : 0;
    setFact(Fact::kView, moves ? tr("%1\u00A0ms behind").arg(numberText(behind_s * 1e3, 0)) : QString());
}

void RecordReadiness::showLink() {
    const LiveSuit& suit = studio_.suit();
    const auto status = suit.status();
    if (!status->hello)
        return setFact(Fact::kLink, {});
    const auto bytes_per_s = studio_.check().bytesPerSecond();
    const link::LinkStatistics link = suit.link();
    const qint64 lost = link.frames.lost_frames;
    const qint64 damaged = link.frames.damaged_payloads + link.frames.bad_headers;
    const bool broken = suit.isSilent();
    setFact(Fact::kLink,
            broken        ? tr("broken", "a link")
            : bytes_per_s ? tr("%1\u00A0MB/s").arg(numberText(*bytes_per_s * 1e-6, 1))
                          : tr("is there", "a link"),
            tr("%1 blocks lost, %2 damaged").arg(lost).arg(damaged),
            broken               ? Tone::kError
            : lost + damaged > 0 ? Tone::kWarn
                                 : Tone::kOk);
}

void RecordReadiness::showSupplies() {
    const auto frame = studio_.suit().frame();
    const auto percent = frame ? frame->health.suit.battery_percent : std::nullopt;
    const auto left_s = studio_.check().batteryLeft_s();
    if (percent)
        setFact(Fact::kBattery, percentText(*percent / 100),
                studio_.suit().isSilent() ? lastKnownInShort()
                : left_s                  ? tr("%1 at this rate").arg(durationWords(*left_s))
                                          : QString(),
                *percent < kLowBattery_percent ? Tone::kWarn : Tone::kNeutral, *percent / 100);
    else
        setFact(Fact::kBattery, {});
    const auto recording = studio_.suit().recording();
    const auto storage_s = studio_.suits().storageLeft_s();
    if (!storage_s)
        return setFact(Fact::kStorage, {});
    setFact(Fact::kStorage, tr("%1 left").arg(durationWords(std::max(0.0, *storage_s))),
            recording ? tr("%1 in this take").arg(bytesText(recording->sound_bytes)) : QString(),
            toneOfStorage(*storage_s));
}

void RecordReadiness::showAir() {
    const auto frame = studio_.suit().frame();
    const SuitStatus told = frame ? frame->health.suit : SuitStatus{};
    if (!told.temperature_c)
        return setFact(Fact::kAir, {});
    const double humidity = told.humidity_percent.value_or(SpeedOfSound::kAssumedHumidity_percent);
    const double c_m_per_s = speedOfSoundCramer(*told.temperature_c, humidity);
    const QString air = QStringLiteral("%1\u00A0\u00B0C").arg(numberText(*told.temperature_c, 1));
    setFact(Fact::kAir,
            told.humidity_percent ? QStringLiteral("%1, %2").arg(air, percentText(humidity / 100)) : air,
            studio_.suit().isSilent() ? lastKnownInShort()
                                      : tr("speed of sound %1\u00A0m/s").arg(numberText(c_m_per_s, 1)));
}

QString RecordReadiness::checkedWords() const {
    const auto& checked = studio_.checked();
    if (!checked)
        return tr("not yet", "a suit was checked");
    const QString when = dateInside(checked->when);
    return checked->is_good ? tr("good, %1", "a check, its time").arg(when)
                            : tr("something moved, %1", "a check, its time").arg(when);
}

void RecordReadiness::showCalibration() {
    const LiveSuit& suit = studio_.suit();
    checked_->setText(suit.calibration() ? checkedWords() : kNoValue);
    const QString cannot = whyNotCheck(lackOf(suit.suit(), suit.calibration().value_or(Calibration{})));
    check_->setDisabledBecause(!suit.calibration() ? tr("There is no calibration to check.")
                               : !cannot.isEmpty() ? cannot
                               : suit.phase() == LiveSuit::Phase::kRecording
                                   ? tr("A take is being recorded; check before the next one.")
                                   : QString());
    const auto& calibration = suit.calibration();
    if (!calibration) {
        made_->setText(suit.status()->hello ? tr("none") : kNoValue);
        offsets_->setText(kNoValue);
        boards_->setText(kNoValue);
        return;
    }
    const QDateTime when =
        QDateTime::fromString(QString::fromStdString(calibration->created_utc), Qt::ISODate);
    made_->setText(when.isValid() ? dateText(when) : tr("at an unknown time"));
    const auto& sources = calibration->sources;
    const auto known = std::count_if(sources.begin(), sources.end(), [](const SourceCalibration& source) {
        return !source.offsets_s.empty();
    });
    offsets_->setText(partText(known, std::ssize(suit.suit().sources)));
    const CalibrationLack lack = lackOf(suit.suit(), *calibration);
    std::set<int> lacking(lack.gyroscopes.begin(), lack.gyroscopes.end());
    lacking.insert(lack.accelerometers.begin(), lack.accelerometers.end());
    boards_->setText(partText(lack.board_count - std::ssize(lacking), lack.board_count));
}

void RecordReadiness::showVerdict() {
    VerdictWords words = verdictOf(studio_.suits());
    const bool connected = studio_.suit().phase() != LiveSuit::Phase::kNone;
    if (!connected)
        words.text = tr("Connect one to see whether it is ready.");
    of_suit_->setVisible(connected);
    if (studio_.suit().phase() == LiveSuit::Phase::kRecording) {
        const SuitInUse& worst = worstOf(studio_.suits());
        words = recordingVerdictOf(worst.check.readiness());
        if (&worst != &studio_.suits().current()) {
            words.text = studio_.suits().nameOf(worst);
        } else {  // and what befalls the take
            words.tone = problems_->count() == 0 ? Tone::kOk : problems_->worst();
            if (worst.check.readiness().isFit() && problems_->countBesideFit() > 0)
                words.verdict = tr("Recording, with problems");
        }
    }
    verdict_text_ = words.verdict;
    verdict_->setVerdict(words.tone, words.verdict, words.text);
}

}  // namespace noctule::ui
