// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/error_plot.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr int kErrorRow = 20, kNames = 130, kFoot = 26;

/// 1, 2 or 5 times a power of ten that is not below.
double roundUp(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0, 10.0})
        if (value <= step * power * (1 + 1e-9))
            return step * power;
    return value;
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
    setAccessibleName(QString::fromStdString(errors.title));
    updateGeometry();
    update();
}

QSize ErrorPlot::sizeHint() const {
    const int rows = std::max(1, static_cast<int>(errors_.rows.size()));
    return QSize(Theme::get().px(400), Theme::get().px(rows * kErrorRow + kFoot));
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

void ErrorPlot::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int row = theme.px(kErrorRow), left = theme.px(kNames),
              rows = static_cast<int>(errors_.rows.size());
    const int right = width() - theme.px(16), bottom = rows * row;
    const double end = scaleEnd(), scale = (right - left) / end;
    QColor good = tokens.okbg;
    painter.fillRect(QRectF(left, 0, errors_.good * scale, bottom), good);
    painter.setFont(theme.font(TextRole::kCaption));
    for (int tick = 0; tick <= 4; ++tick) {
        const double x = left + (right - left) * tick / 4.0;
        painter.setPen(tokens.line);
        painter.drawLine(QPointF(x, 0), QPointF(x, bottom));
        painter.setPen(tokens.t3);
        const QString unit = tick == 4 ? ' ' + QString::fromStdString(errors_.unit) : QString();
        const int decimals = std::clamp(static_cast<int>(1 - std::floor(std::log10(end))), 0, 4);
        painter.drawText(
            QRectF(x - theme.px(50), bottom + theme.px(4), theme.px(tick == 4 ? 66 : 100), theme.px(18)),
            tick == 4 ? Qt::AlignRight : Qt::AlignHCenter, numberText(end * tick / 4, decimals) + unit);
    }
    const auto dots = [&](const std::vector<double>& values, double y, const QColor& color) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        for (const double value : values) {
            const bool beyond = value > end && color == tokens.acc;
            const double x = left + std::min(value, end) * scale;
            if (beyond) {
                painter.setPen(QPen(tokens.warn, theme.px(1.5)));
                painter.setBrush(Qt::NoBrush);
            }
            painter.drawEllipse(QPointF(x, y), theme.px(3), theme.px(3));
            if (beyond) {
                painter.setPen(Qt::NoPen);
                painter.setBrush(color);
            }
        }
    };
    for (int i = 0; i < rows; ++i) {
        const CalibrationErrors::Row& part = errors_.rows[static_cast<size_t>(i)];
        const double middle = (i + 0.5) * row;
        painter.setPen(tokens.t1);
        painter.setFont(theme.font(TextRole::kSecondary));
        painter.drawText(QRectF(0, i * row, left - theme.px(8), row), Qt::AlignRight | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(QString::fromStdString(part.name), Qt::ElideRight,
                                                          left - theme.px(8)));
        QColor before = tokens.t3;
        before.setAlphaF(0.45);
        dots(part.before, middle, before);
        dots(part.after, middle, tokens.acc);
    }
}

}  // namespace noctule::ui
