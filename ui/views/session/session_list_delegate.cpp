// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/session/session_list.h"

namespace noctule::ui {
namespace {

constexpr int kSessionRow = 76, kPictureWidth = 84, kPictureHeight = 62, kSessionInset = 8, kSessionGap = 16;
constexpr int kDateWidth = 104, kStateWidth = 172, kPerformerWidth = 128, kLeastNameWidth = 180;

/// Two lines of text, one above the other, centred in height.
struct TwoLines {
    QString first, second;
    QFont first_font, second_font;
    QColor first_color, second_color;
    QString icon;  ///< in front of the second line
    Qt::TextElideMode second_elide = Qt::ElideRight;
};

void paintLine(QPainter& painter, const QRect& area, const QString& text, const QFont& font,
               const QColor& color, Qt::TextElideMode elide, Qt::Alignment alignment) {
    painter.setFont(font);
    painter.setPen(color);
    painter.drawText(area, static_cast<int>(alignment | Qt::AlignVCenter),
                     QFontMetrics(font).elidedText(text, elide, area.width()));
}

void paintLines(QPainter& painter, const QRect& area, const TwoLines& lines) {
    if (area.isEmpty())
        return;  // no room for this column
    const Theme& theme = Theme::get();
    const int first = QFontMetrics(lines.first_font).height(),
              second = QFontMetrics(lines.second_font).height();
    const bool two = !lines.second.isEmpty() && !lines.first.isEmpty();
    const int gap = two ? theme.px(4) : 0;
    int top = area.center().y() -
              ((lines.first.isEmpty() ? 0 : first) + gap + (lines.second.isEmpty() ? 0 : second)) / 2;
    if (!lines.first.isEmpty()) {
        paintLine(painter, QRect(area.left(), top, area.width(), first), lines.first, lines.first_font,
                  lines.first_color, Qt::ElideRight, Qt::AlignLeft);
        top += first + gap;
    }
    int left = area.left();
    if (!lines.icon.isEmpty() && !lines.second.isEmpty()) {
        const int size = theme.px(12);
        painter.drawPixmap(left, top + (second - size) / 2,
                           theme.pixmap(lines.icon, size, lines.second_color));
        left += size + theme.px(5);
    }
    paintLine(painter, QRect(left, top, area.right() - left + 1, second), lines.second, lines.second_font,
              lines.second_color, lines.second_elide, Qt::AlignLeft);
}

void paintPicture(QPainter& painter, const QRect& area, const QImage& picture) {
    const Theme& theme = Theme::get();
    QPainterPath frame;
    frame.addRoundedRect(area, theme.px(4), theme.px(4));
    painter.save();
    painter.setClipPath(frame);
    painter.fillRect(area, theme.tokens().view);
    if (picture.isNull()) {
        const int size = theme.px(24);
        painter.drawPixmap(area.center().x() - size / 2, area.center().y() - size / 2,
                           theme.pixmap("body", size, theme.tokens().t3));
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        const QSize size = picture.size().scaled(area.size(), Qt::KeepAspectRatioByExpanding);
        QRect target(QPoint(), size);
        target.moveCenter(area.center());
        painter.drawImage(target, picture);
    }
    painter.restore();
}

QColor rowColor(const QStyleOptionViewItem& option) {
    const Tokens& tokens = Theme::get().tokens();
    if (option.state & QStyle::State_Selected)
        return tokens.sel;
    return option.state & QStyle::State_MouseOver ? tokens.ctl : tokens.raised;
}

/// Columns from the right to the left, as many as there is room for.
class Columns {
public:
    explicit Columns(const QRect& row) : row_(row) {}
    QRect fromRight(int width_at_100, int least_rest) {
        const int width = Theme::get().px(width_at_100);
        if (row_.width() - width < Theme::get().px(least_rest))
            return {};
        const QRect column(row_.right() - width + 1, row_.top(), width, row_.height());
        row_.setRight(column.left() - Theme::get().px(kSessionGap));
        return column;
    }
    QRect rest() const { return row_; }

private:
    QRect row_;
};

}  // namespace

QSize RecentSessionDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const {
    return {Theme::get().px(kPictureWidth + kLeastNameWidth), Theme::get().px(kSessionRow)};
}

void RecentSessionDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                                  const QModelIndex& index) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const auto* list = qobject_cast<const SessionList*>(option.widget);
    const auto* filter = qobject_cast<const QSortFilterProxyModel*>(index.model());
    if (!list || !filter)
        return;
    const auto* model = qobject_cast<const RecentSessionModel*>(filter->sourceModel());
    const RecentSession& session = model->at(filter->mapToSource(index).row());
    const SessionStateWords words = stateWords(session);

    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->fillRect(option.rect, rowColor(option));
    if (index.row() + 1 < filter->rowCount())
        painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1),
                          tokens.line);
    const QRect inner = option.rect.adjusted(theme.px(kSessionInset), 0, -theme.px(kSessionGap), 0);
    const QRect picture(inner.left(), inner.center().y() - theme.px(kPictureHeight) / 2,
                        theme.px(kPictureWidth), theme.px(kPictureHeight));
    paintPicture(*painter, picture, index.data(RecentSessionModel::kPicture).value<QImage>());

    Columns columns(QRect(QPoint(picture.right() + theme.px(kSessionGap), inner.top()), inner.bottomRight()));
    const QFont body = theme.font(TextRole::kBody), small = theme.font(TextRole::kSecondary);
    const QRect date = columns.fromRight(kDateWidth, kLeastNameWidth);
    paintLine(*painter, date, dateText(session.opened), small, tokens.t2, Qt::ElideRight, Qt::AlignRight);
    const QRect state = columns.fromRight(kStateWidth, kLeastNameWidth);
    paintLines(*painter, state,
               {words.takes, words.state, body, small, tokens.t1,
                words.tone == Tone::kNeutral ? tokens.t3 : colorOf(words.tone), iconOf(words.tone)});
    const QRect performer = columns.fromRight(kPerformerWidth, kLeastNameWidth);
    paintLine(*painter, performer, session.performer, body, tokens.t2, Qt::ElideRight, Qt::AlignLeft);
    paintLines(*painter, columns.rest(),
               {session.name,
                QDir::toNativeSeparators(session.folder),
                theme.font(TextRole::kSection, true),
                small,
                tokens.t1,
                tokens.t3,
                {},
                Qt::ElideMiddle});
    if (option.state & QStyle::State_HasFocus) {
        painter->setBrush(Qt::NoBrush);
        painter->setPen(QPen(tokens.acc, 2));
        painter->drawRoundedRect(QRectF(option.rect).adjusted(1, 1, -1, -2), theme.px(4), theme.px(4));
    }
    painter->restore();
}

}  // namespace noctule::ui
