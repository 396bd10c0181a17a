// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/record_center.h"

#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/scene/scene_view.h"
#include "ui/style/theme.h"
#include "ui/views/record/levels_panel.h"
#include "ui/views/record/record_bar.h"
#include "ui/views/record/take_clock.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/session/session_commands.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

/// At 100 percent, as on a screen of 800 lines; from there on the picture grows first.
constexpr int kLevels = 150, kMostLevels = 220;

LiveWearer wearerOf(const LiveSuit& suit) {
    LiveWearer wearer{suit.actor(), suit.suit(),
                      suit.canMoveBody() ? suit.calibration() : std::optional<Calibration>()};
    if (const auto hello = suit.status()->hello)
        wearer.sample_rate_hz = hello->sample_rate_hz;
    return wearer;
}

}  // namespace

RecordCenter::RecordCenter(Studio& studio, RecordRun& run, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      run_(run),
      scene_(new SceneView(studio, nullptr, Step::kRecord)),
      reset_(new ToolButton("here", tr("Reset heading and place"), QKeySequence("Ctrl+H"))),
      clock_(new TakeClock(scene_)),
      bar_(new RecordBar(run)),
      levels_(new LevelsPanel(studio)),
      column_(makeColumn(this)) {
    column_->addWidget(scene_, 5);
    column_->addWidget(new Divider);
    column_->addWidget(bar_);
    column_->addWidget(new Divider);
    column_->addWidget(levels_, 2);
    keepMinimumHeight(*levels_, kLevels);
    keepMaximumHeight(*levels_, kMostLevels);
    studio.suits().follow(&LiveSuit::wearingChanged, this, &RecordCenter::wear);
    studio.suits().follow(&LiveSuit::frameChanged, this, &RecordCenter::showFrame);
    studio.suits().forEach(this, [this](SuitInUse& worn) {
        connect(&worn.suit, &LiveSuit::statusChanged, this, &RecordCenter::followLinks);
    });
    connect(&run, &RecordRun::changed, this, &RecordCenter::showTake);
    connect(&run, &RecordRun::ticked, this, &RecordCenter::showTime);
    connect(&run, &RecordRun::refused, this, &RecordCenter::showRefusal);
    scene_->addTool(reset_);
    PlaceReset& place = studio.placeReset();
    const auto showReset = [this, &place] { reset_->setDisabledBecause(place.whyNot()); };
    connect(reset_, &QAbstractButton::clicked, &place, &PlaceReset::reset);
    connect(&place, &PlaceReset::changed, this, showReset);
    connect(&place, &PlaceReset::moved, this, &RecordCenter::showFrame);
    showReset();
    wear();
    showTake();
}

void RecordCenter::showEvent(QShowEvent*) {
    showFrame();
}

void RecordCenter::wear() {
    scene_->setLive(wearerOf(studio_.suit()));
}

/// No frame tells that no more of them come.
void RecordCenter::followLinks() {
    const auto connected = studio_.suits().connected();
    const auto silent = static_cast<int>(
        std::ranges::count_if(connected, [](const SuitInUse* worn) { return worn->suit.isSilent(); }));
    if (std::exchange(silent_suits_, silent) != silent)
        showFrame();
}

void RecordCenter::showFrame() {
    if (!isVisible())
        return;
    LiveSuits& suits = studio_.suits();
    std::vector<LiveCompanion> others;
    if (suits.areSeveral())
        for (const SuitInUse* worn : suits.connected())
            if (worn != &suits.current())
                others.push_back({wearerOf(worn->suit), worn->suit.frame(), suits.letterOf(*worn),
                                  worn->suit.isSilent(), *worn->floor});
    scene_->setCompany(suits.letterOf(suits.current()), std::move(others));
    scene_->showFrame(studio_.suit().frame(), studio_.suit().isSilent(), *suits.current().floor);
}

void RecordCenter::showTake() {
    const bool runs =
        run_.state() == RecordRun::State::kRecording || run_.state() == RecordRun::State::kSaving;
    QString shot;
    if (run_.shot() >= 0) {
        const auto& shots = studio_.session().session().shots;
        shot = tr("shot %1 of %2, %3")
                   .arg(run_.shot() + 1)
                   .arg(shots.size())
                   .arg(QString::fromStdString(shots[static_cast<size_t>(run_.shot())].name));
    }
    clock_->setTake(run_.takeName(), shot, runs);
    showTime();
    if (refusal_ && run_.state() != RecordRun::State::kRefused)
        closeRefusal();
    else if (refusal_)
        followObstacle();
}

/// While only a number in the text changes, the buttons stay where the pointer is.
void RecordCenter::followObstacle() {
    const RecordObstacle& obstacle = run_.obstacle();
    if (refusal_->title() != obstacle.title || offers_record_anyway_ != obstacle.may_record_anyway)
        return showRefusal();
    if (std::exchange(refused_text_, obstacle.text) != obstacle.text)
        refusal_->setTexts(obstacle.title, obstacle.text);
}

void RecordCenter::showTime() {
    const LiveSuits::OnDisk on_disk = studio_.suits().onDisk();
    clock_->setSeconds(studio_.suits().recordedSeconds());
    clock_->setRecorder(on_disk.recorder, on_disk.sample_rate_hz);
}

void RecordCenter::showRefusal() {
    closeRefusal();
    const RecordObstacle& obstacle = run_.obstacle();
    if (!obstacle)
        return;
    refused_text_ = obstacle.text;
    offers_record_anyway_ = obstacle.may_record_anyway;
    refusal_ = new ProblemCard(Tone::kWarn, obstacle.title, obstacle.text);
    if (obstacle.may_record_anyway)
        connect(refusal_->addAction(tr("Record anyway"), "record"), &QPushButton::clicked, this, [this] {
            closeRefusal();
            run_.recordAnyway();
        });
    if (obstacle.is_of_disk)
        connect(refusal_->addAction(tr("New session in another folder")), &QPushButton::clicked, this,
                [this] { SessionCommands::askForNew(this, studio_); });
    else
        connect(refusal_->addAction(tr("Open Connect")), &QPushButton::clicked, this,
                [this] { studio_.goTo(Step::kConnect); });
    refusal_->setClosable(true);
    connect(refusal_, &ProblemCard::closed, this, &RecordCenter::closeRefusal);
    column_->insertWidget(1, refusal_);
}

void RecordCenter::closeRefusal() {
    if (refusal_)
        refusal_->deleteLater();
    refusal_ = nullptr;
}

}  // namespace noctule::ui
