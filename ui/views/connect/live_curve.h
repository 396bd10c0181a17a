// SPDX-License-Identifier: Apache-2.0
// The last five seconds of three axes, without a ruler: whether something moves and how much. The range is in
// the title beside it.
#pragma once

#include <QWidget>
#include <array>
#include <deque>
#include <optional>

namespace noctule::ui {

class LiveCurve : public QWidget {
    Q_OBJECT
public:
    static constexpr double kSpan_s = 5;

    /// `full_scale`: what reaches the upper edge.
    LiveCurve(const QString& name, double full_scale, QWidget* parent = nullptr);

    /// In order of time; one from before begins afresh. Absent axes leave a hole.
    void add(double t_s, const std::array<std::optional<double>, 3>& values);
    void clear();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Point {
        double t_s;
        std::array<std::optional<double>, 3> values;
    };
    std::deque<Point> points_;
    double full_scale_;
};

}  // namespace noctule::ui
