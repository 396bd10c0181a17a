// SPDX-License-Identifier: Apache-2.0
#include "ui/views/calibrate_page.h"

#include <QVBoxLayout>

#include "ui/views/scaled_layout.h"
#include "ui/widgets/card.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {
namespace {

/// A picture, what is found out and how; as the cards of the wizards.
QWidget* taskCard(const QString& icon_name, const QString& title, const QString& what, const QString& how) {
    auto* card = new Card;
    auto* row = makeRow(card, {20, 16, 20, 16}, 20);
    auto* icon = new QLabel;
    const auto draw = [icon, icon_name] {
        icon->setPixmap(Theme::get().pixmap(icon_name, Theme::get().px(40), Theme::get().tokens().t2));
    };
    draw();
    QObject::connect(&Theme::get(), &Theme::changed, icon, draw);
    row->addWidget(icon, 0, Qt::AlignTop);
    auto* words = new QWidget;
    auto* column = makeColumn(words, {}, 4);
    column->addWidget(new Label(title, TextRole::kSection, Ink::kValue, true));
    column->addWidget((new Label(what, TextRole::kBody, Ink::kLabel))->wrapped());
    column->addWidget((new Label(how, TextRole::kSecondary, Ink::kHint))->wrapped());
    row->addWidget(words, 1);
    return card;
}

}  // namespace

CalibratePage::CalibratePage(Studio& studio, QWidget* parent)
    : ComingPage(
          studio,
          {tr("Calibrate"),
           tr("Nothing to calibrate"),
           tr("Calibration’s wizards are not part of this version."),
           {tr("Four wizards that recognise by themselves when a step is done, and that end with a verdict "
               "in "
               "numbers and words."),
            tr("Which calibration is in force, how old it is, and what it is worth.")},
           tr("Takes are processed with the calibration they carry. Those of the virtual suit carry one, and "
              "Review says how old it is.")},
          parent) {
    addVirtualSuitWay();
    addImportWay();
    auto* tasks = new QWidget;
    auto* column = makeColumn(tasks, {}, 12);
    column->addStretch();
    column->addWidget(
        taskCard("jig", tr("Source offsets"),
                 tr("How far from its housing each source sounds from, so that distances are right to "
                    "the millimetre."),
                 tr("Suit on its jig, three placements, about 6 minutes; once a year")));
    column->addWidget(
        taskCard("plate", tr("Accelerometers"), tr("Scale, zero and axes of each accelerometer."),
                 tr("Boards on the level plate, six sides, about 4 minutes; every three months")));
    column->addWidget(
        taskCard("turntable", tr("Gyroscopes"), tr("Scale, zero and axes of each gyroscope."),
                 tr("Boards on the turntable, three axes, about 5 minutes; every three months")));
    column->addWidget(taskCard("rest_pose", tr("Rest pose"), tr("How the boards sit on the performer today."),
                               tr("Stand still for 3 seconds; each time the suit is put on")));
    column->addStretch();
    keepMaximumWidth(*tasks, 640);
    auto* middle = new QWidget;
    auto* centred = makeRow(middle, {16, 16, 16, 16});
    centred->addStretch();
    centred->addWidget(tasks, 1000);
    centred->addStretch();
    setDrawing(new ScrollArea(middle), {});
}

}  // namespace noctule::ui
