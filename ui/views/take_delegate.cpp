// SPDX-License-Identifier: Apache-2.0
#include "ui/views/take_delegate.h"

#include <QPainter>

#include "ui/style/theme.h"
#include "ui/views/take_list_model.h"
#include "ui/widgets/rating_stars.h"
#include "ui/widgets/status_dot.h"

namespace noctule::ui {
namespace {

constexpr int kInset = 12, kDot = 8, kTakeGap = 8;

QRect starsArea(const QRect& row) {
    const QSize stars = RatingStars::sizeOf();
    return {row.right() + 1 - Theme::get().px(kInset) - stars.width(),
            row.top() + (row.height() - stars.height()) / 2, stars.width(), stars.height()};
}

}  // namespace

QSize TakeDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const {
    return {0, Theme::get().px(kRow)};
}

QWidget* TakeDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                    const QModelIndex& index) const {
    QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
    editor->setAccessibleName(tr("Name of the take"));
    return editor;
}

void TakeDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                        const QModelIndex&) const {
    QRect area = option.rect;
    area.setLeft(area.left() + Theme::get().px(kInset + kDot));
    area.setRight(starsArea(option.rect).left() - Theme::get().px(kTakeGap));
    editor->setGeometry(area);
}

std::optional<int> TakeDelegate::ratingAt(const QRect& row, const QPoint& position) {
    const QRect stars = starsArea(row);
    if (!stars.contains(position))
        return std::nullopt;
    return RatingStars::ratingAt(position.x() - stars.left());
}

void TakeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const bool selected = option.state & QStyle::State_Selected;
    const bool open = index.data(TakeListModel::kOpen).toBool();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (selected)
        painter->fillRect(option.rect, tokens.sel);
    else if (option.state & QStyle::State_MouseOver)
        painter->fillRect(option.rect, tokens.ctl);

    const QRect& row = option.rect;
    const int inset = theme.px(kInset), dot = theme.px(kDot), gap = theme.px(kTakeGap);
    StatusDot::paint(*painter, QRect(row.left() + inset, row.top(), dot, row.height()),
                     static_cast<Tone>(index.data(TakeListModel::kTone).toInt()));

    const QRect stars = starsArea(row);
    const int rating = index.data(TakeListModel::kRating).toInt();
    RatingStars::paint(*painter, stars, rating, rating > 0 ? tokens.t2 : tokens.t3);

    QRect text(row.left() + inset + dot + gap, row.top(), 0, row.height());
    text.setRight(stars.left() - gap);
    const QString duration = index.data(TakeListModel::kDuration).toString();
    const QFont small = theme.font(TextRole::kSecondary), body = theme.font(TextRole::kBody, open);
    const int duration_width = QFontMetrics(small).horizontalAdvance(duration);
    const QFontMetrics metrics(body);
    const QString name = metrics.elidedText(index.data(TakeListModel::kName).toString(), Qt::ElideMiddle,
                                            std::max(0, text.width() - duration_width - gap));
    painter->setFont(body);
    painter->setPen(tokens.t1);
    painter->drawText(text, Qt::AlignVCenter, name);
    painter->setFont(small);
    painter->setPen(tokens.t3);
    painter->drawText(text.adjusted(metrics.horizontalAdvance(name) + gap, 0, 0, 0), Qt::AlignVCenter,
                      duration);
    painter->restore();
}

}  // namespace noctule::ui
