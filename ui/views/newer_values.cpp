// SPDX-License-Identifier: Apache-2.0
#include "ui/views/newer_values.h"

#include <QPushButton>
#include <QVBoxLayout>

#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {

NewerValues::NewerValues(CaptureContext& capture, QWidget* parent) : QWidget(parent), capture_(capture) {
    makeColumn(this);
    capture_.suits().follow(&CalibrationShelf::changed, this, &NewerValues::refresh);
    capture_.suits().follow(&LiveSuit::wearingChanged, this, &NewerValues::refresh);
    capture_.suits().follow(&LiveSuit::phaseChanged, this, &NewerValues::refresh);
    refresh();
}

void NewerValues::refresh() {
    const auto& newer = capture_.calibrations().newer();
    const QString made = newer ? QString::fromStdString(newer->created_utc) : QString();
    setVisible(newer.has_value());
    if (card_ && made == made_ && newer)
        return;
    made_ = made;
    if (card_)
        std::exchange(card_, nullptr)->deleteLater();
    if (!newer)
        return;
    card_ = new ProblemCard(
        Tone::kWarn, tr("Newer values of this suit are there"),
        tr("Another session calibrated its sensors or sources, %1. The rest pose of this session stays.")
            .arg(dateInside(QDateTime::fromString(made, Qt::ISODate))));
    connect(card_->addAction(tr("Use them")), &QPushButton::clicked, this, &NewerValues::use,
            Qt::QueuedConnection);
    layout()->addWidget(card_);
}

void NewerValues::use() {
    SharedContext& shared = capture_.shared();
    if (const QString why = capture_.calibrations().useNewer(); !why.isEmpty())
        emit shared.failed(tr("The newer values are not in use"), why, About::kFile);
    else
        emit shared.settled(About::kFile);
}

}  // namespace noctule::ui
