// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/connect_page.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/models/part_names.h"
#include "ui/style/keys.h"
#include "ui/style/theme.h"
#include "ui/views/connect/assign_panel.h"
#include "ui/views/connect/board_card.h"
#include "ui/views/connect/devices_panel.h"
#include "ui/views/connect/live_pairs.h"
#include "ui/views/connect/map_legend.h"
#include "ui/views/connect/performer_map.h"
#include "ui/views/connect/readiness_panel.h"
#include "ui/views/connect/suit_switch.h"
#include "ui/views/readiness_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {
namespace {

constexpr int kCardWidth = 240, kRoomForCard = 840;

Tone toneOfSource(const Readiness& readiness, int source) {
    const bool trouble = std::ranges::any_of(
        readiness.problems, [source](const ReadinessProblem& problem) { return problem.source == source; });
    return trouble ? Tone::kWarn : Tone::kNeutral;
}

}  // namespace

ConnectPage::ConnectPage(CaptureContext& capture, QWidget* parent)
    : Page(parent),
      capture_(capture),
      devices_(new DevicesPanel(capture)),
      assigning_(new AssignPanel(capture)),
      readiness_(new ReadinessPanel(capture)),
      left_(makeLeft()),
      drawing_(new QWidget),
      beside_(new QWidget),
      beside_column_(makeColumn(beside_, {}, 16)),
      card_(new BoardCard(capture)),
      legend_(new MapLegend(MapLegend::Shows::kState)),
      pairs_(new LivePairs(capture)) {
    for (QWidget* dock : {left_, static_cast<QWidget*>(readiness_)}) {
        dock->setParent(this);
        dock->hide();
    }
    auto* content = new QWidget;
    auto* column = makeColumn(content);
    makeColumn(this)->addWidget(new ScrollArea(content));
    column->addWidget(new SuitSwitch(capture));
    column->addWidget(makeCentre(), 3);
    column->addWidget(pairs_, 2);
    addActions();
    setDockTitles(tr("Devices"), tr("Readiness"));
    connectStudio();
    showSuit();
}

QWidget* ConnectPage::rightDock() {
    return readiness_;
}

QWidget* ConnectPage::makeLeft() {
    auto* content = new QWidget;
    auto* column = makeColumn(content);
    column->addWidget(devices_);
    column->addWidget(assigning_);
    column->addStretch();
    return new ScrollArea(content);
}

QWidget* ConnectPage::makeCentre() {
    auto* centre = new QWidget;
    upper_ = makeRow(centre, {16, 12, 16, 12}, 16);
    makeColumn(drawing_, {}, 8);
    upper_->addWidget(drawing_, 1);
    keepSize(*beside_, kCardWidth, 0);
    beside_column_->addWidget(card_);
    beside_column_->addStretch();
    upper_->addWidget(beside_);
    return centre;
}

void ConnectPage::addActions() {
    auto* look = new QAction(tr("Look for devices again"), this);
    Keys::get().adopt(*look, "connect/look_again", {Qt::Key_F5});
    connect(look, &QAction::triggered, this, [this] { capture_.finder().lookAgain(); });
    blink_ = new QAction(tr("Blink the chosen board"), this);
    Keys::get().adopt(*blink_, "connect/blink", {Qt::Key_B});
    connect(blink_, &QAction::triggered, this, &ConnectPage::blink);
    take_off_ = new QAction(tr("Go on without the chosen board"), this);
    Keys::get().adopt(*take_off_, "connect/take_off", {Qt::Key_Delete});
    connect(take_off_, &QAction::triggered, this, &ConnectPage::takeOff);
    auto* performer = new QAction(tr("Performer and suit"), this);
    connect(performer, &QAction::triggered, this, [this] { capture_.shared().goTo(Step::kPerformer); });
    auto* put_on = new QAction(tr("Put the suit on"), this);
    connect(put_on, &QAction::triggered, this, &ConnectPage::putSuitOnRequested);
    QWidget::addActions({look, blink_, take_off_, performer, put_on});
    connect(readiness_, &ReadinessPanel::putSuitOnRequested, this, &ConnectPage::putSuitOnRequested);
}

