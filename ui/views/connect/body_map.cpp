// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/body_map.h"

#include <QApplication>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "ui/models/part_names.h"
#include "ui/style/theme.h"
#include "ui/views/connect/map_marker.h"

namespace noctule::ui {
namespace {

constexpr double kCentre_m = 0.03;  ///< boards nearer to the middle go to the emptier column

}  // namespace

BodyMap::BodyMap(const Actor& actor, const Suit& suit, const std::shared_ptr<const SkinnedMesh>& mesh,
                 QWidget* parent)
    : QWidget(parent),
      actor_(actor),
      suit_(suit),
      figure_(BodyFigure::of(actor, mesh)),
      details_(suit.boards.size()) {
    if (suit.isFixed())
        room_.emplace(suit);
    setAccessibleName(room_ ? tr("Anchors of the room, from above") : tr("Boards and sources on the body"));
    addMarkers();
    chooseColumns();
    connect(&Theme::get(), &Theme::changed, this, [this] {
        arrange();
        updateGeometry();
    });
}

void BodyMap::setBody(const std::shared_ptr<const SkinnedMesh>& mesh) {
    figure_ = BodyFigure::of(actor_, mesh);
    for (Place& place : places_)
        place.at_m = placeOf(place);
    arrange();
    updateGeometry();
    update();
}

QPointF BodyMap::placeOf(const Place& place) const {
    const auto index = static_cast<size_t>(place.index);
    if (room_)
        return room_->at(place.is_board ? suit_.boards[index].p_segment_board_m
                                        : suit_.sources[index].p_segment_source_m);
    return place.is_board ? figure_->board(suit_.boards[index]) : figure_->source(suit_.sources[index]);
}

/// Pixels per metre.
double BodyMap::scale(int height_px) const {
    return room_ ? height_px / room_->height_m() : figure_->scale(height_px);
}

double BodyMap::half_width_m() const {
    return room_ ? room_->half_width_m() : figure_->half_width_m();
}

void BodyMap::addMarkers() {
    for (int i = 0; i < boardCount(); ++i) {
        auto* marker = new MapMarker(MapMarker::Shape::kBoard, i + 1, boardTitle(suit_, i), this);
        connect(marker, &QAbstractButton::clicked, this, [this, i] { emit boardClicked(i); });
        places_.push_back({marker, {}, true, i});
    }
    for (int i = 0; i < sourceCount(); ++i) {
        auto* marker = new MapMarker(MapMarker::Shape::kSource, i + 1, sourceTitle(suit_, i), this);
        connect(marker, &QAbstractButton::clicked, this, [this, i] { emit sourceClicked(i); });
        places_.push_back({marker, {}, false, i});
    }
    for (Place& place : places_) {
        place.at_m = placeOf(place);
        place.marker->installEventFilter(this);
    }
}

QAbstractButton* BodyMap::boardButton(int board) const {
    return places_[static_cast<size_t>(board)].marker;
}

QAbstractButton* BodyMap::sourceButton(int source) const {
    return places_[static_cast<size_t>(boardCount() + source)].marker;
}

void BodyMap::setBoardState(int board, Tone tone, const QString& detail) {
    QString& words = details_[static_cast<size_t>(board)];
    MapMarker* marker = places_[static_cast<size_t>(board)].marker;
    if (words == detail && marker->tone() == tone)
        return;
    words = detail;
    if (marker->tone() != tone)
        picture_ = {};  // the figure shows what is not well
    marker->setTone(tone);
    marker->setAccessibleDescription(detail);
    update();
}

void BodyMap::setSourceTone(int source, Tone tone, const QString& detail) {
    MapMarker* marker = places_[static_cast<size_t>(boardCount() + source)].marker;
    if (marker->tone() != tone)
        marker->setTone(tone);
    marker->setAccessibleDescription(detail);
    marker->setToolTip(detail.isEmpty() ? marker->accessibleName()
                                        : marker->accessibleName() + QStringLiteral(": ") + detail);
}

void BodyMap::setChosen(int board) {
    if (board == chosen_)
        return;
    chosen_ = board;
    for (const Place& place : places_)
        place.marker->setChosen(place.is_board && place.index == board);
}

void BodyMap::chooseColumns() {
    int in_left = 0, in_right = 0;
    for (Place& place : places_)
        if (place.is_board && std::abs(place.at_m.x()) > kCentre_m) {
            place.left_column = place.at_m.x() < 0;
            ++(place.left_column ? in_left : in_right);
        }
    for (Place& place : places_)
        if (place.is_board && std::abs(place.at_m.x()) <= kCentre_m) {
            place.left_column = in_left < in_right;
            ++(place.left_column ? in_left : in_right);
        }
}

QSize BodyMap::sizeHint() const {
    return {Theme::get().px(760), Theme::get().px(640)};
}

QSize BodyMap::minimumSizeHint() const {
    return {Theme::get().px(470),
            std::max(Theme::get().px(340), Theme::get().px(kTop) + static_cast<int>(9 * labelHeight()))};
}

double BodyMap::labelHeight() const {
    const Theme& theme = Theme::get();
    return QFontMetrics(theme.font(TextRole::kBody, true)).height() +
           QFontMetrics(theme.font(TextRole::kSecondary)).height() + theme.px(3);
}

int BodyMap::drawingHeight() const {
    const Theme& theme = Theme::get();
    const double beside = width() / 2.0 - theme.px(kLabelWidth + kLabelGap);
    const double widest = beside / (half_width_m() * scale(1));
    return static_cast<int>(std::min<double>(height() - theme.px(kTop + kBottom), widest));
}

double BodyMap::floor() const {
    const Theme& theme = Theme::get();
    const double spare = height() - theme.px(kTop + kBottom) - drawingHeight();
    return height() - theme.px(kBottom) - spare / 2;
}

QPointF BodyMap::toPixels(const QPointF& p_m) const {
    const double pixels_per_m = scale(drawingHeight());
    return {width() / 2.0 + pixels_per_m * p_m.x(), floor() - pixels_per_m * p_m.y()};
}

void BodyMap::resizeEvent(QResizeEvent*) {
    arrange();
}

void BodyMap::arrange() {
    for (Place& place : places_)
        place.at_px = toPixels(place.at_m);
    separateMarkers();
    for (const Place& place : places_) {
        QRect frame(QPoint(), place.marker->sizeHint());
        frame.moveCenter(place.at_px.toPoint());
        place.marker->setGeometry(frame);
    }
    spreadLabels(true);
    spreadLabels(false);
    picture_ = {};
    update();
}

/// Marks that would cover each other move apart by what is missing.
void BodyMap::separateMarkers() {
    const double least = Theme::get().px(21);
    for (int round = 0; round < 4; ++round)
        for (Place& a : places_)
            for (Place& b : places_) {
                const QPointF way = b.at_px - a.at_px;
                const double distance = std::hypot(way.x(), way.y());
                if (&a == &b || distance >= least)
                    continue;
                const QPointF apart = distance > 1e-6 ? way / distance : QPointF(1, 0);
                const QPointF push = apart * (least - distance) / 2;
                a.at_px -= push;
                b.at_px += push;
            }
}

/// Each label as near to its board's height as the others in the column allow. Where a leader would run
/// through the mark of a board further out, the two labels change places.
void BodyMap::spreadLabels(bool left_column) {
    std::vector<Place*> column;
    for (Place& place : places_)
        if (place.is_board && place.left_column == left_column)
            column.push_back(&place);
    std::sort(column.begin(), column.end(),
              [](const Place* a, const Place* b) { return a->at_m.y() > b->at_m.y(); });
    stack(column);
    bool changed = false;
    for (size_t i = 0; i + 1 < column.size(); ++i)
        if (leaderHits(*column[i], *column[i + 1])) {
            std::swap(column[i], column[i + 1]);
            changed = true;
            ++i;
        }
    if (changed)
        stack(column);
}

bool BodyMap::leaderHits(const Place& inner, const Place& outer) const {
    const QLineF line = leader(inner);
    const double way = (outer.at_px.x() - line.x1()) / line.dx();
    return way > 0 && std::abs(line.pointAt(std::min(way, 1.0)).y() - outer.at_px.y()) < Theme::get().px(9);
}

QLineF BodyMap::leader(const Place& place) const {
    const Theme& theme = Theme::get();
    const int direction = place.left_column ? -1 : 1;
    return {place.at_px + QPointF(direction * theme.px(11), 0),
            QPointF(labelEdge(place.left_column) - direction * theme.px(kLeader), place.label_y)};
}

QLineF BodyMap::leaderOf(int board) const {
    const auto place = std::ranges::find_if(
        places_, [board](const Place& one) { return one.is_board && one.index == board; });
    return place == places_.end() ? QLineF() : leader(*place);
}

/// Where the labels of a column begin.
int BodyMap::labelEdge(bool left_column) const {
    const Theme& theme = Theme::get();
    const int reach = static_cast<int>(half_width_m() * scale(drawingHeight()));
    const int side = std::min(width() / 2 - theme.px(kLabelWidth), reach + theme.px(kLabelGap + kLeader));
    return width() / 2 + (left_column ? -side : side);
}

/// The labels of a column, in this order from the top.
void BodyMap::stack(const std::vector<Place*>& column) const {
    const double step = labelHeight();
    double lowest_free = Theme::get().px(kTop) + step / 2;
    for (Place* place : column) {
        place->label_y = std::max(lowest_free, place->at_px.y());
        lowest_free = place->label_y + step;
    }
    double highest_free = height() - step / 2;
    for (auto place = column.rbegin(); place != column.rend(); ++place) {
        (*place)->label_y = std::min((*place)->label_y, highest_free);
        highest_free = (*place)->label_y - step;
    }
}

bool BodyMap::eventFilter(QObject* watched, QEvent* event) {
    const bool of_mouse = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseMove ||
                          event->type() == QEvent::MouseButtonRelease;
    if (of_mouse && movable_)
        return drag(qobject_cast<MapMarker*>(watched), *static_cast<QMouseEvent*>(event));
    const int key = event->type() == QEvent::KeyPress ? static_cast<QKeyEvent*>(event)->key() : 0;
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        static_cast<QAbstractButton*>(watched)->click();
        return true;
    }
    if (event->type() == QEvent::KeyPress)
        if (walk(qobject_cast<MapMarker*>(watched), static_cast<QKeyEvent*>(event)->key()))
            return true;
    return QWidget::eventFilter(watched, event);
}

