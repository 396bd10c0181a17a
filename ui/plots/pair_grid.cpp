// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/pair_grid.h"

#include <QFontMetrics>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/plots/pair_grid_accessible.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

// Pixels at 100 percent.
constexpr double kGap = 2, kRadius = 2, kHeadings = 22, kGroups = 30, kBesideRows = 8, kRing = 2;
constexpr double kUsualCell = 26, kLeastCellWidth = 14, kLeastCellHeight = 12;

bool walksCells(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down ||
           key == Qt::Key_Home || key == Qt::Key_End;
}

}  // namespace

PairGrid::PairGrid(QWidget* parent) : QWidget(parent) {
    PairGridAccessible::install();
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Confidence per pair"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
}

void PairGrid::setContent(PairGridContent content) {
    content_ = std::move(content);
    if (row_ >= rowCount() || column_ >= columnCount())
        row_ = column_ = -1;
    PairGridAccessible::contentChanged(*this);
    updateGeometry();
    update();
}

void PairGrid::setCurrent(int row, int column) {
    const bool exists = row >= 0 && row < rowCount() && column >= 0 && column < columnCount();
    if (!exists)
        row = column = -1;
    if (row == row_ && column == column_)
        return;
    row_ = row, column_ = column;
    PairGridAccessible::currentChanged(*this);
    update();
}

void PairGrid::choose(int row, int column) {
    setCurrent(row, column);
    emit chosen(row_, column_);
}

int PairGrid::edgeWidth(bool notes) const {
    const QFontMetrics metrics(Theme::get().font(TextRole::kSecondary, true));
    int width = 0;
    if (notes)
        for (const QString& note : content_.row_notes)
            width = std::max(width, metrics.horizontalAdvance(note));
    else
        for (const PairHeading& heading : content_.rows)
            width = std::max(width, metrics.horizontalAdvance(heading.text));
    return width > 0 ? width + Theme::get().px(kBesideRows) : Theme::get().px(kRing);
}

PairGrid::Frame PairGrid::frame() const {
    const Theme& theme = Theme::get();
    Frame frame;
    frame.headings_height = theme.px(kHeadings);
    frame.gap = theme.px(kGap);
    const int left = edgeWidth(false), right = std::max(edgeWidth(true), theme.px(2 * kRing));
    const int bottom = content_.groups.empty() ? theme.px(2 * kRing) : theme.px(kGroups);
    frame.cells = QRectF(left, frame.headings_height, std::max(1, width() - left - right),
                         std::max(1, height() - frame.headings_height - bottom));
    frame.cell_width = frame.cells.width() / std::max(1, columnCount());
    frame.cell_height = frame.cells.height() / std::max(1, rowCount());
    return frame;
}

QRect PairGrid::Frame::cell(int row, int column) const {
    const int left = qRound(cells.left() + column * cell_width);
    const int top = qRound(cells.top() + row * cell_height);
    const int right = qRound(cells.left() + (column + 1) * cell_width);
    const int bottom = qRound(cells.top() + (row + 1) * cell_height);
    return {left, top, std::max(1, right - left - gap), std::max(1, bottom - top - gap)};
}

QRect PairGrid::cellRect(int row, int column) const {
    return frame().cell(row, column);
}

QPoint PairGrid::cellAt(const QPoint& position) const {
    const Frame f = frame();
    if (content_.cells.empty() || !f.cells.contains(position))
        return {-1, -1};
    const int column = static_cast<int>((position.x() - f.cells.left()) / f.cell_width);
    const int row = static_cast<int>((position.y() - f.cells.top()) / f.cell_height);
    return {std::min(column, columnCount() - 1), std::min(row, rowCount() - 1)};
}

QSize PairGrid::sizeHint() const {
    const Theme& theme = Theme::get();
    return {edgeWidth(false) + edgeWidth(true) + std::max(1, columnCount()) * theme.px(kUsualCell),
            theme.px(kHeadings + kGroups) + std::max(1, rowCount()) * theme.px(kUsualCell)};
}

QSize PairGrid::minimumSizeHint() const {
    const Theme& theme = Theme::get();
    return {edgeWidth(false) + edgeWidth(true) + columnCount() * theme.px(kLeastCellWidth),
            theme.px(kHeadings + kGroups) + rowCount() * theme.px(kLeastCellHeight)};
}

void PairGrid::keyPressEvent(QKeyEvent* event) {
    if (content_.cells.empty() || !walksCells(event->key())) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (row_ < 0) {
        choose(0, 0);
        return;
    }
    int row = row_, column = column_;
    const bool whole = event->modifiers() & Qt::ControlModifier;
    switch (event->key()) {
        case Qt::Key_Left:
            column = std::max(0, column - 1);
            break;
        case Qt::Key_Right:
            column = std::min(columnCount() - 1, column + 1);
            break;
        case Qt::Key_Up:
            row = std::max(0, row - 1);
            break;
        case Qt::Key_Down:
            row = std::min(rowCount() - 1, row + 1);
            break;
        case Qt::Key_Home:
            column = 0;
            row = whole ? 0 : row;
            break;
        default:
            column = columnCount() - 1;
            row = whole ? rowCount() - 1 : row;
    }
    choose(row, column);
}

void PairGrid::mousePressEvent(QMouseEvent* event) {
    const QPoint cell = cellAt(event->pos());
    if (event->button() == Qt::LeftButton && cell.x() >= 0)
        choose(cell.y(), cell.x());
}

