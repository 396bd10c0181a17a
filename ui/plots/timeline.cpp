// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/timeline.h"

#include <QAccessible>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/plots/plot_panel.h"
#include "ui/plots/time_keys.h"
#include "ui/plots/timeline_accessible.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

// Pixels at 100 percent.
constexpr double kAbove = 4, kFoot = 9, kFootRow = 16, kBetweenRows = 8, kRuler = 24, kLabels = 20,
                 kOverview = 4, kBelow = 4, kGripReach = 6;

}  // namespace

Timeline::Timeline(ReviewContext& review, TimeWindow& window, QWidget* parent)
    : QWidget(parent), review_(review), window_(window), bars_(review), repaint_([this] { showTime(); }) {
    TimelineAccessible::install();
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Timeline"));
    setAccessibleDescription(
        tr("Left and Right step a frame, with Shift a second; Home and End go to in and out; F2 names the "
           "chosen marker, Del deletes it. Up and Down choose the contact of the left or right foot at the "
           "cursor, with Ctrl Left and Right the one before or after; I and O let it begin or end at the "
           "cursor, Ins sets one, Del deletes it"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    TakeDocument& take = review.take();
    for (const auto signal :
         {&TakeDocument::opened, &TakeDocument::runsChanged, &TakeDocument::motionChanged})
        connect(&take, signal, this, &Timeline::readTake);
    connect(&review.contacts(), &ContactEditor::changed, this, qOverload<>(&QWidget::update));
    connect(&review.changes(), &TakeChanges::written, this,
            [this](const QString& path, const TakeChange& change) {
                if (const auto* marker = std::get_if<MarkerChange>(&change);
                    marker && path == review_.take().path())
                    chooseWritten(*marker);
            });
    connect(&window, &TimeWindow::changed, this, [this] { repaint_.ask(); });
    connect(&review.time(), &TimeCursor::timeChanged, this, [this] { repaint_.ask(); });
    connect(&review.time(), &TimeCursor::rangeChanged, this, qOverload<>(&QWidget::update));
    connect(&review.time(), &TimeCursor::extentChanged, this, qOverload<>(&QWidget::update));
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
    readTake();
}

void Timeline::readTake() {
    overview_ = review_.take().overview();
    review_.contacts().contacts();  // asked for, they are loaded
    followChosenMarker();
    update();
}

void Timeline::showTime() {
    update();
    if (!QAccessible::isActive())
        return;
    QAccessibleValueChangeEvent event(this, review_.time().time());
    QAccessible::updateAccessibility(&event);
}

QString Timeline::valueText() const {
    const QString time = tr("%1 of %2", "time of the cursor, length of the take")
                             .arg(timeText(review_.time().time(), 2), timeText(review_.time().duration(), 2));
    return bars_.hasChosen() ? time + QStringLiteral("; ") + bars_.chosenWords() : time;
}

QSize Timeline::sizeHint() const {
    return {Theme::get().px(640), minimumSizeHint().height()};
}

QSize Timeline::minimumSizeHint() const {
    const Theme& theme = Theme::get();
    return {theme.px(PlotPanel::kLeftExtent + 160),
            theme.px(kAbove + 2 * kFootRow + kBetweenRows + kRuler + kLabels + kOverview + kBelow)};
}

Timeline::Rows Timeline::rows() const {
    const Theme& theme = Theme::get();
    Rows rows;
    rows.left = theme.px(PlotPanel::kLeftExtent);
    rows.right = std::max(rows.left + 1, width() - theme.px(PlotPanel::kRightExtent));
    const int span = rows.right - rows.left;
    int y = theme.px(kAbove);
    for (QRect& foot : rows.feet) {
        foot = QRect(rows.left, y + (theme.px(kFootRow) - theme.px(kFoot)) / 2, span, theme.px(kFoot));
        y += theme.px(kFootRow);
    }
    y += theme.px(kBetweenRows);
    rows.ruler = QRect(rows.left, y, span, theme.px(kRuler));
    rows.labels = QRect(rows.left, rows.ruler.bottom() + 1, span, theme.px(kLabels));
    rows.overview = QRect(rows.left, rows.labels.bottom() + 1, span, theme.px(kOverview));
    return rows;
}

double Timeline::xOf(double t_s) const {
    const Rows r = rows();
    return r.left + window_.xOf(t_s, r.right - r.left);
}

double Timeline::timeAt(double x_px) const {
    const Rows r = rows();
    return window_.timeAt(x_px - r.left, r.right - r.left);
}

QPoint Timeline::inGrip() const {
    return {qRound(xOf(review_.time().in())), rows().ruler.center().y()};
}

QPoint Timeline::outGrip() const {
    return {qRound(xOf(review_.time().out())), rows().ruler.center().y()};
}

QPoint Timeline::rulerPoint(double t_s) const {
    return {qRound(xOf(t_s)), rows().ruler.center().y()};
}

QPoint Timeline::footPoint(int foot, double t_s) const {
    return {qRound(xOf(t_s)), rows().feet[static_cast<size_t>(foot)].center().y()};
}

ContactLanes Timeline::contactLanes() const {
    const Rows r = rows();
    const double px_per_s = (r.right - r.left) / std::max(window_.span(), TimeWindow::kShortest_s);
    return {r.feet, Theme::get().px((kFootRow - kFoot) / 2), window_.from(), px_per_s};
}

/// One thing is chosen at a time.
void Timeline::contactChosen() {
    if (bars_.hasChosen() && chosen_) {
        chosen_.reset();
        followChosenMarker();
    } else {
        emit chosenMarkerChanged();
    }
    showTime();
}

void Timeline::addContact() {
    bars_.addAtCursor();
    contactChosen();
}

void Timeline::restoreFoundContacts() {
    bars_.restoreFound();
    contactChosen();
}

Timeline::Grip Timeline::gripAt(const QPoint& position) const {
    const Rows r = rows();
    const int reach = Theme::get().px(kGripReach);
    if (!window_.showsAll() && position.y() >= r.overview.top() - reach / 2)
        return Grip::kWindow;
    const bool on_ruler = position.y() >= r.ruler.top() - reach && position.y() <= r.ruler.bottom() + reach;
    const double to_in = std::abs(position.x() - xOf(review_.time().in()));
    const double to_out = std::abs(position.x() - xOf(review_.time().out()));
    if (on_ruler && std::min(to_in, to_out) <= reach)
        return to_in < to_out ? Grip::kIn : Grip::kOut;
    return Grip::kTime;
}

QString Timeline::tooltipAt(const QPoint& position) const {
    const Rows r = rows();
    const double t_s = timeAt(position.x());
    if (const int marker = markerAt(position); marker >= 0) {
        const ReviewMarker& m = overview_->markers[static_cast<size_t>(marker)];
        const QString time = timeText(m.t_s, 2);
        return m.label.empty() ? tr("Marker at %1").arg(time)
                               : tr("%1, at %2").arg(QString::fromStdString(m.label), time);
    }
    if (r.ruler.contains(position) && overview_)
        for (const auto& [from_s, to_s] : overview_->gaps_s)
            if (t_s >= from_s && t_s <= to_s)
                return tr("Gap of %1: nothing arrived").arg(secondsText(to_s - from_s, 2));
    if (const QString contact = bars_.tooltipAt(contactLanes(), position); !contact.isEmpty())
        return contact;
    switch (gripAt(position)) {
        case Grip::kIn:
            return tr("In, %1").arg(timeText(review_.time().in(), 2));
        case Grip::kOut:
            return tr("Out, %1").arg(timeText(review_.time().out(), 2));
        default:
            return {};
    }
}

void Timeline::dragTo(double x_px) {
    TimeCursor& time = review_.time();
    switch (grip_) {
        case Grip::kTime:
            time.setTime(timeAt(x_px));
            break;
        case Grip::kIn:
            time.setRange(std::min(timeAt(x_px), time.out()), time.out());
            break;
        case Grip::kOut:
            time.setRange(time.in(), std::max(timeAt(x_px), time.in()));
            break;
        case Grip::kWindow: {
            const Rows r = rows();
            const double middle_s = (x_px - r.left) / (r.right - r.left) * time.duration();
            window_.pan(middle_s - (window_.from() + window_.to()) / 2);
            break;
        }
        case Grip::kNone:
            break;
    }
}

void Timeline::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !overview_)
        return;
    if (const int marker = markerAt(event->pos()); marker >= 0) {
        setFocus(Qt::MouseFocusReason);
        chooseMarker(marker);
        return;
    }
    const bool on_bar = bars_.press(contactLanes(), event->pos());
    contactChosen();
    if (on_bar)
        return setFocus(Qt::MouseFocusReason);
    grip_ = gripAt(event->pos());
    grip_offset_px_ = 0;
    if (grip_ == Grip::kIn || grip_ == Grip::kOut) {  // a press alone moves nothing
        const double edge_s = grip_ == Grip::kIn ? review_.time().in() : review_.time().out();
        grip_offset_px_ = xOf(edge_s) - event->localPos().x();
    } else {
        dragTo(event->localPos().x());
    }
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
    if (bars_.drag(contactLanes(), event->pos()))
        return update();
    if (grip_ != Grip::kNone) {
        dragTo(event->localPos().x() + grip_offset_px_);
        return;
    }
    const Grip grip = gripAt(event->pos());
    const bool on_end = bars_.isOnEnd(contactLanes(), event->pos());
    setCursor(grip == Grip::kIn || grip == Grip::kOut || on_end ? Qt::SplitHCursor : Qt::ArrowCursor);
}

