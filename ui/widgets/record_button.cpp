// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/record_button.h"

#include <QKeyEvent>
#include <QPainter>
#include <cmath>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/widgets/accessible.h"

namespace noctule::ui {
namespace {

// Pixels at 100 percent.
constexpr double kRing = 84, kRingPen = 3, kDisc = 66, kSquare = 22, kMargin = 2;
constexpr int kFrame_ms = 33;
constexpr double kTurn_s = 1;
constexpr double kPi = 3.14159265358979;

QColor faded(QColor color, double opacity) {
    color.setAlphaF(opacity);
    return color;
}

}  // namespace

RecordButton::RecordButton(QWidget* parent) : QAbstractButton(parent) {
    describe(*this, {QAccessible::Button});
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    // A click leaves the keyboard with the page, whose space bar records and stops.
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    pulse_.setInterval(kFrame_ms);
    connect(&pulse_, &QTimer::timeout, this, QOverload<>::of(&QWidget::update));
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
    tellName();
}

void RecordButton::setState(State state) {
    if (state == state_)
        return;
    state_ = state;
    const bool moves = state == State::kSaving || state == State::kRecording;
    since_.start();
    if (moves && Theme::get().motion_ms(1) > 0)
        pulse_.start();
    else
        pulse_.stop();
    tellName();
    update();
}

void RecordButton::tellName() {
    switch (state_) {
        case State::kReady:
            setAccessibleName(tr("Record"));
            break;
        case State::kCountdown:
            setAccessibleName(tr("Countdown: press to end it"));
            break;
        case State::kRecording:
            setAccessibleName(tr("Stop"));
            break;
        case State::kSaving:
            setAccessibleName(tr("The take is being saved"));
            break;
        case State::kRefused:
            setAccessibleName(tr("Record: press to hear what is in the way"));
            break;
    }
    setToolTip(accessibleName());
}

void RecordButton::setCountdown(double left_s, double of_s) {
    left_s_ = left_s;
    of_s_ = of_s;
    update();
}

int RecordButton::digit() const {
    return state_ == State::kCountdown ? static_cast<int>(std::ceil(left_s_)) : 0;
}

QSize RecordButton::sizeHint() const {
    const int side = Theme::get().px(kRing + 2 * kMargin);
    return {side, side};
}

bool RecordButton::hitButton(const QPoint& position) const {
    const QPointF from_centre = position - QRectF(rect()).center();
    return std::hypot(from_centre.x(), from_centre.y()) <= Theme::get().px(kRing) / 2.0;
}

void RecordButton::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        click();
    else
        QAbstractButton::keyPressEvent(event);
}

void RecordButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF centre = QRectF(rect()).center();
    paintRing(painter, centre);
    paintDisc(painter, centre);
}

void RecordButton::paintRing(QPainter& painter, const QPointF& centre) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const double radius = (theme.px(kRing) - theme.px(kRingPen)) / 2.0;
    const QRectF circle(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
    const double turned =
        since_.isValid() ? std::fmod(static_cast<double>(since_.elapsed()) * 1e-3 / kTurn_s, 1) : 0;
    const auto arc = [&](const QColor& color, double from_share, double share) {
        painter.setPen(QPen(color, theme.px(kRingPen), Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(circle, qRound((90 - 360 * from_share) * 16), qRound(-360 * share * 16));
    };
    painter.setBrush(Qt::NoBrush);
    switch (state_) {
        case State::kReady:
        case State::kRefused:
            arc(underMouse() ? tokens.t2 : tokens.edge, 0, 1);
            break;
        case State::kCountdown:
            arc(tokens.ctlh, 0, 1);
            arc(tokens.rec, 0, of_s_ > 0 ? 1 - left_s_ / of_s_ : 1);
            break;
        case State::kRecording:
            arc(faded(tokens.rec, pulse_.isActive() ? 0.35 - 0.15 * std::cos(2 * kPi * turned) : 0.5), 0, 1);
            break;
        case State::kSaving:
            arc(tokens.ctlh, 0, 1);
            arc(tokens.acc, pulse_.isActive() ? turned : 0, 0.25);
            break;
    }
}

void RecordButton::paintDisc(QPainter& painter, const QPointF& centre) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const double radius = theme.px(kDisc) / 2.0;
    const bool red = state_ != State::kSaving && state_ != State::kRefused;
    QColor fill = red ? tokens.rec : tokens.ctl;
    if (underMouse() && state_ != State::kSaving)
        fill = red ? mixed(fill, Qt::black, isDown() ? 0.2 : 0.1) : tokens.ctlh;
    painter.setPen(state_ == State::kRefused ? QPen(tokens.warn, theme.px(1.5)) : QPen(Qt::NoPen));
    painter.setBrush(fill);
    painter.drawEllipse(centre, radius, radius);
    if (state_ == State::kRecording || state_ == State::kSaving) {
        const double side = theme.px(kSquare);
        painter.setPen(Qt::NoPen);
        painter.setBrush(red ? QColor(Qt::white) : tokens.t3);
        painter.drawRoundedRect(QRectF(centre.x() - side / 2, centre.y() - side / 2, side, side), theme.px(3),
                                theme.px(3));
    } else if (state_ == State::kCountdown) {
        painter.setFont(theme.font(TextRole::kInstruction, true));
        painter.setPen(Qt::white);
        painter.drawText(QRectF(rect()), Qt::AlignCenter, QString::number(digit()));
    } else if (state_ == State::kRefused) {
        const double side = theme.px(24);
        paintIcon(painter, QRectF(centre.x() - side / 2, centre.y() - side / 2, side, side), "warn",
                  theme.px(24), tokens.warn);
    }
}

}  // namespace noctule::ui
