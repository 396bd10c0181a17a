// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect_page.h"

#include <QVBoxLayout>

#include "ui/models/part_names.h"
#include "ui/views/map_legend.h"
#include "ui/views/performer_map.h"
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
    delete map_;
    map_ = makePerformerMap(studio_);
    connect(map_, &BodyMap::boardClicked, this,
            [this](int board) { chosen_->setText(boardTitle(map_->suit(), board)); });
    connect(map_, &BodyMap::sourceClicked, this,
            [this](int source) { chosen_->setText(sourceTitle(map_->suit(), source)); });
    static_cast<QVBoxLayout*>(frame_->layout())->insertWidget(0, map_, 1);
}

}  // namespace noctule::ui
