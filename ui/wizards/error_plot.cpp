// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/error_plot.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/language/core_words.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr int kTicks = 4;
constexpr int kErrorRow = 20, kFoot = 26, kNameGap = 8;
constexpr double kMostNames = 0.45;  ///< of the width

/// 1, 2 or 5 times a power of ten that is not below.
double roundUp(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0, 10.0})
        if (value <= step * power * (1 + 1e-9))
            return step * power;
    return value;
}

/// As many as it takes to write the step of the ticks: 2.5 has one.
int decimalsOf(double step) {
    int decimals = 0;
    for (double scaled = step; decimals < 6 && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled;
         scaled *= 10)
        ++decimals;
    return decimals;
}

}  // namespace

ErrorPlot::ErrorPlot(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
}

void ErrorPlot::setErrors(const CalibrationErrors& errors) {
    errors_ = errors;
    setAccessibleName(coreWords(errors.title));
    updateGeometry();
    update();
}

QSize ErrorPlot::sizeHint() const {
    const int rows = std::max(1, static_cast<int>(errors_.rows.size()));
    return QSize(Theme::get().px(320), Theme::get().px(rows * kErrorRow + kFoot));
}

/// Wide enough for all that is good and for nineteen of twenty of the errors; what was before may lie beyond.
double ErrorPlot::scaleEnd() const {
    std::vector<double> values;
    for (const CalibrationErrors::Row& row : errors_.rows)
        values.insert(values.end(), row.after.begin(), row.after.end());
    std::ranges::sort(values);
    const double most =
        values.empty()
            ? 0
            : values[static_cast<size_t>(std::floor(0.95 * static_cast<double>(values.size() - 1)))];
    return roundUp(std::max({most, errors_.good * 2, 1e-9}));
}

bool ErrorPlot::hasBeyondScale() const {
    const double end = scaleEnd();
    return std::ranges::any_of(errors_.rows, [end](const CalibrationErrors::Row& row) {
        const auto is_beyond = [end](double value) { return value > end; };
        return std::ranges::any_of(row.before, is_beyond) || std::ranges::any_of(row.after, is_beyond);
    });
}

ErrorPlot::Axis ErrorPlot::axis() const {
    const Theme& theme = Theme::get();
    const QFontMetrics metrics(theme.font(TextRole::kSecondary));
    int names = 0;
    for (const CalibrationErrors::Row& row : errors_.rows)
        names = std::max(names, metrics.horizontalAdvance(coreWords(row.name)));
    const int left = std::min(names + 1, static_cast<int>(kMostNames * width())) + theme.px(kNameGap),
              right = width() - theme.px(16);
    return {left, right, static_cast<int>(errors_.rows.size()) * theme.px(kErrorRow), scaleEnd()};
}

void ErrorPlot::paintAxis(QPainter& painter, const Axis& axis) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    painter.fillRect(QRectF(axis.left, 0, axis.at(errors_.good) - axis.left, axis.bottom), tokens.okbg);
    painter.setFont(theme.font(TextRole::kCaption));
    const int decimals = decimalsOf(axis.end / kTicks);
    for (int tick = 0; tick <= kTicks; ++tick) {
        const double value = axis.end * tick / kTicks, x = axis.at(value);
        const bool last = tick == kTicks;
        painter.setPen(tokens.line);
        painter.drawLine(QPointF(x, 0), QPointF(x, axis.bottom));
        painter.setPen(tokens.t3);
        const QString unit = last ? ' ' + coreWords(errors_.unit) : QString();
        painter.drawText(
            QRectF(x - theme.px(50), axis.bottom + theme.px(4), theme.px(last ? 66 : 100), theme.px(18)),
            last ? Qt::AlignRight : Qt::AlignHCenter, numberText(value, decimals) + unit);
    }
}

/// What lies beyond the axis is a triangle at its end.
void ErrorPlot::paintDots(QPainter& painter, const Axis& axis, const std::vector<double>& values, double y,
                          const QColor& color) const {
    const Theme& theme = Theme::get();
    for (const double value : values) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        const double size = theme.px(3), end = axis.at(axis.end);
        const std::array<QPointF, 3> beyond{QPointF(end, y - 1.5 * size), QPointF(end + 2.5 * size, y),
                                            QPointF(end, y + 1.5 * size)};
        if (value > axis.end)
            painter.drawPolygon(beyond.data(), static_cast<int>(beyond.size()));
        else
            painter.drawEllipse(QPointF(axis.at(value), y), size, size);
    }
}

void ErrorPlot::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Axis axis = this->axis();
    paintAxis(painter, axis);
    QColor before = tokens.t3;
    before.setAlphaF(0.45);
    const int row = theme.px(kErrorRow), names = axis.left - theme.px(kNameGap);
    painter.setFont(theme.font(TextRole::kSecondary));
    for (size_t i = 0; i < errors_.rows.size(); ++i) {
        const CalibrationErrors::Row& part = errors_.rows[i];
        const double top = static_cast<double>(i) * row, middle = top + row / 2.0;
        painter.setPen(tokens.t1);
        painter.drawText(QRectF(0, top, names, row), Qt::AlignRight | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(coreWords(part.name), Qt::ElideRight, names));
        paintDots(painter, axis, part.before, middle, before);
        paintDots(painter, axis, part.after, middle, tokens.acc);
    }
}

}  // namespace noctule::ui
