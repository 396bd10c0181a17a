// SPDX-License-Identifier: Apache-2.0
// Markers on the timeline: chosen, walked, named and deleted; its menu.
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <cmath>

#include "ui/plots/timeline.h"
#include "ui/style/theme.h"
#include "ui/widgets/name_field.h"

namespace noctule::ui {
namespace {

constexpr double kFlagReach = 9, kFieldWidth = 160;  // pixels at 100 percent
/// A marker this near counts as where the cursor stands.
constexpr double kOnMarker_s = 1e-3;
/// Nearer than two samples: the same marker, rounded to a sample.
constexpr double kSameTime_s = 1e-5;

}  // namespace

int Timeline::markerAt(const QPoint& position) const {
    const Rows r = rows();
    if (!overview_ || position.y() < r.ruler.top() - 2 || position.y() > r.ruler.center().y())
        return -1;
    const int reach = Theme::get().px(kFlagReach);
    for (size_t i = 0; i < overview_->markers.size(); ++i) {
        const double past = position.x() - xOf(overview_->markers[i].t_s);
        if (past >= -3 && past <= reach)
            return static_cast<int>(i);
    }
    return -1;
}

QPoint Timeline::flagPoint(double t_s) const {
    return {qRound(xOf(t_s)) + Theme::get().px(kFlagReach / 2), rows().ruler.top() + Theme::get().px(3)};
}

void Timeline::chooseMarker(int marker) {
    const ReviewMarker& chosen = overview_->markers[static_cast<size_t>(marker)];
    bars_.letGo();
    chosen_marker_ = marker;
    chosen_ = UserMarker{chosen.t_s, chosen.label};
    review_.time().setTime(chosen.t_s);
    update();
    emit chosenMarkerChanged();
}

/// What was set, named or brought back is the chosen one.
void Timeline::chooseWritten(const MarkerChange& change) {
    chosen_ = change.after;
}

int Timeline::indexOf(const UserMarker& marker) const {
    for (size_t i = 0; overview_ && i < overview_->markers.size(); ++i)
        if (std::abs(overview_->markers[i].t_s - marker.t_s) < kSameTime_s &&
            overview_->markers[i].label == marker.label)
            return static_cast<int>(i);
    return -1;
}

void Timeline::followChosenMarker() {
    chosen_marker_ = chosen_ ? indexOf(*chosen_) : -1;
    emit chosenMarkerChanged();
}

bool Timeline::canEditMarker() const {
    return overview_ && chosen_marker_ >= 0 &&
           MarkerEditor::isEditable(overview_->markers[static_cast<size_t>(chosen_marker_)]);
}

void Timeline::nameMarker() {
    if (!canEditMarker())
        return;
    const ReviewMarker& marker = overview_->markers[static_cast<size_t>(chosen_marker_)];
    window_.reveal(marker.t_s);
    auto* field = new NameField(tr("Name of the marker"), QString::fromStdString(marker.label), this);
    const int field_width = std::min(Theme::get().px(kFieldWidth), width());
    field->resize(field_width, field->sizeHint().height());
    field->move(std::clamp(qRound(xOf(marker.t_s)), 0, width() - field_width),
                std::clamp(rows().ruler.top(), 0, std::max(0, height() - field->height())));
    // While a name is typed the take may be read anew, another marker chosen or another take opened.
    connect(field, &NameField::named, this,
            [this, path = review_.take().path(), named = *chosen_](const QString& name) {
                if (review_.take().path() == path)
                    review_.markers().rename(indexOf(named), name);
            });
    field->show();
    field->setFocus();
}

void Timeline::deleteMarker() {
    if (canEditMarker())
        review_.markers().remove(chosen_marker_);
}

void Timeline::deleteChosen() {
    if (!bars_.hasChosen())
        return deleteMarker();
    bars_.removeChosen();
    contactChosen();
}

bool Timeline::editMarker(const QKeyEvent& event) {
    if (!canEditMarker() || event.modifiers() != Qt::NoModifier)
        return false;
    if (event.key() == Qt::Key_F2)
        nameMarker();
    else if (event.key() == Qt::Key_Delete)
        deleteMarker();
    else
        return false;
    return true;
}

void Timeline::contextMenuEvent(QContextMenuEvent* event) {
    const ContactLanes lanes = contactLanes();
    const bool by_keyboard = event->reason() == QContextMenuEvent::Keyboard;
    QPoint position = event->pos();
    if (by_keyboard && chosen_)
        position = flagPoint(chosen_->t_s);
    else if (by_keyboard)
        position = bars_.chosenPoint(lanes).value_or(QPoint(-1, -1));
    QMenu menu(this);
    if (!markerMenu(menu, by_keyboard ? chosen_marker_ : markerAt(position)) &&
        !bars_.fillMenu(menu, lanes, position))
        return;
    contactChosen();
    menu.exec(by_keyboard ? mapToGlobal(position) : event->globalPos());
    contactChosen();
}

bool Timeline::markerMenu(QMenu& menu, int marker) {
    if (marker < 0)
        return false;
    chooseMarker(marker);
    QAction* name = menu.addAction(tr("Name marker"), this, &Timeline::nameMarker);
    name->setShortcut(Qt::Key_F2);
    QAction* remove = menu.addAction(tr("Delete marker"), this, &Timeline::deleteMarker);
    remove->setShortcut(QKeySequence::Delete);
    for (QAction* action : {name, remove})
        action->setEnabled(canEditMarker());
    return true;
}

void Timeline::goToMarker(int direction) {
    if (!overview_)
        return;
    const double now_s = review_.time().time();
    int best = -1;
    double best_distance_s = review_.time().duration() + 1;
    for (size_t i = 0; i < overview_->markers.size(); ++i) {
        const double distance_s = (overview_->markers[i].t_s - now_s) * direction;
        if (distance_s > kOnMarker_s && distance_s < best_distance_s) {
            best = static_cast<int>(i);
            best_distance_s = distance_s;
        }
    }
    if (best < 0)
        return;
    chooseMarker(best);
    window_.reveal(review_.time().time());
}

}  // namespace noctule::ui
