// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/rating_stars.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/widgets/accessible.h"

namespace noctule::ui {

namespace {

constexpr int kStars = 5;
constexpr double kPitch = 12;  // at 100 percent, as the mock-ups have it
constexpr double kStar = 11;

}  // namespace

RatingStars::RatingStars(int rating, QWidget* parent)
    : QWidget(parent), rating_(std::clamp(rating, 0, kStars)) {
    describe(*this, {QAccessible::Slider, [this] { return rating_; }, 0, kStars, 1,
                     [this](double value) { choose(qRound(value)); },
                     [this] { return tr("%n of 5 stars", nullptr, rating_); }});
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Rating"));
    setToolTip(tr("Rating, keys 0 to 5"));
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(); });
}

void RatingStars::setRating(int rating) {
    rating_ = std::clamp(rating, 0, kStars);
    tellValueChanged(*this, rating_);
    update();
}

QSize RatingStars::sizeOf() {
    const Theme& theme = Theme::get();
    return {theme.px(kStars * kPitch), theme.px(28)};
}

QSize RatingStars::sizeHint() const {
    return sizeOf();
}

int RatingStars::ratingAt(int x) {
    return std::clamp(static_cast<int>(x / (sizeOf().width() / double(kStars))) + 1, 1, kStars);
}

void RatingStars::paint(QPainter& painter, const QRect& area, int rating, const QColor& color) {
    const Theme& theme = Theme::get();
    const double pitch = sizeOf().width() / double(kStars);
    for (int i = 0; i < kStars; ++i) {
        const bool full = i < rating;
        const QRectF cell(area.left() + i * pitch, area.top(), pitch, area.height());
        paintIcon(painter, cell, full ? "star_filled" : "star", theme.px(kStar),
                  full ? color : theme.tokens().edge);
    }
}

void RatingStars::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Tokens& tokens = Theme::get().tokens();
    paint(painter, rect(), hovered_ > 0 ? hovered_ : rating_, hovered_ > 0 ? tokens.t1 : tokens.t2);
}

void RatingStars::choose(int rating) {
    if (rating == rating_)
        return;
    setRating(rating);
    emit ratingChanged(rating_);
}

void RatingStars::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    const int clicked = ratingAt(event->pos().x());
    hovered_ = -1;
    choose(clicked == rating_ ? 0 : clicked);
}

void RatingStars::mouseMoveEvent(QMouseEvent* event) {
    hovered_ = ratingAt(event->pos().x());
    update();
}

void RatingStars::leaveEvent(QEvent*) {
    hovered_ = -1;
    update();
}

void RatingStars::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    if (key >= Qt::Key_0 && key <= Qt::Key_5 && !(event->modifiers() & ~Qt::KeypadModifier))
        return choose(key - Qt::Key_0);
    if (key == Qt::Key_Right || key == Qt::Key_Plus)
        return choose(std::min(rating_ + 1, kStars));
    if (key == Qt::Key_Left || key == Qt::Key_Minus)
        return choose(std::max(rating_ - 1, 0));
    QWidget::keyPressEvent(event);
}

}  // namespace noctule::ui
