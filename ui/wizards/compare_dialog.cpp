// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/compare_dialog.h"

#include <QVBoxLayout>

#include "core/report/calibration_comparison.h"
#include "ui/models/part_names.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/wizards/calibration_table_card.h"

namespace noctule::ui {
namespace {

constexpr int kWide = 840;

QString nameOf(const QString& file) {
    return file.section('.', 0, 0);
}

}  // namespace

CompareDialog::CompareDialog(CaptureContext& capture, const ShelvedCalibration& other, QWidget* parent)
    : DialogFrame(tr("Compare calibrations"),
                  tr("%1 of %2, against the one in use, %3")
                      .arg(nameOf(other.file), dateText(other.made().toLocalTime()),
                           nameOf(capture.calibrations().fileInForce())),
                  tr("Use %1").arg(nameOf(other.file)), parent) {
    auto* tables = new QWidget;
    auto* column = makeColumn(tables, {}, 12);
    const auto in_force = capture.calibrations().inForce().value_or(Calibration{});
    const auto names = partNames(capture.suit().suit());
    for (const CalibrationTable& table : compareCalibrations(in_force, other.calibration))
        column->addWidget(new CalibrationTableCard(named(table, names)));
    if (column->count() == 0)
        column->addWidget(new Label(tr("All values are the same."), TextRole::kBody, Ink::kLabel));
    column->addStretch();
    content()->addWidget(new ScrollArea(tables), 1);
    setWide(kWide);
    connect(this, &QDialog::accepted, this, [&capture, file = other.file] {
        capture.calibrations().use(file, tr("Going back to %1").arg(nameOf(file)));
    });
}

}  // namespace noctule::ui
