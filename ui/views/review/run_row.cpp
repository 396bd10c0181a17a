// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/run_row.h"

#include <QPainter>
#include <QStyleOption>

#include "ui/style/theme.h"

namespace noctule::ui {

namespace {
constexpr int kRunInset = 12, kRunBox = 16, kRunGap = 8, kRunRow = 46;
}

RunRow::RunRow(const QString& name, QWidget* parent) : QAbstractButton(parent) {
    setText(name);
    setCheckable(true);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

void RunRow::setState(const QString& number, const QString& detail) {
    number_ = number;
    detail_ = detail;
    setAccessibleName(tr("Result %1, %2, %3").arg(number, text(), detail));
    setToolTip(text() + '\n' + detail);
    update();
}

QSize RunRow::sizeHint() const {
    return {Theme::get().px(216), Theme::get().px(kRunRow)};
}

QSize RunRow::minimumSizeHint() const {
    return {Theme::get().px(120), Theme::get().px(kRunRow)};
}

void RunRow::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (underMouse())
        painter.fillRect(rect(), tokens.ctl);

    QStyleOptionButton box;
    box.initFrom(this);
    box.rect =
        QRect(theme.px(kRunInset), (height() - theme.px(kRunBox)) / 2, theme.px(kRunBox), theme.px(kRunBox));
    box.state |= isChecked() ? QStyle::State_On : QStyle::State_Off;
    box.state &= ~QStyle::State_HasFocus;
    style()->drawPrimitive(QStyle::PE_IndicatorCheckBox, &box, &painter, this);

    const int left = box.rect.right() + 1 + theme.px(kRunGap),
              width = this->width() - left - theme.px(kRunInset);
    const QFont name = theme.font(TextRole::kBody, isChecked()), small = theme.font(TextRole::kSecondary);
    const QFontMetrics name_metrics(name), small_metrics(small);
    const int top = (height() - name_metrics.height() - small_metrics.height()) / 2;
    const int number_width = name_metrics.horizontalAdvance(number_) + theme.px(6);
    painter.setFont(name);
    painter.setPen(isChecked() ? tokens.acc : tokens.t3);
    painter.drawText(left, top + name_metrics.ascent(), number_);
    painter.setPen(tokens.t1);
    painter.drawText(left + number_width, top + name_metrics.ascent(),
                     name_metrics.elidedText(text(), Qt::ElideRight, width - number_width));
    painter.setFont(small);
    painter.setPen(tokens.t3);
    painter.drawText(left, top + name_metrics.height() + small_metrics.ascent(),
                     small_metrics.elidedText(detail_, Qt::ElideRight, width));
}

}  // namespace noctule::ui