void PairGrid::mouseMoveEvent(QMouseEvent* event) {
    const QPoint cell = cellAt(event->pos());
    if ((event->buttons() & Qt::LeftButton) && cell.x() >= 0 && cell != QPoint(column_, row_))
        choose(cell.y(), cell.x());
}

bool PairGrid::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && walksCells(static_cast<QKeyEvent*>(event)->key())) {
        event->accept();  // else the arrows would step frames
        return true;
    }
    if (event->type() == QEvent::ToolTip) {
        auto* help = static_cast<QHelpEvent*>(event);
        const QPoint cell = cellAt(help->pos());
        if (cell.x() >= 0)
            QToolTip::showText(help->globalPos(), content_.cell(cell.y(), cell.x()).words, this,
                               cellRect(cell.y(), cell.x()));
        else
            QToolTip::hideText();
        return true;
    }
    return QWidget::event(event);
}

void PairGrid::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (content_.cells.empty())
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    const Frame f = frame();
    paintCells(painter, f);
    paintHeadings(painter, f);
    paintGroups(painter, f);
    if (row_ >= 0)
        paintCurrent(painter, f);
}

void PairGrid::paintCells(QPainter& painter, const Frame& frame) const {
    const Theme& theme = Theme::get();
    const double radius = theme.px(kRadius);
    for (int row = 0; row < rowCount(); ++row)
        for (int column = 0; column < columnCount(); ++column) {
            const PairCell& cell = content_.cell(row, column);
            const QRectF rect = frame.cell(row, column);
            if (cell.state == PairCell::State::kHeard) {
                painter.setPen(Qt::NoPen);
                painter.setBrush(theme.confidence(cell.confidence));
                painter.drawRoundedRect(rect, radius, radius);
                continue;
            }
            const bool lost = cell.state == PairCell::State::kLost;
            painter.setPen(QPen(lost ? theme.tokens().err : theme.tokens().edge, 1, Qt::DotLine));
            painter.setBrush(Qt::NoBrush);
            painter.drawRoundedRect(rect.adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
        }
}

void PairGrid::paintCurrent(QPainter& painter, const Frame& frame) const {
    const Theme& theme = Theme::get();
    const double ring = theme.px(kRing);
    const QRectF rect = frame.cell(row_, column_);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.tokens().panel, 2 * ring));
    painter.drawRoundedRect(rect, ring, ring);
    painter.setPen(QPen(theme.tokens().acc, ring));
    painter.drawRoundedRect(rect.adjusted(-ring / 2, -ring / 2, ring / 2, ring / 2), ring, ring);
}

void PairGrid::paintHeadings(QPainter& painter, const Frame& frame) const {
    const Theme& theme = Theme::get();
    const auto ink = [&](const PairHeading& heading, bool current) {
        painter.setFont(theme.font(TextRole::kSecondary, current));
        painter.setPen(heading.attention ? theme.tokens().warn
                                         : (current ? theme.tokens().t1 : theme.tokens().t2));
    };
    const int beside = theme.px(kBesideRows);
    const QFontMetrics metrics(theme.font(TextRole::kSecondary, true));
    const int each_row = std::max(1, static_cast<int>(std::ceil(metrics.ascent() / frame.cell_height)));
    for (int row = 0; row < rowCount(); ++row) {
        if (row % each_row != 0)
            continue;
        const auto index = static_cast<size_t>(row);
        const int spare = std::max(0, metrics.height() - frame.cell(row, 0).height());
        const QRect cell = frame.cell(row, 0).adjusted(0, -spare, 0, spare);
        ink(content_.rows[index], row == row_);
        painter.drawText(QRect(0, cell.top(), cell.left() - beside, cell.height()),
                         Qt::AlignRight | Qt::AlignVCenter, content_.rows[index].text);
        if (index < content_.row_notes.size()) {
            const int left = qRound(frame.cells.right()) + beside;
            painter.drawText(QRect(left, cell.top(), width() - left, cell.height()),
                             Qt::AlignLeft | Qt::AlignVCenter, content_.row_notes[index]);
        }
    }
    const double widest = metrics.horizontalAdvance(QStringLiteral("00")) + theme.px(4);
    const int every = std::max(1, static_cast<int>(std::ceil(widest / frame.cell_width)));
    for (int column = 0; column < columnCount(); ++column) {
        const PairHeading& heading = content_.columns[static_cast<size_t>(column)];
        const bool current = column == column_;
        if (column % every != 0 && !current)
            continue;
        ink(heading, current);
        const QRect cell = frame.cell(0, column);
        const int spare = static_cast<int>(widest);
        painter.drawText(QRect(cell.left() - spare, 0, cell.width() + 2 * spare, frame.headings_height),
                         Qt::AlignHCenter | Qt::AlignVCenter, heading.text);
    }
}

void PairGrid::paintGroups(QPainter& painter, const Frame& frame) const {
    const Theme& theme = Theme::get();
    painter.setFont(theme.font(TextRole::kCaption));
    const QFontMetrics metrics = painter.fontMetrics();
    const int y = qRound(frame.cells.bottom()) + theme.px(5);
    for (const PairColumnGroup& group : content_.groups) {
        const int left = frame.cell(0, group.first).left(), right = frame.cell(0, group.last).right() + 1;
        painter.fillRect(QRect(left, y, right - left, theme.px(1)), theme.tokens().edge);
        painter.setPen(theme.tokens().t2);
        painter.drawText(QRect(left, y + theme.px(4), right - left, height() - y - theme.px(4)),
                         Qt::AlignHCenter | Qt::AlignTop,
                         metrics.elidedText(group.name, Qt::ElideRight, right - left));
    }
}

}  // namespace noctule::ui
