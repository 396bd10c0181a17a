// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/level_meters.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/accessible.h"

namespace noctule::ui {
namespace {

// Pixels at 100 percent.
constexpr double kScaleWidth = 36, kNumbers = 18, kGroupNames = 20, kTop = 7, kSound = 14, kMotion = 4,
                 kBarGap = 2;
constexpr double kGrid_db = 12, kLeastColumn = 16, kUsualHeight = 118, kLeastHeight = 72;

QString decibelsText(double db) {
    return QStringLiteral("%1 dB").arg(numberText(db, 0));
}

}  // namespace

LevelMeters::LevelMeters(QWidget* parent) : QWidget(parent) {
    describe(*this, {QAccessible::Graphic, {}, 0, 1, 0, {}, [this] { return summary(); }});
    setAccessibleName(tr("Levels of the boards"));
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
}

void LevelMeters::setGroups(std::vector<PairColumnGroup> groups) {
    groups_ = std::move(groups);
    update();
}

void LevelMeters::setLevels(std::vector<BoardLevel> levels) {
    levels_ = std::move(levels);
    if (current_ >= count())
        current_ = -1;
    update();
}

void LevelMeters::setCurrent(int board) {
    const int now = board >= 0 && board < count() ? board : -1;
    if (now == current_)
        return;
    current_ = now;
    update();
}

void LevelMeters::choose(int board) {
    setCurrent(board);
    emit chosen(current_);
}

QString LevelMeters::words(int board) const {
    if (board < 0 || board >= count())
        return {};
    const BoardLevel& level = levels_[static_cast<size_t>(board)];
    if (level.silent)
        return tr("%1: silent").arg(level.name);
    const QString sound = tr("%1: sound %2, peak %3")
                              .arg(level.name, decibelsText(level.sound_db), decibelsText(level.peak_db));
    return level.motion_db ? tr("%1, motion %2", "sound of a board, its motion")
                                 .arg(sound, decibelsText(*level.motion_db))
                           : sound;
}

QString LevelMeters::summary() const {
    return current_ >= 0 ? words(current_) : tr("%n board(s)", nullptr, count());
}

QRectF LevelMeters::area() const {
    const Theme& theme = Theme::get();
    const double left = theme.px(kScaleWidth), top = theme.px(kTop);
    const double below = theme.px(kNumbers) + (groups_.empty() ? 0 : theme.px(kGroupNames));
    return {left, top, std::max(1.0, width() - left), std::max(1.0, height() - top - below)};
}

double LevelMeters::y(double db) const {
    const QRectF meters = area();
    return meters.top() + meters.height() * std::clamp(db / kLowest_db, 0.0, 1.0);
}

QRect LevelMeters::meterRect(int board) const {
    const QRectF meters = area();
    const double column = meters.width() / std::max(1, count());
    const int left = qRound(meters.left() + board * column);
    const int right = qRound(meters.left() + (board + 1) * column);
    return {left, qRound(meters.top()), right - left, qRound(meters.height())};
}

int LevelMeters::boardAt(const QPoint& position) const {
    for (int board = 0; board < count(); ++board)
        if (const QRect meter = meterRect(board);
            position.x() >= meter.left() && position.x() <= meter.right())
            return board;
    return -1;
}

QSize LevelMeters::sizeHint() const {
    const Theme& theme = Theme::get();
    return {theme.px(kScaleWidth) + std::max(1, count()) * theme.px(30), theme.px(kUsualHeight)};
}

QSize LevelMeters::minimumSizeHint() const {
    const Theme& theme = Theme::get();
    return {theme.px(kScaleWidth) + count() * theme.px(kLeastColumn), theme.px(kLeastHeight)};
}

void LevelMeters::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        choose(boardAt(event->pos()));
}

void LevelMeters::keyPressEvent(QKeyEvent* event) {
    const int step = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
    if (step == 0 || count() == 0)
        return QWidget::keyPressEvent(event);
    choose(current_ < 0 ? 0 : std::clamp(current_ + step, 0, count() - 1));
    tellValueChanged(*this, current_);
}

bool LevelMeters::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    auto* help = static_cast<QHelpEvent*>(event);
    const int board = boardAt(help->pos());
    if (board >= 0)
        QToolTip::showText(help->globalPos(), words(board), this, meterRect(board));
    else
        QToolTip::hideText();
    return true;
}

