// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/board_table.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "ui/models/part_names.h"
#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr int kColumn = 23, kTilt = 44, kMostColumns = 8;

}  // namespace

BoardTable::BoardTable(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setAccessibleName(tr("Boards and their steps"));
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
}

void BoardTable::setRun(const WizardRun* run) {
    run_ = run;
    chosen_ = -1;
    if (!run)
        return;
    connect(run, &WizardRun::changed, this, &BoardTable::refresh);
    connect(run, &WizardRun::guided, this, &BoardTable::refresh);
    refresh();
}

void BoardTable::refresh() {
    if (known_boards_ != boards()) {
        known_boards_ = boards();
        updateGeometry();
    }
    update();
}

int BoardTable::boards() const {
    return run_ && run_->guide() ? static_cast<int>(run_->suit().boards.size()) : 0;
}

/// Many placements stand in one column: the rail has them all.
int BoardTable::stepColumns() const {
    return run_ && run_->stepCount() <= kMostColumns ? run_->stepCount() : 0;
}

int BoardTable::rowHeight() const {
    return Theme::get().px(28);
}

QSize BoardTable::sizeHint() const {
    return QSize(Theme::get().px(264), rowHeight() * (boards() + 1));
}

void BoardTable::choose(int board) {
    if (board == chosen_ || board >= boards())
        return;
    chosen_ = board;
    if (board >= 0)
        setAccessibleDescription(boardTitle(run_->suit(), board));
    update();
    emit boardChosen(board);
}

void BoardTable::mousePressEvent(QMouseEvent* event) {
    const int board = event->y() / rowHeight() - 1;
    choose(board == chosen_ ? -1 : board);
}

void BoardTable::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Down)
        choose(std::min(chosen_ + 1, boards() - 1));
    else if (event->key() == Qt::Key_Up)
        choose(std::max(chosen_ - 1, 0));
    else
        QWidget::keyPressEvent(event);
}

void BoardTable::paintBox(QPainter& painter, const QRect& cell, int board, int step) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const Guide& guide = *run_->guide();
    const int size = theme.px(12);
    const QRectF box(cell.center().x() - size / 2.0, cell.center().y() - size / 2.0, size, size);
    if (guide.isSkipped(board)) {
        painter.setPen(QPen(tokens.t3, theme.px(1.5)));
        painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
        return;
    }
    if (guide.isDone(step, board)) {
        noctule::ui::paintBox(painter, box, theme.px(3), tokens.ok);
        paintIcon(painter, box, "check", theme.px(10), tokens.bg);
        return;
    }
    const Guidance& now = guide.guidance();
    const bool is_now = step == run_->step() && !now.boards.empty();
    const GuidedBoard state = is_now ? now.boards[static_cast<size_t>(board)] : GuidedBoard::kMoves;
    const bool absent = is_now && state == GuidedBoard::kAbsent;
    const bool wrong =
        absent || (is_now && (state == GuidedBoard::kAskew || state == GuidedBoard::kElsewhere ||
                              state == GuidedBoard::kIdle));
    const QColor color = absent ? tokens.err : wrong ? tokens.warn : is_now ? tokens.acc : tokens.edge;
    noctule::ui::paintBox(painter, box, theme.px(3), QColor(), color);
    if (wrong)
        painter.fillRect(
            QRectF(box.center().x() - theme.px(1), box.top() + theme.px(3), theme.px(2), theme.px(6)), color);
    else if (is_now && state == GuidedBoard::kRight)
        painter.fillRect(box.adjusted(theme.px(4), theme.px(4), -theme.px(3), -theme.px(3)), color);
}

BoardTable::Columns BoardTable::placeColumns() const {
    const Theme& theme = Theme::get();
    const int left = theme.px(12), right = width() - theme.px(12), wide = theme.px(kColumn);
    return {left, right - theme.px(kTilt) - stepColumns() * wide, wide, right - theme.px(kTilt),
            theme.px(kTilt)};
}

void BoardTable::paintHead(QPainter& painter, const Columns& at) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const int row = rowHeight(), current = run_->step();
    if (stepColumns() > 1 && current < stepColumns())
        painter.fillRect(QRect(at.steps + current * at.step, 0, at.step, height()), tokens.sel);
    painter.setFont(theme.font(TextRole::kCaption));
    for (int step = 0; step < stepColumns(); ++step) {
        painter.setPen(step == current ? tokens.acc : tokens.t3);
        painter.drawText(QRect(at.steps + step * at.step, 0, at.step, row), Qt::AlignCenter,
                         QString::number(step + 1));
    }
    painter.setPen(tokens.t3);
    if (run_->task() == WizardTask::kAccelerometers)
        painter.drawText(QRect(at.tilt, 0, at.tilt_width, row), Qt::AlignRight | Qt::AlignVCenter,
                         tr("askew"));
}

void BoardTable::paintRow(QPainter& painter, const Columns& at, int board) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const Guidance& now = run_->guide()->guidance();
    const int row = rowHeight(), top = row * (board + 1);
    const auto index = static_cast<size_t>(board);
    const bool wrong = board == now.board && now.hindering > 0 && now.hindrance != Hindrance::kMoves;
    const bool absent = wrong && now.hindrance == Hindrance::kAbsent;
    const QColor ink = absent ? tokens.err : wrong ? tokens.warn : tokens.t1;
    if (board == chosen_)
        painter.fillRect(QRect(0, top, width(), row), tokens.sel);
    else if (wrong)
        painter.fillRect(QRect(0, top, width(), row), absent ? tokens.errbg : tokens.warnbg);
    painter.setFont(theme.font(TextRole::kSecondary, true));
    painter.setPen(ink);
    painter.drawText(QRect(at.left, top, theme.px(18), row), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(board + 1));
    painter.setFont(theme.font(TextRole::kSecondary));
    const QRect name(at.left + theme.px(27), top, at.steps - at.left - theme.px(31), row);
    painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(boardName(run_->suit().boards[index]), Qt::ElideRight,
                                                      name.width()));
    for (int step = 0; step < stepColumns(); ++step)
        paintBox(painter, QRect(at.steps + step * at.step, top, at.step, row), board, step);
    if (index < now.askew_rad.size() && now.askew_rad[index]) {
        painter.setPen(wrong ? ink : tokens.t2);
        painter.drawText(QRect(at.tilt, top, at.tilt_width, row), Qt::AlignRight | Qt::AlignVCenter,
                         degreesText(*now.askew_rad[index], 1));
    }
}

void BoardTable::paintEvent(QPaintEvent*) {
    if (boards() == 0)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Columns columns = placeColumns();
    paintHead(painter, columns);
    for (int board = 0; board < boards(); ++board)
        paintRow(painter, columns, board);
    if (!hasFocus())
        return;
    painter.setPen(QPen(Theme::get().tokens().acc, Theme::get().px(2)));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

}  // namespace noctule::ui
