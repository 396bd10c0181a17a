// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/time_window.h"

#include <algorithm>
#include <cmath>

namespace noctule::ui {
namespace {

/// A turned page keeps this share of the old one, so that the eye finds its place.
constexpr double kPageOverlap = 0.1;

}  // namespace

TimeWindow::TimeWindow(TimeCursor& cursor, QObject* parent) : QObject(parent), cursor_(cursor) {
    connect(&cursor, &TimeCursor::extentChanged, this, &TimeWindow::showAll);
    connect(&cursor, &TimeCursor::timeChanged, this, [this](double t_s) {
        if (cursor_.isPlaying())
            reveal(t_s);
    });
    showAll();
}

double TimeWindow::duration() const {
    return std::max(cursor_.duration(), kShortest_s);
}

bool TimeWindow::showsAll() const {
    return span_s_ >= duration() * (1 - 1e-9);
}

void TimeWindow::show(double from_s, double to_s) {
    if (!std::isfinite(from_s) || !std::isfinite(to_s))
        return;
    const double span_s = std::clamp(to_s - from_s, kShortest_s, duration());
    const double clamped_s = std::clamp(from_s, 0.0, duration() - span_s);
    if (clamped_s == from_s_ && span_s == span_s_)
        return;
    from_s_ = clamped_s, span_s_ = span_s;
    emit changed();
}

void TimeWindow::showAll() {
    show(0, duration());
}

void TimeWindow::zoom(double factor, double around_s) {
    if (!(factor > 0))
        return;
    const double span_s = std::clamp(span_s_ / factor, kShortest_s, duration());
    const double from_s = around_s - (around_s - from_s_) * span_s / span_s_;
    show(from_s, from_s + span_s);
}

void TimeWindow::pan(double seconds) {
    const double from_s = std::clamp(from_s_ + seconds, 0.0, duration() - span_s_);
    show(from_s, from_s + span_s_);
}

void TimeWindow::reveal(double t_s) {
    if (t_s >= from() && t_s <= to())
        return;
    const double from_s = t_s > to() ? t_s - kPageOverlap * span_s_ : t_s - (1 - kPageOverlap) * span_s_;
    show(from_s, from_s + span_s_);
}

}  // namespace noctule::ui
