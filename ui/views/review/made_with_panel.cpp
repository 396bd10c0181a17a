// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/made_with_panel.h"

#include <algorithm>

#include "ui/style/lengths.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"

namespace noctule::ui {
namespace {

QString dayOf(const std::string& utc) {
    const QDateTime when = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
    return when.isValid() ? dateText(when) : kNoValue;
}

}  // namespace

MadeWithPanel::MadeWithPanel(ReviewContext& review, QWidget* parent) : QWidget(parent), review_(review) {
    auto* rows = new FormRows;
    performer_ = rows->addValue(tr("Performer"), {});
    recorded_ = rows->addValue(tr("Recorded"), {});
    offsets_ = rows->addValue(tr("Source offsets"), {});
    inertial_ = rows->addValue(tr("Calibration"), {});
    rest_ = rows->addValue(tr("Rest pose"), {});
    skeleton_ = rows->addValue(tr("Skeleton"), {});
    suit_ = rows->addValue(tr("Suit"), {});
    sound_ = rows->addValue(tr("Sound"), {});
    makeColumn(this, {12, 0, 12, 0})->addWidget(rows);
    connect(&review.take(), &TakeDocument::opened, this, &MadeWithPanel::refresh);
    refresh();
}

void MadeWithPanel::refresh() {
    const auto overview = review_.take().overview();
    if (!overview) {
        for (Label* label : {performer_, recorded_, offsets_, inertial_, rest_, skeleton_, suit_, sound_})
            label->setText(kNoValue);
        return;
    }
    performer_->setText(overview->performer.empty() ? kNoValue : QString::fromStdString(overview->performer));
    recorded_->setText(dayOf(overview->header.created_utc));
    const auto& sources = overview->calibration.sources;
    const auto known = std::count_if(sources.begin(), sources.end(), [](const SourceCalibration& source) {
        return !source.offsets_s.empty();
    });
    offsets_->setText(known == 0 ? tr("not calibrated")
                                 : tr("%1 of %2").arg(known).arg(overview->suit.sources.size()));
    inertial_->setText(overview->calibration.created_utc.empty() ? tr("nominal values")
                                                                 : dayOf(overview->calibration.created_utc));
    rest_->setText(overview->rest_s
                       ? tr("%1, from %2")
                             .arg(secondsText(overview->rest_s->second - overview->rest_s->first),
                                  timeText(overview->rest_s->first, 0))
                       : tr("not marked"));
    skeleton_->setText(overview->actor ? tr("%1 joints, %2")
                                             .arg(overview->actor->skeleton.size())
                                             .arg(lengthText(overview->actor->height_m))
                                       : tr("not in the take"));
    suit_->setText(
        tr("%1 boards, %2 sources").arg(overview->suit.boards.size()).arg(overview->suit.sources.size()));
    sound_->setText(overview->level == TakeLevel::kSignal
                        ? tr("%1 kHz").arg(numberText(overview->sample_rate_hz / 1000, 0))
                        : tr("not kept"));
}

}  // namespace noctule::ui
