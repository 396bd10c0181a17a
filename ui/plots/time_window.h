// SPDX-License-Identifier: Apache-2.0
// Which part of the take the plots and the timeline show, and where a time stands on the screen. All lanes
// and the timeline share one, so that an instant is one vertical line through all of them.
#pragma once

#include <QObject>

#include "ui/models/time_cursor.h"

namespace noctule::ui {

class TimeWindow : public QObject {
    Q_OBJECT
public:
    /// Shows the whole take whenever its extent changes; turns pages when the playing cursor leaves.
    explicit TimeWindow(TimeCursor& cursor, QObject* parent = nullptr);

    double from() const { return from_s_; }
    double to() const { return from_s_ + span_s_; }
    double span() const { return span_s_; }
    bool showsAll() const;

    /// Position of a time in a width of pixels, and back.
    double xOf(double t_s, double width_px) const { return (t_s - from_s_) / span_s_ * width_px; }
    double timeAt(double x_px, double width_px) const { return from_s_ + x_px / width_px * span_s_; }

    /// Kept within the take and no shorter than kShortest_s.
    void show(double from_s, double to_s);
    void showAll();
    static constexpr double kNotch = 1.25;  ///< factor of zoom() of one notch of a wheel, one press of a key
    static constexpr double kOutside = 0.45;  ///< opacity of what lies outside of the marked range
    /// factor > 1: closer; the time stays where it is on the screen.
    void zoom(double factor, double around_s);
    void pan(double seconds);
    /// Turns the page when the time is not shown.
    void reveal(double t_s);

    static constexpr double kShortest_s = 0.002;

signals:
    void changed();

private:
    double duration() const;

    TimeCursor& cursor_;
    double from_s_ = 0, span_s_ = 1;
};

}  // namespace noctule::ui
