// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/process_takes_dialog.h"

#include <QListWidget>
#include <QVBoxLayout>

#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

constexpr int kTakesWide = 440, kTakesHigh = 200;

/// What processing uses, and what becomes of the takes.
QString aboutProcessing(Studio& studio, bool with_actor, ProcessTakesDialog::With with) {
    const QString calibration = studio.calibrations().fileInForce().section('.', 0, 0);
    QStringList words{calibration.isEmpty()
                          ? ProcessTakesDialog::tr(
                                "Each take is processed as accurately as possible, with all sensors and the "
                                "calibration that it was recorded with.")
                          : ProcessTakesDialog::tr(
                                "Each take is processed as accurately as possible, with all sensors and the "
                                "calibration “%1”; takes of several performers keep their own.")
                                .arg(calibration)};
    if (with == ProcessTakesDialog::With::kTheirOwn && !calibration.isEmpty())
        words = QStringList(ProcessTakesDialog::tr(
                                "Each take is processed as accurately as possible, with all sensors and the "
                                "calibration that it was recorded with; one recorded without gets “%1”.")
                                .arg(calibration));
    if (with_actor)
        words << ProcessTakesDialog::tr("Takes of %1 get the bone lengths that this calibration found.")
                     .arg(QString::fromStdString(studio.session().session().current_performer));
    words << ProcessTakesDialog::tr("A result is added to each; recordings and earlier results stay.");
    return words.join(' ');
}

}  // namespace

ProcessTakesDialog::ProcessTakesDialog(Studio& studio, std::optional<Actor> actor, QWidget* parent, With with)
    : DialogFrame(tr("Process takes"), aboutProcessing(studio, actor.has_value(), with), tr("Process"),
                  parent),
      studio_(studio),
      actor_(std::move(actor)),
      with_(with),
      takes_(new QListWidget) {
    takes_->setAccessibleName(tr("Takes to process"));
    keepSize(*takes_, kTakesWide, kTakesHigh);
    content()->addWidget(takes_);
    if (studio_.session().isOpen())
        for (const SessionTake& take : studio_.session().session().takes) {
            if (take.state == TakeState::kRecording)
                continue;
            const QString name = QString::fromStdString(take.name);
            auto* item = new QListWidgetItem(tr("%1   %2").arg(name, timeText(take.duration_s, 0)), takes_);
            item->setData(Qt::UserRole, name);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
            item->setCheckState(isOfPerformer(take) ? Qt::Checked : Qt::Unchecked);
        }
    connect(takes_, &QListWidget::itemChanged, this, &ProcessTakesDialog::refresh);
    connect(this, &QDialog::accepted, this, &ProcessTakesDialog::process);
    refresh();
}

bool ProcessTakesDialog::isOfPerformer(const SessionTake& take) const {
    return take.performer == studio_.session().session().current_performer;
}

QStringList ProcessTakesDialog::ticked() const {
    QStringList names;
    for (int row = 0; row < takes_->count(); ++row)
        if (takes_->item(row)->checkState() == Qt::Checked)
            names << takes_->item(row)->data(Qt::UserRole).toString();
    return names;
}

void ProcessTakesDialog::tick(const QStringList& names) {
    for (int row = 0; row < takes_->count(); ++row) {
        QListWidgetItem* item = takes_->item(row);
        item->setCheckState(names.contains(item->data(Qt::UserRole).toString()) ? Qt::Checked
                                                                                : Qt::Unchecked);
    }
}

void ProcessTakesDialog::refresh() {
    const int count = static_cast<int>(ticked().size());
    actionButton()->setText(count > 0 ? tr("Process %n take(s)", nullptr, count) : tr("Process"));
    actionButton()->setDisabledBecause(count > 0 ? QString() : tr("Tick at least one take."));
}

void ProcessTakesDialog::process() {
    const QStringList names = ticked();
    std::vector<std::pair<std::string, PartsOfOne>> takes;
    for (const SessionTake& take : studio_.session().session().takes)
        if (names.contains(QString::fromStdString(take.name)))
            takes.emplace_back(
                studio_.session().session().pathOf(take).string(),
                PartsOfOne{studio_.calibrations().inForce(), isOfPerformer(take) ? actor_ : std::nullopt,
                           with_ == With::kTheirOwn});
    studio_.processInTurn(std::move(takes));
}

}  // namespace noctule::ui
