// SPDX-License-Identifier: Apache-2.0
#include "ui/views/body_map.h"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/models/part_names.h"
#include "ui/style/theme.h"
#include "ui/views/map_marker.h"

namespace noctule::ui {
namespace {

constexpr int kTop = 36, kBottom = 12, kLabelWidth = 132, kLabelGap = 20, kLeader = 28;
constexpr double kCentre_m = 0.03;  ///< boards nearer to the middle go to the emptier column

}  // namespace

BodyMap::BodyMap(const Actor& actor, const Suit& suit, const std::shared_ptr<const SkinnedMesh>& mesh,
                 QWidget* parent)
    : QWidget(parent),
      actor_(actor),
      suit_(suit),
      figure_(BodyFigure::of(actor, mesh)),
      details_(suit.boards.size()) {
    setAccessibleName(tr("Boards and sources on the body"));
    addMarkers();
    chooseColumns();
    connect(&Theme::get(), &Theme::changed, this, [this] {
        arrange();
        updateGeometry();
    });
}

void BodyMap::setBody(const std::shared_ptr<const SkinnedMesh>& mesh) {
    figure_ = BodyFigure::of(actor_, mesh);
    for (Place& place : places_) {
        const auto index = static_cast<size_t>(place.index);
        place.at_m =
            place.is_board ? figure_->board(suit_.boards[index]) : figure_->source(suit_.sources[index]);
    }
    arrange();
    updateGeometry();
    update();
}

void BodyMap::addMarkers() {
    for (int i = 0; i < boardCount(); ++i) {
        const Board& board = suit_.boards[static_cast<size_t>(i)];
        auto* marker = new MapMarker(MapMarker::Shape::kBoard, i + 1, boardTitle(suit_, i), this);
        connect(marker, &QAbstractButton::clicked, this, [this, i] { emit boardClicked(i); });
        places_.push_back({marker, figure_->board(board), true, i});
    }
    for (int i = 0; i < sourceCount(); ++i) {
        const Source& source = suit_.sources[static_cast<size_t>(i)];
        auto* marker = new MapMarker(MapMarker::Shape::kSource, i + 1, sourceTitle(suit_, i), this);
        connect(marker, &QAbstractButton::clicked, this, [this, i] { emit sourceClicked(i); });
        places_.push_back({marker, figure_->source(source), false, i});
    }
    for (const Place& place : places_)
        place.marker->installEventFilter(this);
}

QAbstractButton* BodyMap::boardButton(int board) const {
    return places_[static_cast<size_t>(board)].marker;
}

QAbstractButton* BodyMap::sourceButton(int source) const {
    return places_[static_cast<size_t>(boardCount() + source)].marker;
}

void BodyMap::setBoardState(int board, Tone tone, const QString& detail) {
    details_[static_cast<size_t>(board)] = detail;
    MapMarker* marker = places_[static_cast<size_t>(board)].marker;
    marker->setTone(tone);
    marker->setAccessibleDescription(detail);
    picture_ = {};
    update();
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
    return {Theme::get().px(520), std::max(Theme::get().px(420), static_cast<int>(10 * labelHeight()))};
}

double BodyMap::labelHeight() const {
    const Theme& theme = Theme::get();
    return QFontMetrics(theme.font(TextRole::kBody, true)).height() +
           QFontMetrics(theme.font(TextRole::kSecondary)).height() + theme.px(6);
}

QPointF BodyMap::toPixels(const QPointF& p_m) const {
    const Theme& theme = Theme::get();
    const int drawing = height() - theme.px(kTop + kBottom);
    const double scale = figure_->scale(drawing);
    return {width() / 2.0 + scale * p_m.x(), height() - theme.px(kBottom) - scale * p_m.y()};
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
                if (&a == &b || distance >= least || distance < 1e-6)
                    continue;
                const QPointF push = way / distance * (least - distance) / 2;
                a.at_px -= push;
                b.at_px += push;
            }
}

