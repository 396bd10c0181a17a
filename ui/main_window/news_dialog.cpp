// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/news_dialog.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/window_place.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {

NewsDialog::NewsDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("What is new"));
    auto* outer = makeColumn(this, {24, 20, 24, 20}, 12);
    outer->addWidget(new Label(tr("What is new"), TextRole::kPage, Ink::kValue, true));
    auto* content = new QWidget;
    auto* column = makeColumn(content, {0, 0, 8, 0}, 10);
    const auto add = [column](const QString& line) {
        column->addWidget((new Label(line, TextRole::kBody, Ink::kLabel))->wrapped());
    };
    column->addWidget(new SectionHeader(tr("In this version")));
    add(tr(
        "Several people at once: each suit has its name and colour, one take holds them all, and distances "
        "between them and to anchors in the room join the estimate."));
    add(
        tr("Recordings of other makers' sensors become takes: Xsens, Movella DOT, x-IMU3, OpenSense, MATLAB, "
           "C3D, TRC and tables. Which sensor sits where is found from the movement."));
    add(tr("A robot's arms follow a suit live, or a take."));
    add(tr("Magnetometers have a wizard of their own, and a room is checked for bent fields."));
    add(
        tr("Driver boxes are found on USB and in the network; Connect says whether the suit is ready and "
           "what to do about it."));
    add(
        tr("Calibration wizards for source offsets, accelerometers, gyroscopes, rest pose and movement, and "
           "a check of three seconds before a take that matters."));
    add(
        tr("Record from a suit: the live body with its rays, levels, a countdown, a shot list, markers and "
           "notes; the take opens in Review at once."));
    add(
        tr("Review with the body in three dimensions and plots of everything a take holds, all on one time; "
           "compare with a reference, read the report inside the window."));
    add(
        tr("Process a take again with other sensors or the filter of the paper, and see two results side by "
           "side."));
    add(
        tr("A mesh of your own as the body of the view, with bones or without; where its joints are is "
           "found, and can be moved by hand."));
    add(
        tr("Export to FBX, glTF, BVH, CSV and OpenSim, and as pictures and films; every file is read back "
           "and checked."));
    add(tr("A virtual suit, so that all of this can be tried without one."));
    column->addStretch();
    outer->addWidget(new ScrollArea(content), 1);
    auto* row = addRow(outer);
    row->addStretch();
    Button* close = makeButton(ButtonKind::kOutlined, tr("Close"), {}, QKeySequence("Esc"));
    row->addWidget(close);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    placeDialog(*this, {Theme::get().px(520), Theme::get().px(480)});
}

}  // namespace noctule::ui
