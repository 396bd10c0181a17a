// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/lane_stack.h"

#include <QGestureEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPinchGesture>
#include <algorithm>
#include <cmath>

#include "ui/plots/plot_panel.h"
#include "ui/plots/time_keys.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr double kPanShare = 0.1;  ///< of the window per key press or notch
constexpr double kDot = 3.5;       // pixels at 100 percent

}  // namespace

/// The time cursor with its dots on the curves, and the take's markers, above all lanes.
class LaneStack::Overlay : public QWidget {
public:
    Overlay(LaneStack& stack, ReviewContext& review, TimeWindow& window)
        : QWidget(&stack), stack_(stack), review_(review), window_(window) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
    }

    void follow() {
        updateAround(cursor_s_);
        cursor_s_ = review_.time().time();
        updateAround(cursor_s_);
    }
    void renew() {
        cursor_s_ = review_.time().time();
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        if (const auto overview = review_.take().overview())
            paintMarkers(painter, *overview);
        paintCursor(painter);
    }

private:
    void updateAround(double t_s) {
        const int reach = Theme::get().px(kDot) + 2;
        update(qRound(xOf(t_s)) - reach, 0, 2 * reach + 1, height());
    }

    double xOf(double t_s) const {
        const auto [left, right] = stack_.timeExtent();
        return left + window_.xOf(t_s, right - left);
    }

    bool shows(double t_s) const { return t_s >= window_.from() && t_s <= window_.to(); }

    void paintMarkers(QPainter& painter, const TakeOverview& overview) const {
        const Tokens& tokens = Theme::get().tokens();
        for (const ReviewMarker& marker : overview.markers) {
            if (!shows(marker.t_s))
                continue;
            QColor color = marker.kind == "user" ? tokens.acc : tokens.warn;
            color.setAlphaF(0.7);
            QPen pen(color, 1);
            pen.setDashPattern({2, 3});
            painter.setPen(pen);
            const int x = qRound(xOf(marker.t_s));
            for (const QRect& rows : plottedRows())
                painter.drawLine(x, rows.top(), x, rows.bottom());
        }
    }

    /// Of every lane that has a curve the rows below its title: lines run through no words.
    std::vector<QRect> plottedRows() const {
        std::vector<QRect> rows;
        for (const PlotLane* lane : stack_.lanes())
            if (!lane->content().curves.empty())
                rows.push_back(lane->geometry().adjusted(0, Theme::get().px(PlotLane::kTitleRow), 0, 0));
        return rows;
    }

    void paintCursor(QPainter& painter) const {
        const double t_s = cursor_s_;
        const int x_px = qRound(xOf(t_s));
        if (!shows(t_s) || !review_.take().isOpen())
            return;
        const Tokens& tokens = Theme::get().tokens();
        for (const QRect& rows : plottedRows())
            painter.fillRect(QRect(x_px, rows.top(), Theme::get().px(1), rows.height()), tokens.t1);
        painter.setRenderHint(QPainter::Antialiasing);
        const double radius = Theme::get().px(kDot);
        for (const PlotLane* lane : stack_.lanes())
            for (const PlotLane::Dot& dot : lane->dotsAt(t_s)) {
                painter.setPen(QPen(tokens.panel, 1));
                painter.setBrush(dot.color);
                painter.drawEllipse(QPointF(x_px + 0.5, lane->y() + dot.position.y()), radius, radius);
            }
    }

    LaneStack& stack_;
    ReviewContext& review_;
    TimeWindow& window_;
    /// Where the cursor is painted. Painting does not change it: a part may be painted, for whatever reason,
    /// before follow() has seen the new time, and the old cursor would stay elsewhere.
    double cursor_s_ = 0;
};

LaneStack::LaneStack(ReviewContext& review, TimeWindow& window, QWidget* parent)
    : QWidget(parent),
      review_(review),
      window_(window),
      overlay_(new Overlay(*this, review, window)),
      redraw_([this] { redraw(); }),
      move_cursor_([this] { moveCursor(); }) {
    setFocusPolicy(Qt::StrongFocus);
    grabGesture(Qt::PinchGesture);
    setAccessibleName(tr("Plots"));
    setAccessibleDescription(tr("Plus and minus zoom, %1 and %2 pan, %3 shows the whole take", "keys")
                                 .arg(keysText(QKeySequence("Ctrl+Left")),
                                      keysText(QKeySequence("Ctrl+Right")),
                                      keysText(QKeySequence("Ctrl+0"))));
    connect(&window, &TimeWindow::changed, this, [this] { redraw_.ask(); });
    connect(&review.time(), &TimeCursor::rangeChanged, this, [this] { redraw_.ask(); });
    connect(&review.time(), &TimeCursor::timeChanged, this, [this] { move_cursor_.ask(); });
    connect(&review.take(), &TakeDocument::opened, overlay_, [this] { overlay_->renew(); });
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        place();
    });
}

void LaneStack::setLanes(std::vector<LaneContent> lanes) {
    while (lanes_.size() > lanes.size()) {
        delete lanes_.back();
        lanes_.pop_back();
    }
    while (lanes_.size() < lanes.size()) {
        lanes_.push_back(new PlotLane(this));
        lanes_.back()->show();
    }
    for (size_t i = 0; i < lanes.size(); ++i)
        lanes_[i]->setContent(std::move(lanes[i]));
    overlay_->raise();
    updateGeometry();
    place();
    redraw();
}

void LaneStack::setScrollBarWidth(int width_px) {
    scroll_bar_px_ = width_px;
    place();
}

