// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect_page.h"

#include <QVBoxLayout>

#include "core/suit/default_suit.h"
#include "ui/models/part_names.h"
#include "ui/views/body_map.h"
#include "ui/views/map_legend.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

ConnectPage::ConnectPage(Studio& studio, QWidget* parent)
    : ComingPage(
          studio,
          {tr("Connect"),
           tr("No suit is connected"),
           tr("The studio does not connect to driver boxes yet; noctule --batch devices and record do."),
           {tr("Driver boxes found on USB and in the network, and the virtual suit as one of them."),
            tr("Every board and source on the drawing with its state: what arrives, what is faint, what fell "
               "silent, and what to do about it."),
            tr("Whether a pair of boards is swapped, and how many source-board pairs are good.")},
           tr("Takes from elsewhere can be reviewed, processed and exported, and the virtual suit makes one "
              "now.")},
          parent),
      frame_(new QWidget) {
    addVirtualSuitWay();
    addImportWay();
    addWay(tr("Performer and suit"), "mesh", [this] { studio_.goTo(Step::kPerformer); });
    addWay(tr("Put the suit on"), "note", [this] { emit putSuitOnRequested(); });
    auto* column = makeColumn(frame_, {}, 8);
    chosen_ =
        new Label(tr("Choose a board or a source to see where it sits."), TextRole::kSecondary, Ink::kHint);
    column->addWidget(new MapLegend);
    column->addWidget(chosen_);
    setDrawing(frame_);
    connect(&studio.session(), &SessionModel::changed, this, [this] {
        if (isVisible())
            showSuit();
    });
}

void ConnectPage::enter() {
    showSuit();
}

void ConnectPage::showSuit() {
    BodyMeasures measures;
    Suit suit = defaultSuit();
    const SessionModel& model = studio_.session();
    if (model.isOpen())
        if (const Performer* performer = model.session().findPerformer(model.session().current_performer)) {
            measures = performer->measures;
            suit = performer->suit;
        }
    delete map_;
    map_ = new BodyMap(defaultActor(measures), suit, studio_.body());
    if (!studio_.body())
        studio_.whenBodyIsThere(map_, [this] { map_->setBody(studio_.body()); });
    for (int i = 0; i < map_->boardCount(); ++i)
        map_->setBoardState(i, Tone::kNeutral, tr("board %1").arg(i + 1));
    connect(map_, &BodyMap::boardClicked, this,
            [this, suit](int board) { chosen_->setText(boardTitle(suit, board)); });
    connect(map_, &BodyMap::sourceClicked, this,
            [this, suit](int source) { chosen_->setText(sourceTitle(suit, source)); });
    static_cast<QVBoxLayout*>(frame_->layout())->insertWidget(0, map_, 1);
}

}  // namespace noctule::ui