/// Each label as near to its board's height as the others in the column allow.
void BodyMap::spreadLabels(bool left_column) {
    std::vector<Place*> column;
    for (Place& place : places_)
        if (place.is_board && place.left_column == left_column)
            column.push_back(&place);
    std::sort(column.begin(), column.end(),
              [](const Place* a, const Place* b) { return a->at_m.y() > b->at_m.y(); });
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

void BodyMap::renewFigure() {
    const Theme& theme = Theme::get();
    const int drawing = height() - theme.px(kTop + kBottom);
    if (drawing < 50)
        return;
    std::map<std::string, QColor> marked;
    for (const Place& place : places_)
        if (place.is_board && (place.marker->tone() == Tone::kWarn || place.marker->tone() == Tone::kError))
            marked[suit_.boards[static_cast<size_t>(place.index)].segment] =
                backgroundOf(place.marker->tone());
    const double ratio = devicePixelRatioF();
    const QImage image = figure_->paint(static_cast<int>(drawing * ratio), theme.tokens().ctlh, marked);
    picture_ = QPixmap::fromImage(image);
    picture_.setDevicePixelRatio(ratio);
}

void BodyMap::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (picture_.isNull())
        renewFigure();
    painter.drawPixmap(
        QPointF((width() - picture_.width() / picture_.devicePixelRatio()) / 2, theme.px(kTop)), picture_);
    painter.setFont(theme.font(TextRole::kSecondary));
    painter.setPen(tokens.t3);
    const QRect head(0, 0, width(), theme.px(kTop - 8));
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, tr("Performer’s right"));
    painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, tr("Performer’s left"));
    for (const Place& place : places_)
        if (place.is_board)
            paintLabel(painter, place);
}

void BodyMap::paintLabel(QPainter& painter, const Place& place) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const int reach =
        static_cast<int>(figure_->half_width_m() * figure_->scale(height() - theme.px(kTop + kBottom)));
    const int side = std::min(width() / 2 - theme.px(kLabelWidth), reach + theme.px(kLabelGap + kLeader));
    const int edge = width() / 2 + (place.left_column ? -side : side);
    const int direction = place.left_column ? -1 : 1;

    const Tone tone = place.marker->tone();
    const bool quiet = tone == Tone::kNeutral || tone == Tone::kOk;
    painter.setPen(QPen(quiet ? tokens.line : colorOf(tone), 1));
    const QPointF board = place.at_px + QPointF(direction * theme.px(11), 0);
    painter.drawPolyline(QVector<QPointF>{board, QPointF(edge - direction * theme.px(kLeader), place.label_y),
                                          QPointF(edge - direction * theme.px(6), place.label_y)});

    const QFont name = theme.font(TextRole::kBody, true), detail = theme.font(TextRole::kSecondary);
    const int name_height = QFontMetrics(name).height(), detail_height = QFontMetrics(detail).height();
    const QString words = details_[static_cast<size_t>(place.index)];
    const int block = name_height + (words.isEmpty() ? 0 : detail_height);
    const int left = place.left_column ? 0 : edge, label_width = place.left_column ? edge : width() - edge;
    const auto alignment =
        static_cast<int>(Qt::AlignVCenter | (place.left_column ? Qt::AlignRight : Qt::AlignLeft));
    const int top = static_cast<int>(place.label_y) - block / 2;
    painter.setFont(name);
    painter.setPen(quiet ? tokens.t1 : colorOf(tone));
    painter.drawText(QRect(left, top, label_width, name_height), alignment,
                     boardName(suit_.boards[static_cast<size_t>(place.index)]));
    painter.setFont(detail);
    painter.setPen(quiet ? tokens.t3 : colorOf(tone));
    painter.drawText(QRect(left, top + name_height, label_width, detail_height), alignment, words);
}

bool BodyMap::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress)
        if (walk(qobject_cast<MapMarker*>(watched), static_cast<QKeyEvent*>(event)->key()))
            return true;
    return QWidget::eventFilter(watched, event);
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
