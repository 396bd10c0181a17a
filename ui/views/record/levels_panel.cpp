// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/levels_panel.h"

#include "ui/models/part_names.h"
#include "ui/plots/level_meters.h"
#include "ui/plots/pair_columns.h"
#include "ui/plots/pairs_heard.h"
#include "ui/scene/dressed_body.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/elided_label.h"

namespace noctule::ui {
namespace {

/// Within this of full scale a louder pulse would be cut.
constexpr double kClose_db = -1;
constexpr double kPairHeardFor_s = 0.2;

}  // namespace

LevelsPanel::LevelsPanel(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      meters_(new LevelMeters),
      heard_(new PairsHeard),
      good_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      repaint_([this] { show(); }) {
    auto* row = makeRow(this, {}, 0);
    row->addWidget(
        makeHalf(tr("Levels"), tr("sound with peak hold, motion as the thin bar"), meters_, nullptr), 2);
    row->addWidget(new Divider(Qt::Vertical));
    row->addWidget(makeHalf(tr("Pairs heard"), tr("last 10\u00A0s, one row per source"), heard_, good_), 1);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    studio.suits().follow(&LiveSuit::frameChanged, this, &LevelsPanel::take);
    studio.suits().follow(&LiveSuit::phaseChanged, this, &LevelsPanel::startAnew);
    studio.suits().follow(&LiveSuit::statusChanged, this, &LevelsPanel::followLink);
    connect(meters_, &LevelMeters::chosen, this,
            [this](int board) { studio_.selection().setPair(studio_.selection().source(), board); });
    connect(&studio.selection(), &Selection::pairChanged, this,
            [this] { meters_->setCurrent(studio_.selection().board()); });
    startAnew();
}

QWidget* LevelsPanel::makeHalf(const QString& title, const QString& hint, QWidget* content, QWidget* foot) {
    auto* half = new QWidget;
    auto* column = makeColumn(half, {16, 8, 16, 6}, 4);
    auto* head = addRow(column, 12);
    head->addWidget(new Label(title, TextRole::kBody, Ink::kValue, true));
    head->addWidget(new ElidedLabel(hint, TextRole::kCaption, Ink::kHint), 1);
    column->addWidget(content, 1);
    if (foot)
        column->addWidget(foot);
    return half;
}

/// Each stream counts its samples from 0.
void LevelsPanel::startAnew() {
    const LiveSuit& suit = studio_.suit();
    const auto hello = suit.status()->hello;
    const int rate_hz = hello ? hello->sample_rate_hz : 1;
    const auto boards = suit.suit().boards.size(), sources = suit.suit().sources.size();
    last_sample_ = 0;
    sources_.clear();
    for (size_t source = 0; source < sources; ++source)
        sources_.append(sourceTitle(suit.suit(), static_cast<int>(source)));
    needles_.assign(boards, {});
    window_.emplace(static_cast<int>(sources), static_cast<int>(boards), rate_hz);
    meters_->setGroups(columnGroups(suit.suit()));
    meters_->setLevels({});
    heard_->setHeard(*window_, sources_);
    good_->setText({});
}

/// What was heard last says nothing once no sound arrives.
void LevelsPanel::followLink() {
    const SuitInUse& worn = studio_.suits().current();
    const bool takes = worn.suit.phase() == LiveSuit::Phase::kRecording;
    if (!worn.suit.isSilent() || (!takes && !worn.check.nothingSince().isValid()))
        return;
    const QString since =
        takes ? timeText(worn.suit.recordedSeconds(), 0) : clockText(worn.check.nothingSince());
    const QString words =
        tr("%1 of %2 good now").arg(0).arg(static_cast<int>(needles_.size()) * sources_.size()) +
        QStringLiteral(". ") +
        (worn.suit.isLost() ? tr("Lost since %1.", "a time of the take, or of the day")
                            : tr("Nothing has arrived since %1.", "a time of the take, or of the day"))
            .arg(since);
    if (good_->text() == words)
        return;
    startAnew();
    good_->setText(words);
}

QString LevelsPanel::pairsInWords() const {
    return good_->text();
}

void LevelsPanel::take() {
    const auto frame = studio_.suit().frame();
    const auto hello = studio_.suit().status()->hello;
    if (!frame || !hello || studio_.suit().isSilent())
        return;
    const size_t boards = frame->health.boards.size();
    if (boards != needles_.size() || frame->sample < last_sample_)
        startAnew();
    if (boards != needles_.size())
        return;
    last_sample_ = frame->sample;
    const double now_s = static_cast<double>(frame->sample) / hello->sample_rate_hz;
    for (size_t board = 0; board < boards; ++board) {
        const BoardHealth& health = frame->health.boards[board];
        needles_[board].sound.show(level_db(health.signal_counts, kWireFullScale_counts), now_s);
        needles_[board].peak.show(level_db(health.peak_counts, kWireFullScale_counts), now_s);
        const auto motion = frame->readings[board] ? motionLevel_db(*frame->readings[board]) : std::nullopt;
        needles_[board].motion.show(motion.value_or(kSilence_db), now_s);
    }
    window_->add(frame->ranges);
    window_->advanceTo(frame->sample);
    if (isVisible())
        repaint_.ask();
}

void LevelsPanel::show() {
    const auto frame = studio_.suit().frame();
    if (!frame || frame->health.boards.size() != needles_.size() || studio_.suit().isSilent())
        return;
    std::vector<BoardLevel> levels(needles_.size());
    for (size_t board = 0; board < levels.size(); ++board) {
        const Needles& needles = needles_[board];
        const BoardHealth& health = frame->health.boards[board];
        levels[board] = {boardTitle(studio_.suit().suit(), static_cast<int>(board)),
                         needles.sound.level(),
                         needles.peak.peak(),
                         needles.motion.level(),
                         health.clipped_samples > 0 || needles.peak.peak() > kClose_db,
                         health.silent};
    }
    meters_->setLevels(std::move(levels));
    meters_->setCurrent(studio_.selection().board());
    heard_->setHeard(*window_, sources_);
    const auto good =
        std::count_if(frame->health.pairs.begin(), frame->health.pairs.end(), [](const PairHealth& pair) {
            return pair.age_s && *pair.age_s < kPairHeardFor_s && pair.confidence >= kGoodConfidence;
        });
    good_->setText(tr("%1 of %2 good now").arg(good).arg(frame->health.pairs.size()));
}

}  // namespace noctule::ui
