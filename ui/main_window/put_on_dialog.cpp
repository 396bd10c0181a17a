// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/put_on_dialog.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/style/theme.h"
#include "ui/views/connect/map_legend.h"
#include "ui/views/connect/performer_map.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/window_place.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {
PutOnDialog::PutOnDialog(Studio& studio, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Put the suit on"));
    auto* outer = makeColumn(this, {24, 16, 24, 16}, 12);
    outer->addWidget(new Label(tr("Put the suit on"), TextRole::kPage, Ink::kValue, true));
    auto* columns = addRow(outer, 24);
    outer->setStretch(1, 1);
    columns->addWidget(makePerformerMap(studio), 1);
    auto* steps = new ScrollArea(makeSteps());
    keepSize(*steps, 300, 0);
    columns->addWidget(steps);
    auto* row = addRow(outer);
    row->addWidget(new MapLegend, 1);
    Button* close = makeButton(ButtonKind::kOutlined, tr("Close"), {}, QKeySequence("Esc"));
    row->addWidget(close);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    placeDialog(*this, {Theme::get().px(1040), Theme::get().px(720)});
}

QWidget* PutOnDialog::makeSteps() {
    auto* steps = new QWidget;
    auto* column = makeColumn(steps, {0, 0, 8, 0}, 16);
    int number = 0;
    const auto add = [&](const QString& title, const QString& text) {
        auto* step = new QWidget;
        auto* lines = makeColumn(step, {}, 2);
        lines->addWidget((new Label(tr("%1. %2", "number and title of a step").arg(++number).arg(title),
                                    TextRole::kBody, Ink::kValue, true))
                             ->wrapped());
        lines->addWidget((new Label(text, TextRole::kBody, Ink::kLabel))->wrapped());
        column->addWidget(step);
    };
    add(tr("Tight clothes first"),
        tr("Boards must not slide on cloth. A thin, close layer keeps them on the limb."));
    add(tr("Vest with the driver box"), tr("The box sits on the back. Chest, ribs and belly carry seven "
                                           "sources; nothing may cover their front."));
    add(tr("Hat"),
        tr("Its source looks down from the brim, so that the shoulders hear it. The board sits on the "
           "forehead."));
    add(tr("Boards from the trunk outwards"),
        tr("Pelvis, abdomen, chest, then clavicles, arms and hands, then "
           "thighs, shins and feet. The microphone faces "
           "away from the body."));
    add(tr("Tight, not painful"),
        tr("On muscle a loose strap is the largest error of all. Above the ankle and above "
           "the wrist hold best."));
    add(tr("Look once around"),
        tr("Cables lie flat and leave the joints free; numbers on boards and drawing agree."));
    column->addStretch();
    return steps;
}

}  // namespace noctule::ui
