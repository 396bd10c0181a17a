// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/news_dialog.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
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
    add(
        tr("The studio: sessions with performers and takes, the body in three dimensions, and plots of "
           "everything a "
           "take holds, all on one time."));
    add(
        tr("Process a take again with other sensors or the estimator of the paper, and see two results side "
           "by side."));
    add(
        tr("Compare with a reference, read the report inside the window, and export BVH and CSV that are "
           "read back "
           "and checked."));
    add(
        tr("Driver boxes are found on USB and in the network; Connect says whether the suit is ready and "
           "what to do "
           "about it."));
    add(
        tr("Record from a suit: the live body with its rays, levels, a countdown, a shot list, markers and "
           "notes; the take opens in Review at once."));
    add(tr("A virtual suit, so that all of this can be tried without one."));
    column->addWidget(new SectionHeader(tr("Not yet")));
    add(tr("Calibration wizards. Calibrate says what they will do and what to do meanwhile."));
    add(tr("Export to FBX and glTF, video, and reading of optical markers."));
    column->addStretch();
    outer->addWidget(new ScrollArea(content), 1);
    auto* row = addRow(outer);
    row->addStretch();
    Button* close = makeButton(ButtonKind::kOutlined, tr("Close"), {}, QKeySequence("Esc"));
    row->addWidget(close);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    resize(Theme::get().px(520), Theme::get().px(480));
}

}  // namespace noctule::ui