void LevelMeters::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintScale(painter);
    for (int board = 0; board < count(); ++board)
        paintBoard(painter, board);
    paintNumbers(painter);
    paintGroups(painter);
}

void LevelMeters::paintScale(QPainter& painter) const {
    const Theme& theme = Theme::get();
    painter.setFont(theme.font(TextRole::kCaption));
    const int half = QFontMetrics(painter.font()).height() / 2;
    for (double db = 0; db > kLowest_db; db -= kGrid_db) {
        const int at = qRound(y(db));
        painter.fillRect(QRectF(area().left(), at, area().width(), 1), theme.tokens().line);
        painter.setPen(theme.tokens().t3);
        painter.drawText(QRect(0, at - half, theme.px(kScaleWidth - 8), 2 * half),
                         Qt::AlignRight | Qt::AlignVCenter, numberText(db, 0));
    }
}

void LevelMeters::paintBoard(QPainter& painter, int board) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const BoardLevel& level = levels_[static_cast<size_t>(board)];
    const QRectF column = meterRect(board);
    const double room = column.width() - theme.px(kBarGap);
    const double gap = std::min<double>(theme.px(kBarGap), room / 6);
    const double thin = std::min<double>(theme.px(kMotion), room / 4);
    const double wide = std::min<double>(theme.px(kSound), room - thin - gap);
    const double left = column.left() + (column.width() - wide - gap - thin) / 2;
    const auto bar = [&](double x, double width, double from, double to, const QColor& color) {
        if (to - from >= 1)
            paintBox(painter, QRectF(x, from, width, to - from), std::min(2.0, width / 2), color);
    };
    if (level.silent) {
        painter.setPen(QPen(tokens.err, 1, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(left + 0.5, column.top() + 0.5, wide, column.height() - 1));
        return;
    }
    bar(left, wide, column.top(), column.bottom(), tokens.ctl);
    bar(left + wide + gap, thin, column.top(), column.bottom(), tokens.ctl);
    const QColor color = level.clips ? tokens.warn : tokens.ok;
    bar(left, wide, y(level.sound_db), column.bottom(), mixed(color, tokens.panel, 0.15));
    if (level.peak_db > kLowest_db)
        painter.fillRect(QRectF(left, qRound(y(level.peak_db)), wide, theme.px(2)), color);
    if (level.motion_db)
        bar(left + wide + gap, thin, y(*level.motion_db), column.bottom(), tokens.acc);
}

void LevelMeters::paintNumbers(QPainter& painter) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    for (int board = 0; board < count(); ++board) {
        const BoardLevel& level = levels_[static_cast<size_t>(board)];
        QRect below = meterRect(board);
        below.moveTop(below.bottom() + 1);
        below.setHeight(theme.px(kNumbers));
        if (board == current_)
            paintBox(painter, below.adjusted(1, 1, -1, -1), theme.px(4), tokens.sel);
        painter.setFont(theme.font(TextRole::kSecondary, board == current_ || level.clips || level.silent));
        painter.setPen(level.silent        ? tokens.err
                       : level.clips       ? tokens.warn
                       : board == current_ ? tokens.t1
                                           : tokens.t2);
        painter.drawText(below, Qt::AlignCenter, QString::number(board + 1));
    }
}

void LevelMeters::paintGroups(QPainter& painter) const {
    const Theme& theme = Theme::get();
    painter.setFont(theme.font(TextRole::kCaption));
    const QFontMetrics metrics = painter.fontMetrics();
    const int top = qRound(area().bottom()) + theme.px(kNumbers);
    for (const PairColumnGroup& group : groups_) {
        if (group.last >= count())
            continue;
        const int inset = theme.px(3);
        const int left = meterRect(group.first).left() + inset, right = meterRect(group.last).right() - inset;
        painter.fillRect(QRect(left, top + 1, right - left, 1), theme.tokens().edge);
        painter.setPen(theme.tokens().t2);
        painter.drawText(QRect(left, top + 2, right - left, theme.px(kGroupNames) - 2), Qt::AlignCenter,
                         metrics.elidedText(group.name, Qt::ElideRight, right - left));
    }
}

}  // namespace noctule::ui
