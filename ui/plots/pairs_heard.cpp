// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/pairs_heard.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/accessible.h"

namespace noctule::ui {
namespace {

// Pixels at 100 percent.
constexpr double kNames = 24, kAxis = 20, kRowGap = 2, kUsualRow = 15, kLeastRow = 9, kLeastStrip = 120;

}  // namespace

PairsHeard::PairsHeard(QWidget* parent) : QWidget(parent) {
    describe(*this, {QAccessible::Graphic, {}, 0, 1, 0, {}, [this] {
                         QStringList rows;
                         for (int source = 0; source < rows_; ++source)
                             rows.append(words(source));
                         return rows.join(QStringLiteral(". "));
                     }});
    setAccessibleName(tr("Pairs heard over the last ten seconds"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
}

void PairsHeard::setHeard(const HeardWindow& heard, const QStringList& names) {
    names_ = names;
    rows_ = heard.sourceCount();
    steps_.assign(static_cast<size_t>(rows_),
                  std::vector<std::optional<float>>(static_cast<size_t>(heard.stepCount())));
    for (int source = 0; source < rows_; ++source)
        for (int step = 0; step < heard.stepCount(); ++step)
            if (const auto confidence = heard.confidence(source, step))
                steps_[static_cast<size_t>(source)][static_cast<size_t>(step)] =
                    static_cast<float>(*confidence);
    update();
}

void PairsHeard::clear() {
    rows_ = 0;
    steps_.clear();
    update();
}

QString PairsHeard::words(int source) const {
    if (source < 0 || source >= rows_ || source >= names_.size())
        return {};
    const auto& steps = steps_[static_cast<size_t>(source)];
    // The step that is just beginning may not have heard this source yet.
    for (size_t back = 1; back <= 4 && back <= steps.size(); ++back)
        if (const auto& heard = steps[steps.size() - back])
            return tr("%1: heard with confidence %2 now").arg(names_[source], numberText(*heard, 2));
    return tr("%1: not heard now").arg(names_[source]);
}

QRectF PairsHeard::area() const {
    const Theme& theme = Theme::get();
    return {1.0 * theme.px(kNames), 0, std::max(1.0, 1.0 * width() - theme.px(kNames)),
            std::max(1.0, 1.0 * height() - theme.px(kAxis))};
}

QRectF PairsHeard::rowRect(int source) const {
    const QRectF rows = area();
    const double height = rows.height() / std::max(1, rows_);
    return {rows.left(), rows.top() + source * height, rows.width(), height - Theme::get().px(kRowGap)};
}

QSize PairsHeard::sizeHint() const {
    const Theme& theme = Theme::get();
    return {theme.px(kNames) + theme.px(240), theme.px(kAxis) + std::max(8, rows_) * theme.px(kUsualRow)};
}

QSize PairsHeard::minimumSizeHint() const {
    const Theme& theme = Theme::get();
    return {theme.px(kNames) + theme.px(kLeastStrip), theme.px(kAxis) + rows_ * theme.px(kLeastRow)};
}

bool PairsHeard::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    auto* help = static_cast<QHelpEvent*>(event);
    const int source = rows_ == 0 ? -1 : static_cast<int>(help->pos().y() / (area().height() / rows_));
    if (const QString said = words(source); !said.isEmpty())
        QToolTip::showText(help->globalPos(), said, this, rowRect(source).toRect());
    else
        QToolTip::hideText();
    return true;
}

void PairsHeard::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    painter.setFont(theme.font(TextRole::kCaption));
    for (int source = 0; source < rows_; ++source) {
        const QRectF row = rowRect(source);
        painter.setPen(tokens.t2);
        painter.drawText(QRectF(0, row.top() - 2, row.left() - theme.px(6), row.height() + 4),
                         Qt::AlignRight | Qt::AlignVCenter, tr("S%1", "number of a source").arg(source + 1));
        painter.fillRect(row, tokens.ctl);
        const auto& steps = steps_[static_cast<size_t>(source)];
        const double width = row.width() / static_cast<double>(std::max<size_t>(1, steps.size()));
        for (size_t step = 0; step < steps.size(); ++step) {
            if (!steps[step])
                continue;
            const double left = qRound(row.left() + static_cast<double>(step) * width);
            const double right = qRound(row.left() + static_cast<double>(step + 1) * width);
            painter.fillRect(QRectF(left, row.top(), right - left, row.height()),
                             theme.confidence(*steps[step]));
        }
    }
    const QRectF axis(area().left(), area().bottom(), area().width(), theme.px(kAxis));
    painter.setPen(tokens.t3);
    painter.drawText(axis, Qt::AlignLeft | Qt::AlignVCenter, numberText(-10, 0) + QStringLiteral("\u00A0s"));
    painter.drawText(axis, Qt::AlignRight | Qt::AlignVCenter, tr("now"));
}

}  // namespace noctule::ui
