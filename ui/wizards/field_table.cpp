// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/field_table.h"

#include <QPainter>

#include "ui/models/part_names.h"
#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/bar_meter.h"
#include "ui/wizards/wizard_run.h"

namespace noctule::ui {
namespace {

constexpr int kMargin = 12, kNumber = 18, kBar = 62, kShare = 46, kUneven = 66;
constexpr int kRoomForBars = 360;  ///< where names leave it

}  // namespace

FieldTable::FieldTable(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setAccessibleName(tr("Sensors, directions seen and unevenness"));
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
}

void FieldTable::setRun(const WizardRun* run) {
    run_ = run;
    refresh();
}

std::vector<int> FieldTable::boards() const {
    std::vector<int> all;
    for (int board = 0; run_ && run_->fieldGuide() && board < static_cast<int>(run_->suit().boards.size());
         ++board)
        if (run_->suit().boards[static_cast<size_t>(board)].has_magnetometer)
            all.push_back(board);
    return all;
}

void FieldTable::refresh() {
    if (const size_t count = boards().size(); count != known_) {
        known_ = count;
        updateGeometry();
    }
    update();
}

int FieldTable::rowHeight() const {
    return Theme::get().px(28);
}

QSize FieldTable::sizeHint() const {
    return QSize(Theme::get().px(280), rowHeight() * (static_cast<int>(boards().size()) + 1));
}

void FieldTable::paintHead(QPainter& painter) const {
    const Theme& theme = Theme::get();
    painter.setFont(theme.font(TextRole::kCaption));
    painter.setPen(theme.tokens().t3);
    const int right = width() - theme.px(kMargin);
    painter.drawText(QRect(theme.px(kMargin + kNumber + 10), 0, width(), rowHeight()),
                     Qt::AlignLeft | Qt::AlignVCenter, tr("Sensor"));
    painter.drawText(QRect(0, 0, right - theme.px(kUneven + 6), rowHeight()),
                     Qt::AlignRight | Qt::AlignVCenter, tr("directions"));
    painter.drawText(QRect(0, 0, right, rowHeight()), Qt::AlignRight | Qt::AlignVCenter, tr("unevenness"));
}

void FieldTable::paintRow(QPainter& painter, int row, int board) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const FieldGuide& guide = *run_->fieldGuide();
    const FieldTurn& turn = guide.turnOf(board);
    const int top = rowHeight() * (row + 1), high = rowHeight(), right = width() - theme.px(kMargin);
    const bool skipped = guide.isSkipped(board), done = turn.state() == FieldTurnState::kDone;
    const bool bad =
        !skipped && (guide.carriesIronNow(board) || (!done && turn.state() != FieldTurnState::kGoing));
    if (bad)
        painter.fillRect(QRect(0, top, width(), high), tokens.warnbg);
    const QColor ink = bad ? tokens.warn : skipped ? tokens.t3 : tokens.t1;
    painter.setPen(ink);
    painter.setFont(theme.font(TextRole::kSecondary));
    painter.drawText(QRect(theme.px(kMargin), top, theme.px(kNumber), high),
                     Qt::AlignRight | Qt::AlignVCenter, QString::number(board + 1));
    const int uneven_left = right - theme.px(kUneven), share_left = uneven_left - theme.px(kShare);
    const int bar_width = width() >= theme.px(kRoomForBars) ? theme.px(kBar) : 0;
    const int bar_left = share_left - bar_width, name_left = theme.px(kMargin + kNumber + 10);
    const QRect name(name_left, top, bar_left - name_left - theme.px(6), high);
    const QString words = boardName(run_->suit().boards[static_cast<size_t>(board)]);
    painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(words, Qt::ElideRight, name.width()));
    if (skipped) {
        painter.drawText(QRect(bar_left, top, right - bar_left, high), Qt::AlignRight | Qt::AlignVCenter,
                         tr("skipped"));
        return;
    }
    const double share = turn.sphere().share();
    if (bar_width > 0)
        BarMeter::paint(painter, QRect(bar_left, top, bar_width, high), share,
                        bad                                      ? tokens.warn
                        : share >= FieldTurnLimits::kEnoughShare ? tokens.ok
                                                                 : tokens.acc);
    painter.setPen(tokens.t2);
    painter.drawText(QRect(share_left, top, theme.px(kShare - 4), high), Qt::AlignRight | Qt::AlignVCenter,
                     percentText(share));
    painter.setPen(bad ? tokens.warn : tokens.t1);
    const QString uneven = turn.uneven_percent() ? percentText(*turn.uneven_percent() / 100, 1) : kNoValue;
    painter.drawText(QRect(uneven_left, top, theme.px(kUneven), high), Qt::AlignRight | Qt::AlignVCenter,
                     uneven);
    if (bad || done)
        paintIcon(painter, QRectF(uneven_left, top, theme.px(18), high), bad ? "warn" : "check", theme.px(13),
                  bad ? tokens.warn : tokens.ok);
}

void FieldTable::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintHead(painter);
    int row = 0;
    for (const int board : boards())
        paintRow(painter, row++, board);
}

}  // namespace noctule::ui
