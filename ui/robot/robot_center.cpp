// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/robot_center.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QGridLayout>
#include <QStackedWidget>

#include "core/job/atomic_file.h"
#include "ui/language/core_words.h"
#include "ui/models/file_choice.h"
#include "ui/robot/hand_paths.h"
#include "ui/robot/key_card.h"
#include "ui/robot/robot_view.h"
#include "ui/robot/robot_words.h"
#include "ui/robot/state_strip.h"
#include "ui/scene/scene_view.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {
namespace {

/// The delay is searched anew; ten times a second would be more than anybody reads.
constexpr int kPaths_ms = 200;

}  // namespace

RobotCenter::RobotCenter(Studio& studio, RobotDrive& drive, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      drive_(drive),
      strip_(new StateStrip),
      leaders_(new QStackedWidget),
      live_(new SceneView(studio, nullptr, Step::kRobot)),
      take_(new SceneView(studio, nullptr, Step::kRobot)),
      robot_(new RobotView(drive)),
      paths_(new HandPathsView) {
    auto* column = makeColumn(this);
    addRow(column, 0, {16, 10, 16, 10})->addWidget(strip_);
    column->addWidget(new Divider);
    column->addWidget(makeViews(), 1);
    column->addWidget(new Divider);
    column->addWidget(makeKeys());
    column->addWidget(new Divider);
    column->addWidget(makePaths());
    column->addWidget(new Divider);
    column->addWidget(makeFoot());
    connect(&drive, &RobotDrive::wordChanged, this, &RobotCenter::showState);
    connect(&drive, &RobotDrive::robotChanged, this, &RobotCenter::showState);
    connect(&drive, &RobotDrive::keysChanged, this, &RobotCenter::showKeys);
    connect(&drive, &RobotDrive::leaderChanged, this, &RobotCenter::showLeader);
    connect(&drive, &RobotDrive::linkChanged, this, [this] {
        showState();
        showKeys();
        showLeader();
    });
    connect(&drive, &RobotDrive::ticked, this, &RobotCenter::showPaths);
    connect(&drive, &RobotDrive::recordingChanged, this, &RobotCenter::showRecording);
    studio.suits().follow(&LiveSuit::phaseChanged, this, &RobotCenter::showRecording);
    studio.suits().follow(&LiveSuit::wearingChanged, this, &RobotCenter::wear);
    studio.suits().follow(&LiveSuit::frameChanged, this, &RobotCenter::showFrame);
    connect(&Theme::get(), &Theme::changed, this, &RobotCenter::arrangeKeys);
    wear();
    showState();
    showKeys();
    showLeader();
    showRecording();
    showPaths();
}

QWidget* RobotCenter::makeViews() {
    auto* views = new QWidget;
    auto* row = makeRow(views);
    leaders_->addWidget(live_);
    leaders_->addWidget(take_);
    row->addWidget(leaders_, 1);
    row->addWidget(new Divider(Qt::Vertical));
    row->addWidget(robot_, 1);
    keepMinimumHeight(*views, 240);
    return views;
}

QWidget* RobotCenter::makeKeys() {
    auto* part = new QWidget;
    keys_ = makeGrid(part, {16, 12, 16, 12}, 12);
    dead_man_ = new KeyCard("hold", tr("Hold the key"), {}, QKeySequence("F8"));
    clutch_ = new KeyCard("link", tr("Clutch out"), {}, QKeySequence("C"));
    clutch_->setCheckable(true);
    hold_ = new KeyCard("pause", tr("Hold now"), {}, QKeySequence("H"));
    stop_ = new KeyCard("stop", tr("Stop"), {}, QKeySequence("Esc"));
    stop_->setLook(Tone::kError, tr("Stop"), {});
    connect(dead_man_, &QAbstractButton::pressed, this, [this] { drive_.setDeadMan(true); });
    connect(dead_man_, &QAbstractButton::released, this, [this] { drive_.setDeadMan(false); });
    connect(clutch_, &QAbstractButton::clicked, this, [this](bool in) { drive_.setClutch(in); });
    connect(hold_, &QAbstractButton::clicked, &drive_, &RobotDrive::hold);
    connect(stop_, &QAbstractButton::pressed, &drive_, &RobotDrive::stop);
    arrangeKeys();
    return part;
}

/// In a row where there is room, else two by two.
void RobotCenter::arrangeKeys() {
    const Theme& theme = Theme::get();
    int needed = theme.px(2 * 16 + 3 * 12);
    for (const KeyCard* card : {dead_man_, clutch_, hold_, stop_})
        needed += card->sizeHint().width();
    const int columns = width() >= needed ? 4 : 2;
    if (columns == key_columns_)
        return;
    key_columns_ = columns;
    KeyCard* const cards[] = {dead_man_, clutch_, hold_, stop_};
    for (int i = 0; i < 4; ++i)
        keys_->addWidget(cards[i], i / columns, i % columns);
}

QWidget* RobotCenter::makePaths() {
    auto* part = new QWidget;
    auto* column = makeColumn(part, {16, 10, 16, 10}, 8);
    column->addWidget(new SectionHeader(tr("Hand of the robot"),
                                        tr("dashed: commanded, line: achieved; a division is 100 mm")));
    auto* row = addRow(column, 12);
    row->addWidget(paths_, 1);
    auto* rows = new FormRows;
    const QString names[] = {tr("Suit to command"), tr("Command to arm"), tr("Whole chain"),
                             tr("Rest after delay")};
    const QString meanings[] = {
        tr("From a reading of the suit to the command: half of all commands take less than the first time, "
           "999 of 1000 less than the second."),
        tr("From a command until the robot’s hand is there."), tr("Both together."),
        tr("How far the hand is from its command when the delay is left aside: on average, and at most.")};
    for (int i = 0; i < 4; ++i) {
        figures_[i] = rows->addValue(names[i], kNoValue);
        figures_[i]->setToolTip(meanings[i]);
    }
    row->addWidget(rows);
    return part;
}

QWidget* RobotCenter::makeFoot() {
    auto* part = new QWidget;
    auto* rows = makeGrid(part, {16, 10, 16, 10}, 6);
    record_ = makeButton(ButtonKind::kOutlined, tr("Record"), "record");
    play_ = makeButton(ButtonKind::kOutlined, tr("Play the take"), "play");
    repeats_ = makeButton(ButtonKind::kOutlined, tr("Join begin and end"), "loop");
    repeats_->setCheckable(true);
    export_ = makeButton(ButtonKind::kOutlined, tr("Export commands"), "export");
    recorded_ = makeButton(ButtonKind::kOutlined, tr("Show what was recorded"), "chart");
    recorded_->setCheckable(true);
    // In two rows: five in one would keep the page, and with it Stop, from being as narrow as its window.
    constexpr int kColumns = 3;
    Button* const buttons[] = {record_, play_, repeats_, export_, recorded_};
    for (int i = 0; i < 5; ++i)
        rows->addWidget(buttons[i], i / kColumns, i % kColumns);
    rows->setColumnStretch(kColumns, 1);
    connect(record_, &QPushButton::clicked, this, &RobotCenter::toggleRecording);
    connect(recorded_, &QPushButton::clicked, this, [this] {
        since_paths_.invalidate();
        showPaths();
    });
    connect(play_, &QPushButton::clicked, this, &RobotCenter::play);
    connect(repeats_, &QPushButton::clicked, &drive_, &RobotDrive::setRepeats);
    connect(export_, &QPushButton::clicked, this, &RobotCenter::exportCommands);
    return part;
}

void RobotCenter::play() {
    drive_.setPlaying(!drive_.isPlaying());
}

void RobotCenter::exportCommands() {
    const QString path =
        FileChoice{"commands", tr("Export commands"), tr("Tables (*.csv)"), "commands.csv"}.toSave(this);
    if (path.isEmpty())
        return;
    const QByteArray table = drive_.table();
    const Status written = writeFileAtomically(
        path.toStdString(), std::string_view(table.constData(), static_cast<size_t>(table.size())), true);
    if (written)
        studio_.sayOfFile(tr("%1 is written.").arg(QFileInfo(path).fileName()));
    else
        emit studio_.failed(coreWords(written.error().message), coreWords(written.error().remedy),
                            About::kFile);
}

QString RobotCenter::figure(int row) const {
    return figures_[row]->text();
}

void RobotCenter::showState() {
    const robot::DriveOutput* output = drive_.moments().empty() ? nullptr : &drive_.moments().back().output;
    strip_->show(drive_.word(), drive_.holdingReason(), drive_.choice().accept_within_rad,
                 output && problemOf(*output).is_error);
}

void RobotCenter::showKeys() {
    const bool is_on = drive_.link() != RobotDrive::Link::kOff;
    for (KeyCard* card : {dead_man_, clutch_, hold_, stop_})
        card->setEnabled(is_on);
    if (drive_.deadMan())
        dead_man_->setLook(Tone::kOk, tr("Key is held"), tr("Let go, and the robot holds"));
    else
        dead_man_->setLook(Tone::kNeutral, tr("Hold the key"), tr("It moves only while held"));
    clutch_->setChecked(drive_.clutch());
    if (drive_.clutch())
        clutch_->setLook(Tone::kOk, tr("Clutch in"), tr("Out: the robot stays"));
    else
        clutch_->setLook(Tone::kNeutral, tr("Clutch out"), tr("In: postures are compared"));
    arrangeKeys();
}

void RobotCenter::showLeader() {
    const bool of_take = drive_.leader() == RobotDrive::Leader::kTake;
    leaders_->setCurrentWidget(of_take ? take_ : live_);
    play_->setText(drive_.isPlaying() ? tr("Pause the take") : tr("Play the take"));
    play_->setIconName(drive_.isPlaying() ? "pause" : "play");
    play_->setDisabledBecause(!of_take ? tr("The suit leads. Let the take lead.")
                              : drive_.link() == RobotDrive::Link::kOff ? tr("Connect the robot first.")
                                                                        : drive_.whyNoLeader());
    repeats_->setChecked(drive_.repeats());
    export_->setDisabledBecause(drive_.table().isEmpty() ? tr("No commands have been sent yet.") : QString());
}

void RobotCenter::showPaths() {
    if (since_paths_.isValid() && since_paths_.elapsed() < kPaths_ms)
        return;
    since_paths_.start();
    showLeader();
    showRecording();
    const bool recorded = recorded_->isChecked();
    const auto paths = recorded ? drive_.recordedPaths() : drive_.handPaths(0);
    showFigures(paths);
    paths_->show(paths);
}

void RobotCenter::showFigures(const RobotDrive::HandPaths& paths) {
    const LatencyHistogram latency = drive_.linkStatus().latency;
    const bool has_latency = latency.count() > 0;
    figures_[0]->setText(has_latency ? tr("%1, p99.9 %2", "median, quantile")
                                           .arg(millisecondsText(latency.quantile_s(0.5)),
                                                millisecondsText(latency.quantile_s(0.999)))
                                     : kNoValue);
    const auto& tracking = paths.tracking;
    figures_[1]->setText(tracking ? millisecondsText(tracking->delay_s) : kNoValue);
    figures_[2]->setText(
        tracking && has_latency ? millisecondsText(tracking->delay_s + latency.quantile_s(0.5)) : kNoValue);
    figures_[3]->setText(
        tracking ? tr("%1, largest %2")
                       .arg(millimetresText(tracking->rest_rms_m), millimetresText(tracking->rest_max_m))
                 : kNoValue);
}

/// The words of the page Record; "Stop" alone is the robot's.
void RobotCenter::showRecording() {
    const LiveSuit& suit = studio_.suit();
    const bool of_suit = drive_.leader() == RobotDrive::Leader::kSuit;
    const bool runs = of_suit ? suit.phase() == LiveSuit::Phase::kRecording : drive_.isRecording();
    record_->setText(runs ? tr("Stop recording") : tr("Record"));
    record_->setIconName(runs ? "stop" : "record");
    QString lack;
    if (!runs && of_suit && suit.phase() == LiveSuit::Phase::kNone)
        lack = tr("No suit is connected. Connect one, or let a take lead.");
    else if (!runs && !of_suit)
        lack = drive_.whyNotRecord();
    record_->setDisabledBecause(lack);
    const bool has_recorded = !drive_.recordedPaths().commanded.empty();
    recorded_->setDisabledBecause(has_recorded ? QString()
                                               : tr("No commands were recorded in this session."));
    if (!has_recorded)
        recorded_->setChecked(false);
}

void RobotCenter::toggleRecording() {
    if (drive_.leader() == RobotDrive::Leader::kSuit)
        emit suitRecordingWanted();
    else
        drive_.setRecording(!drive_.isRecording());
    showRecording();
}

void RobotCenter::wear() {
    const LiveSuit& suit = studio_.suit();
    const auto hello = suit.status()->hello;
    LiveWearer wearer{suit.actor(), suit.suit(),
                      suit.canMoveBody() ? suit.calibration() : std::optional<Calibration>()};
    if (hello)
        wearer.sample_rate_hz = hello->sample_rate_hz;
    live_->setLive(std::move(wearer));
}

void RobotCenter::showFrame() {
    if (isVisible())
        live_->showFrame(studio_.suit().frame(), false, *studio_.suits().current().floor);
}

void RobotCenter::showEvent(QShowEvent*) {
    showFrame();
}

void RobotCenter::resizeEvent(QResizeEvent*) {
    arrangeKeys();
}

}  // namespace noctule::ui
