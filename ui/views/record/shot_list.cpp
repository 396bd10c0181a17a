// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/shot_list.h"

#include <QApplication>
#include <QClipboard>
#include <QPainter>
#include <QStyledItemDelegate>

#include "core/session/shot_list.h"
#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/views/record/record_run.h"
#include "ui/views/record/shot_list_dialog.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {
namespace {

constexpr int kKept = Qt::UserRole, kWanted = Qt::UserRole + 1, kChosen = Qt::UserRole + 2;
constexpr int kShotRow = 28, kShotInset = 12, kShotMark = 14, kMostShots = 8;

class ShotDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
        return {0, Theme::get().px(kShotRow)};
    }
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const Theme& theme = Theme::get();
        const Tokens& tokens = theme.tokens();
        const bool chosen = index.data(kChosen).toBool();
        const bool done = index.data(kKept).toInt() >= index.data(kWanted).toInt();
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        if (option.state & QStyle::State_MouseOver)
            painter->fillRect(option.rect, tokens.ctl);
        const int inset = theme.px(kShotInset);
        QRect row = option.rect.adjusted(inset, 0, -inset, 0);
        paintMark(*painter, QRect(row.left(), row.top(), theme.px(kShotMark), row.height()), done, chosen);
        const QString count =
            QStringLiteral("%1/%2").arg(index.data(kKept).toInt()).arg(index.data(kWanted).toInt());
        painter->setFont(theme.font(TextRole::kBody, chosen));
        painter->setPen(chosen ? tokens.t1 : tokens.t2);
        painter->drawText(row, Qt::AlignRight | Qt::AlignVCenter, count);
        row.setLeft(row.left() + theme.px(kShotMark + 8));
        row.setRight(row.right() - painter->fontMetrics().horizontalAdvance(count) - theme.px(8));
        painter->drawText(
            row, Qt::AlignLeft | Qt::AlignVCenter,
            painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, row.width()));
        painter->restore();
    }

private:
    static void paintMark(QPainter& painter, const QRect& area, bool done, bool chosen) {
        const Theme& theme = Theme::get();
        const Tokens& tokens = theme.tokens();
        if (done && !chosen)
            return paintIcon(painter, area, "check", theme.px(14), tokens.ok);
        const QPointF centre = QRectF(area).center();
        const double radius = theme.px(kShotMark) / 2.0 - 1;
        painter.setPen(QPen(chosen ? tokens.acc : tokens.edge, theme.px(chosen ? 3.5 : 1.2)));
        painter.setBrush(Qt::NoBrush);
        const double ring = chosen ? radius - theme.px(1) : radius;
        painter.drawEllipse(centre, ring, ring);
    }
};

}  // namespace

ShotList::ShotList(CaptureContext& capture, RecordRun& run, QWidget* parent)
    : QWidget(parent),
      capture_(capture),
      run_(run),
      header_(new SectionHeader(tr("Shot list"))),
      rows_(new QListWidget),
      empty_(new Label(tr("What is to be recorded, one shot a line; takes are counted for each."),
                       TextRole::kSecondary, Ink::kHint)),
      paste_(makeButton(ButtonKind::kOutlined, tr("Paste a list"), "note")),
      edit_(makeButton(ButtonKind::kText, tr("Edit"))) {
    auto* column = makeColumn(this, {0, 8, 0, 12}, 4);
    addRow(column, 0, {12, 0, 12, 0})->addWidget(header_);
    addRow(column, 0, {12, 0, 12, 4})->addWidget(empty_->wrapped());
    column->addWidget(rows_);
    auto* buttons = addRow(column, 8, {12, 4, 12, 0});
    for (Button* button : {paste_, edit_}) {
        button->setFocusPolicy(Qt::TabFocus);
        buttons->addWidget(button);
    }
    buttons->addStretch();
    rows_->setItemDelegate(new ShotDelegate(rows_));
    rows_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);  // else the page's free height is ours
    rows_->setFrameShape(QFrame::NoFrame);
    rows_->setMouseTracking(true);
    rows_->setFocusPolicy(Qt::TabFocus);
    rows_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    rows_->setAccessibleName(tr("Shot list"));
    connect(rows_, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { choose(rows_->row(item)); });
    connect(rows_, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { run_.setShot(rows_->row(item)); });
    connect(paste_, &QPushButton::clicked, this, [this] { edit(QApplication::clipboard()->text(), true); });
    connect(edit_, &QPushButton::clicked, this, [this] {
        edit(QString::fromStdString(textOf(capture_.shared().session().session().shots)), false);
    });
    connect(&run, &RecordRun::changed, this, &ShotList::refresh);
    connect(&Theme::get(), &Theme::changed, this, &ShotList::refresh);
    refresh();
}

void ShotList::choose(int row) {
    run_.setShot(row == run_.shot() ? -1 : row);
}

void ShotList::edit(const QString& text, bool pasted) {
    ShotListDialog dialog(text, pasted, window());
    if (dialog.exec() == QDialog::Accepted)
        capture_.shared().session().setShots(dialog.shots());
}

void ShotList::refresh() {
    const SessionModel& model = capture_.shared().session();
    const bool open = model.isOpen();
    const int count = open ? static_cast<int>(model.session().shots.size()) : 0;
    while (rows_->count() > count)
        delete rows_->takeItem(rows_->count() - 1);
    while (rows_->count() < count)
        rows_->addItem(new QListWidgetItem);
    for (int row = 0; row < count; ++row) {
        const Shot& shot = model.session().shots[static_cast<size_t>(row)];
        const int kept = keptTakes(model.session(), shot.name);
        QListWidgetItem& item = *rows_->item(row);
        item.setText(QString::fromStdString(shot.name));
        item.setData(kKept, kept);
        item.setData(kWanted, shot.wanted);
        item.setData(kChosen, row == run_.shot());
        item.setData(Qt::AccessibleTextRole,
                     tr("%1, %2 of %3 takes", "a shot").arg(item.text()).arg(kept).arg(shot.wanted));
        item.setToolTip(item.text());
    }
    rows_->setFixedHeight(std::min(count, kMostShots) * Theme::get().px(kShotRow));
    rows_->setVisible(count > 0);
    empty_->setVisible(count == 0);
    edit_->setVisible(count > 0);
    const QString why = open ? QString() : tr("A shot list belongs to a session. Make or open one first.");
    paste_->setDisabledBecause(why);
    if (!open)
        return header_->setHint({});
    const ShotProgress progress = progressOf(model.session());
    header_->setHint(count > 0 ? tr("%1 of %2 takes done").arg(progress.kept).arg(progress.wanted)
                               : QString());
}

}  // namespace noctule::ui