std::pair<int, int> LaneStack::timeExtent() const {
    const Theme& theme = Theme::get();
    const int left = theme.px(PlotPanel::kLeftExtent);
    const int right = width() - std::max(0, theme.px(PlotPanel::kRightExtent) - scroll_bar_px_);
    return {left, std::max(left + 1, right)};
}

QSize LaneStack::minimumSizeHint() const {
    const Theme& theme = Theme::get();
    const int count = static_cast<int>(lanes_.size());
    return {theme.px(PlotPanel::kLeftExtent + 160), count * leastLaneHeight()};
}

/// As many whole lanes as fit share what is seen: none is cut in its title.
int LaneStack::leastLaneHeight() const {
    const int least = Theme::get().px(PlotLane::kLeastHeight);
    const int seen = parentWidget() ? parentWidget()->height() : 0, fitting = std::max(1, seen / least);
    if (std::ssize(lanes()) <= fitting)
        return least;
    return std::max(least, (seen + fitting - 1) / fitting);
}

void LaneStack::place() {
    const int count = static_cast<int>(lanes_.size());
    for (int i = 0; i < count; ++i) {
        PlotLane& lane = *lanes_[static_cast<size_t>(i)];
        lane.setRightExtent(width() - timeExtent().second);
        const int top = height() * i / count, bottom = height() * (i + 1) / count;
        lane.setGeometry(0, top, width(), bottom - top);
    }
    overlay_->setGeometry(rect());
    overlay_->renew();
}

void LaneStack::resizeEvent(QResizeEvent*) {
    place();
}

void LaneStack::redraw() {
    const LaneEmphasis emphasis{review_.time().in(), review_.time().out()};
    for (PlotLane* lane : lanes_) {
        lane->draw(window_.from(), window_.to(), emphasis);
        lane->setCursor(review_.time().time());
    }
    overlay_->renew();
}

void LaneStack::moveCursor() {
    for (PlotLane* lane : lanes_)
        lane->setCursor(review_.time().time());
    overlay_->follow();
}

double LaneStack::timeAt(double x_px) const {
    const auto [left, right] = timeExtent();
    return window_.timeAt(x_px - left, right - left);
}

double LaneStack::zoomCentre() const {
    const double t_s = review_.time().time();
    return t_s >= window_.from() && t_s <= window_.to() ? t_s : (window_.from() + window_.to()) / 2;
}

void LaneStack::mousePressEvent(QMouseEvent* event) {
    const bool pans = event->button() == Qt::MiddleButton ||
                      (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ShiftModifier));
    drag_x_px_ = event->localPos().x();
    if (pans) {
        drag_ = Drag::kPan;
        setCursor(Qt::ClosedHandCursor);
    } else if (event->button() == Qt::LeftButton) {
        drag_ = Drag::kTime;
        review_.time().setTime(timeAt(drag_x_px_));
    }
}

void LaneStack::mouseMoveEvent(QMouseEvent* event) {
    const double x = event->localPos().x();
    if (drag_ == Drag::kTime)
        review_.time().setTime(timeAt(x));
    if (drag_ == Drag::kPan) {
        window_.pan(timeAt(drag_x_px_) - timeAt(x));
        drag_x_px_ = x;
    }
}

void LaneStack::mouseReleaseEvent(QMouseEvent*) {
    drag_ = Drag::kNone;
    unsetCursor();
}

void LaneStack::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        window_.showAll();
}

void LaneStack::wheelEvent(QWheelEvent* event) {
    const QPoint turn = event->angleDelta();
    const auto [left, right] = timeExtent();
    if (event->position().x() < left) {  // over the titles: scrolls the lanes
        event->ignore();
        return;
    }
    const double notches_x = turn.x() / 120.0, notches_y = turn.y() / 120.0;
    if (event->modifiers() & Qt::ShiftModifier)
        window_.pan(-notches_y * kPanShare * window_.span());
    else if (std::abs(notches_x) > std::abs(notches_y))
        window_.pan(-notches_x * kPanShare * window_.span());
    else
        window_.zoom(std::pow(TimeWindow::kNotch, notches_y), timeAt(event->position().x()));
    event->accept();
}

void LaneStack::keyPressEvent(QKeyEvent* event) {
    if (stepTime(review_.time(), *event)) {
        window_.reveal(review_.time().time());
        return;
    }
    const bool control = event->modifiers() & Qt::ControlModifier;
    if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal)
        window_.zoom(TimeWindow::kNotch, zoomCentre());
    else if (event->key() == Qt::Key_Minus)
        window_.zoom(1 / TimeWindow::kNotch, zoomCentre());
    else if (control && event->key() == Qt::Key_0)
        window_.showAll();
    else if (control && event->key() == Qt::Key_Left)
        window_.pan(-kPanShare * window_.span());
    else if (control && event->key() == Qt::Key_Right)
        window_.pan(kPanShare * window_.span());
    else
        QWidget::keyPressEvent(event);
}

bool LaneStack::event(QEvent* event) {
    if (event->type() == QEvent::Gesture) {
        auto* gesture = static_cast<QGestureEvent*>(event);
        if (auto* pinch = static_cast<QPinchGesture*>(gesture->gesture(Qt::PinchGesture))) {
            const QPointF centre = mapFromGlobal(pinch->centerPoint().toPoint());
            window_.zoom(pinch->scaleFactor(), timeAt(centre.x()));
            gesture->accept(pinch);
            return true;
        }
    }
    return QWidget::event(event);
}

}  // namespace noctule::ui