/// The board whose mark or words lie nearest, if near at all.
int BodyMap::boardNear(const QPointF& position) const {
    const double reach = Theme::get().px(40);
    int nearest = -1;
    double least = reach;
    for (const Place& place : places_) {
        if (!place.is_board)
            continue;
        const QPointF way = position - place.at_px;
        const bool beside = place.left_column ? position.x() < width() * 0.25 : position.x() > width() * 0.75;
        const double distance = std::min(std::hypot(way.x(), way.y()),
                                         beside ? std::abs(position.y() - place.label_y) : 2 * reach);
        if (distance < least) {
            least = distance;
            nearest = place.index;
        }
    }
    return nearest;
}

/// True: the mark shall not be clicked.
bool BodyMap::drag(MapMarker* marker, const QMouseEvent& event) {
    if (!marker || marker->shape() != MapMarker::Shape::kBoard)
        return false;
    const QPoint here = marker->mapToParent(event.pos());
    if (event.type() == QEvent::MouseButtonPress) {
        pressed_at_ = here;
        return false;
    }
    if (event.type() == QEvent::MouseMove) {
        const bool far = (here - pressed_at_).manhattanLength() >= QApplication::startDragDistance();
        if (dragged_ < 0 && (event.buttons() & Qt::LeftButton) && far)
            dragged_ = marker->text().toInt() - 1;
        dragged_to_ = here;
        if (dragged_ >= 0)
            update();
        return dragged_ >= 0;
    }
    const int board = std::exchange(dragged_, -1);
    if (board < 0)
        return false;
    update();
    const int onto = boardNear(here);
    marker->setDown(false);
    if (onto >= 0 && onto != board)
        emit boardDropped(board, onto);
    return true;
}

/// To the nearest marker in the direction of an arrow key; what lies aside counts double.
bool BodyMap::walk(const MapMarker* from, int key) {
    const QPoint direction = key == Qt::Key_Left    ? QPoint(-1, 0)
                             : key == Qt::Key_Right ? QPoint(1, 0)
                             : key == Qt::Key_Up    ? QPoint(0, -1)
                             : key == Qt::Key_Down  ? QPoint(0, 1)
                                                    : QPoint();
    if (!from || direction.isNull())
        return false;
    MapMarker* nearest = nullptr;
    int least = 0;
    for (const Place& place : places_) {
        const QPoint way = place.marker->geometry().center() - from->geometry().center();
        const int ahead = QPoint::dotProduct(way, direction);
        const int aside = std::abs(way.x() * direction.y()) + std::abs(way.y() * direction.x());
        if (ahead > 0 && (!nearest || ahead + 2 * aside < least)) {
            nearest = place.marker;
            least = ahead + 2 * aside;
        }
    }
    if (nearest)
        nearest->setFocus(Qt::OtherFocusReason);
    return true;
}

}  // namespace noctule::ui