void ConnectPage::connectStudio() {
    connect(&Theme::get(), &Theme::changed, this, &ConnectPage::showLayout);
    connect(&capture_.shared().session(), &SessionModel::changed, this, [this] {
        if (isVisible() && capture_.suit().phase() == LiveSuit::Phase::kNone)
            showSuit();
    });
    capture_.suits().follow(&LiveSuit::wearingChanged, this, &ConnectPage::showSuit);
    capture_.suits().follow(&LiveSuit::phaseChanged, this, &ConnectPage::showLayout);
    capture_.suits().follow(&SuitCheck::changed, this, [this] {
        if (isVisible())
            showState();
    });
    capture_.suits().follow(&LiveSuit::blinkingChanged, this, &ConnectPage::showState);
    connect(pairs_, &LivePairs::boardChosen, this, &ConnectPage::choose);
    connect(card_, &BoardCard::blinkRequested, this,
            [this](int board) { capture_.suit().blinkBoard(board); });
    connect(readiness_, &ReadinessPanel::boardChosen, this, &ConnectPage::choose);
    connect(assigning_, &AssignPanel::boardFound, this, [this](int board) {
        if (board >= 0)
            choose(board);
    });
}

void ConnectPage::enter() {
    showSuit();
    showState();
}

void ConnectPage::showSuit() {
    const LiveSuit& worn = capture_.suit();
    delete map_;
    map_ = worn.suit().boards.empty() ? makePerformerMap(capture_.shared())
                                      : makeSuitMap(capture_.shared(), worn.actor(), worn.suit());
    connect(map_, &BodyMap::boardClicked, this, &ConnectPage::choose);
    connect(map_, &BodyMap::boardDropped, assigning_, &AssignPanel::swap, Qt::QueuedConnection);
    connect(map_, &BodyMap::sourceClicked, this,
            [this](int source) { capture_.shared().say(sourceTitle(map_->suit(), source)); });
    static_cast<QVBoxLayout*>(drawing_->layout())->insertWidget(0, map_, 1);
    choose(board_ < map_->boardCount() ? board_ : -1);
    showLayout();
}

/// Where there is no room for the card beside the body, it stands in the right dock.
void ConnectPage::showLayout() {
    const bool there = !capture_.suit().suit().boards.empty();
    const bool beside = width() >= Theme::get().px(kRoomForCard);
    beside_->setVisible(there && beside);
    if (beside && beside_column_->indexOf(card_) < 0) {
        beside_column_->insertWidget(0, card_);
    } else if (!beside) {
        readiness_->setGuest(card_);
    }
    if (beside && beside_column_->indexOf(legend_) < 0)
        beside_column_->insertWidget(1, legend_);
    else if (!beside && drawing_->layout()->indexOf(legend_) < 0)
        drawing_->layout()->addWidget(legend_);
    legend_->setVisible(there);
    card_->setVisible(there);
    pairs_->setVisible(there);
    map_->setBoardsMovable(there && !map_->showsRoom());
    assigning_->setVisible(!map_->showsRoom());  // nobody wears anchors
    blink_->setEnabled(there);
    take_off_->setEnabled(there);
}

void ConnectPage::showState() {
    const Readiness& readiness = capture_.check().readiness();
    if (static_cast<int>(readiness.boards.size()) != map_->boardCount())
        return;
    for (int board = 0; board < map_->boardCount(); ++board)
        map_->setBoardState(board, toneOf(readiness.boards[static_cast<size_t>(board)].state),
                            boardDetail(capture_.check(), board));
    for (int source = 0; source < map_->sourceCount(); ++source) {
        const int good = readiness.source_good_pairs.at(static_cast<size_t>(source));
        map_->setSourceTone(source, toneOfSource(readiness, source),
                            tr("%n board(s) hear it well", nullptr, good));
    }
}

void ConnectPage::choose(int board) {
    board_ = board;
    map_->setChosen(board);
    card_->setBoard(board);
    pairs_->setBoard(board);
}

void ConnectPage::blink() {
    if (board_ < 0)
        capture_.shared().say(tr("Choose a board first."));
    else if (!capture_.suit().isPlugged(board_))
        capture_.shared().say(tr("Board %1 is unplugged and cannot blink.").arg(board_ + 1));
    else
        capture_.suit().blinkBoard(board_);
}

void ConnectPage::takeOff() {
    for (const ReadinessProblem& problem : std::vector(capture_.check().readiness().problems))
        if (board_ >= 0 && (problem.board == board_ || std::ranges::count(problem.alike, board_) > 0))
            return capture_.check().goOnWithout(problem);
    capture_.shared().say(board_ < 0
                              ? tr("Choose a board first.")
                              : tr("Board %1 works; there is nothing to go on without.").arg(board_ + 1));
}

void ConnectPage::resizeEvent(QResizeEvent* event) {
    Page::resizeEvent(event);
    showLayout();
}

}  // namespace noctule::ui