void Timeline::mouseReleaseEvent(QMouseEvent*) {
    grip_ = Grip::kNone;
    if (bars_.release())
        contactChosen();
}

void Timeline::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    if (const int marker = markerAt(event->pos()); marker >= 0) {
        chooseMarker(marker);
        nameMarker();
    } else if (bars_.doubleClick(contactLanes(), event->pos())) {
        contactChosen();
    } else {
        window_.showAll();
    }
}

void Timeline::wheelEvent(QWheelEvent* event) {
    const QPoint turn = event->angleDelta();
    if (std::abs(turn.x()) > std::abs(turn.y()))
        window_.pan(-turn.x() / 1200.0 * window_.span());
    else
        window_.zoom(std::pow(TimeWindow::kNotch, turn.y() / 120.0), timeAt(event->position().x()));
    event->accept();
}

void Timeline::keyPressEvent(QKeyEvent* event) {
    TimeCursor& time = review_.time();
    if (bars_.key(*event)) {
        contactChosen();
        return window_.reveal(time.time());
    }
    if (editMarker(*event))
        return;
    if (stepTime(time, *event))
        window_.reveal(time.time());
    else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal)
        window_.zoom(TimeWindow::kNotch, time.time());
    else if (event->key() == Qt::Key_Minus)
        window_.zoom(1 / TimeWindow::kNotch, time.time());
    else
        QWidget::keyPressEvent(event);
}

bool Timeline::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        auto* help = static_cast<QHelpEvent*>(event);
        const QString words = tooltipAt(help->pos());
        words.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), words, this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace noctule::ui
