// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/markers_panel.h"

#include <algorithm>

#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {

namespace {
constexpr int kMarkerTime = Qt::UserRole, kMarkerRow = 28, kMostMarkers = 6;
constexpr int kMarkerIndent = 6;  ///< beyond a cell's own, to the column of the headings
}  // namespace

MarkersPanel::MarkersPanel(ReviewContext& review, QWidget* parent) : QListWidget(parent), review_(review) {
    setFrameShape(QFrame::NoFrame);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);  // else its section takes free height
    setAccessibleName(tr("Markers"));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTextElideMode(Qt::ElideRight);
    connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { goTo(*item); });
    connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { goTo(*item); });
    connect(&review.take(), &TakeDocument::opened, this, &MarkersPanel::refresh);
    connect(&review.take(), &TakeDocument::runsChanged, this, &MarkersPanel::refresh);
    connect(&Theme::get(), &Theme::changed, this, &MarkersPanel::refresh);
    refresh();
}

void MarkersPanel::refresh() {
    clear();
    const auto overview = review_.take().overview();
    std::vector<ReviewMarker> markers = overview ? overview->markers : std::vector<ReviewMarker>();
    std::stable_sort(markers.begin(), markers.end(),
                     [](const ReviewMarker& a, const ReviewMarker& b) { return a.t_s < b.t_s; });
    setViewportMargins(Theme::get().px(kMarkerIndent), 0, 0, 0);
    const int row_px = Theme::get().px(kMarkerRow);
    for (const ReviewMarker& marker : markers) {
        const QString label = marker.label.empty() ? tr("Marker") : QString::fromStdString(marker.label);
        auto* item =
            new QListWidgetItem(tr("%1   %2", "time, name").arg(timeText(marker.t_s, 2), label), this);
        item->setData(kMarkerTime, marker.t_s);
        item->setSizeHint({0, row_px});
        item->setToolTip(label);
    }
    if (markers.empty()) {
        auto* hint = new QListWidgetItem(tr("M sets a marker at the cursor."), this);
        hint->setFlags(Qt::NoItemFlags);
        hint->setSizeHint({0, row_px});
    }
    setFixedHeight(std::clamp(count(), 1, kMostMarkers) * row_px + 2 * frameWidth());
}

void MarkersPanel::goTo(const QListWidgetItem& item) {
    if (item.flags() & Qt::ItemIsEnabled)
        review_.time().setTime(item.data(kMarkerTime).toDouble());
}

}  // namespace noctule::ui
