// SPDX-License-Identifier: Apache-2.0
// The left dock of step Calibrate: the calibrations of the session, and files that come and go.
#include <QFileInfo>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/models/file_choice.h"
#include "ui/style/keys.h"
#include "ui/style/words.h"
#include "ui/views/newer_values.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/label.h"
#include "ui/widgets/question.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"
#include "ui/widgets/tool_button.h"
#include "ui/wizards/calibrate_page.h"
#include "ui/wizards/compare_dialog.h"

namespace noctule::ui {

QWidget* CalibratePage::makeHistory() {
    auto* content = new QWidget;
    auto* column = makeColumn(content, {12, 16, 12, 12}, 8);
    column->addWidget(new NewerValues(studio_));
    column->addWidget(new SectionHeader(tr("Of this session, newest first")));
    auto* history = new QWidget;
    history_ = makeColumn(history, {}, 8);
    column->addWidget(history);
    column->addWidget(makeFiles());
    column->addStretch();
    return new ScrollArea(content);
}

QWidget* CalibratePage::makeFiles() {
    auto* files = new QWidget;
    auto* row = makeRow(files, {}, 8);
    import_ = makeButton(ButtonKind::kOutlined, tr("Import"), "open");
    import_->setToolTip(tr("Use a calibration file of this suit"));
    export_ = makeButton(ButtonKind::kOutlined, tr("Export"), "export");
    row->addWidget(import_);
    row->addWidget(export_);
    row->addStretch();
    connect(import_, &QPushButton::clicked, this, &CalibratePage::chooseImport);
    connect(export_, &QPushButton::clicked, this, &CalibratePage::chooseExport);
    return files;
}

void CalibratePage::chooseImport() {
    const QString path =
        FileChoice{"calibrations", tr("Import a calibration"), tr("Calibrations (*.json)")}.toOpen(this);
    if (!path.isEmpty())
        importFile(path);
}

void CalibratePage::importFile(const QString& path) {
    const QString name = QFileInfo(path).fileName(), other = studio_.calibrations().otherSuitOf(path);
    if (!other.isEmpty() && !mayUseAnother(name, other))
        return;
    if (const QString why = studio_.calibrations().importFile(path); !why.isEmpty())
        emit studio_.failed(tr("%1 was not imported").arg(name), why, About::kFile);
    else
        studio_.sayOfFile(tr("%1 is in use; undo with %2.", "file, key")
                              .arg(name, keysText(Keys::keyOf("window/undo", QKeySequence("Ctrl+Z")))));
}

/// Serial numbers may be wrong or the boards have moved: the operator decides.
bool CalibratePage::mayUseAnother(const QString& name, const QString& other) {
    return isAnsweredYes({tr("Import a calibration"), tr("%1 was made for another suit").arg(name),
                          tr("It belongs to %1; %2 is connected. Sensors and sources differ from suit to "
                             "suit: with the values "
                             "of others poses are wrong.",
                             "serial numbers")
                              .arg(other, studio_.suit().serial()),
                          tr("Cancel"), tr("Use it all the same")},
                         window());
}

void CalibratePage::chooseExport() {
    const QString name = studio_.calibrations().fileInForce();
    const QString path =
        FileChoice{"calibrations", tr("Export the calibration in use"), tr("Calibrations (*.json)"),
                   name.isEmpty() ? QStringLiteral("calibration.json") : name}
            .toSave(this);
    if (path.isEmpty())
        return;
    if (const QString why = studio_.calibrations().exportFile(path); !why.isEmpty())
        emit studio_.failed(tr("The calibration was not exported"), why, About::kFile);
    else
        studio_.sayOfFile(tr("%1 is written.").arg(QFileInfo(path).fileName()));
}

QWidget* CalibratePage::makeAsideButton(const QString& file) {
    auto* aside = new ToolButton("close", tr("Put %1 aside").arg(file.section('.', 0, 0)));
    aside->setDisabledBecause(studio_.session().whyNotAside(file));
    connect(aside, &QToolButton::clicked, this, [this, file] {
        if (studio_.session().putCalibrationAside(file))
            studio_.sayOfFile(tr("%1 is put aside; undo with %2.", "file, key")
                                  .arg(file, keysText(Keys::keyOf("window/undo", QKeySequence("Ctrl+Z")))));
    });
    aside_.push_back(aside);
    return aside;
}

void CalibratePage::showHistory() {
    clearWidgetsLater(*history_);
    use_.clear();
    aside_.clear();
    const CalibrationShelf& shelf = studio_.calibrations();
    for (const ShelvedCalibration& one : shelf.all()) {
        if (shelf.isOfAnotherSuit(one))
            continue;
        auto* card = new Card;
        const bool in_force = shelf.isInForce(one);
        card->setSelected(in_force);
        auto* column = makeColumn(card, {12, 8, 12, 8}, 2);
        auto* name = new ElidedLabel(one.file.section('.', 0, 0));
        name->setElideMode(Qt::ElideMiddle);
        auto* head = addRow(column);
        head->addWidget(name, 1);
        head->addWidget(makeAsideButton(one.file));
        column->addWidget(new Label(in_force ? tr("%1, in use").arg(dateText(one.made().toLocalTime()))
                                             : dateText(one.made().toLocalTime()),
                                    TextRole::kSecondary, Ink::kHint));
        if (const QString other = shelf.otherSuitOf(one.calibration); !other.isEmpty())
            column->addWidget((new Label(tr("made for another suit, %1", "its serial number").arg(other),
                                         TextRole::kSecondary, Ink::kWarn))
                                  ->wrapped());
        if (!namesItsSuit(one.calibration))
            column->addWidget(
                (new Label(tr("made for an unknown suit"), TextRole::kSecondary, Ink::kHint))->wrapped());
        Button* use = nullptr;
        if (!in_force) {
            use = makeButton(ButtonKind::kText, tr("Go back to this one"));
            connect(use, &QPushButton::clicked, this, [this, file = one.file] {
                studio_.calibrations().use(file, tr("Going back to %1").arg(file.section('.', 0, 0)));
            });
            auto* compare = makeButton(ButtonKind::kText, tr("Compare"));
            compare->setToolTip(tr("What differs from the calibration in use"));
            connect(compare, &QPushButton::clicked, this,
                    [this, one] { CompareDialog(studio_, one, window()).exec(); });
            auto* row = addRow(column);
            row->addWidget(use);
            row->addWidget(compare);
            row->addStretch();
        }
        use_.push_back(use);
        history_->addWidget(card);
    }
    if (use_.empty())
        history_->addWidget(
            (new Label(
                 shelf.remembered()
                     ? tr("None yet. The suit's own values from an earlier session are in use; the rest "
                          "pose belongs to each wearing.")
                     : tr("None has been saved yet."),
                 TextRole::kSecondary, Ink::kHint))
                ->wrapped());
}

}  // namespace noctule::ui
