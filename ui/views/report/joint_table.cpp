// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/joint_table.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>

#include "ui/style/theme.h"
#include "ui/views/report/joint_table_model.h"
#include "ui/views/review_words.h"
#include "ui/widgets/bar_meter.h"

namespace noctule::ui {
namespace {

constexpr int kTableRow = 28, kTableInset = 12, kNumberColumn = 46, kRanges = 64, kShare = 44, kBar = 24;
constexpr int kNarrow = 272;  ///< the bar is left out below

/// Rows with a hairline below, numbers at the right, the share of ranges as a bar with its number.
class JointDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const Theme& theme = Theme::get();
        const Tokens& tokens = theme.tokens();
        const auto grade = static_cast<Grade>(index.data(JointTableModel::kGrade).toInt());
        const bool look = grade != Grade::kGood;
        painter->save();
        if (option.state & QStyle::State_Selected)
            painter->fillRect(option.rect, tokens.sel);
        else if (option.state & QStyle::State_MouseOver)
            painter->fillRect(option.rect, tokens.ctl);
        painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1),
                          tokens.line);
        QRect cell = option.rect;
        const bool first = index.column() == JointTableModel::kJoint;
        const bool last = index.column() == JointTableModel::kRanges;
        cell.adjust(first ? theme.px(kTableInset) : 0, 0, last ? -theme.px(kTableInset) : -theme.px(4), 0);
        const bool is_name = first, is_worst = index.column() == JointTableModel::kWorst;
        painter->setFont(theme.font(last ? TextRole::kSecondary : TextRole::kBody));
        painter->setPen(is_name    ? tokens.t1
                        : is_worst ? (look ? tokens.warn : tokens.t2)
                        : last     ? tokens.t2
                                   : tokens.t1);
        const QString text =
            painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, cell.width());
        painter->drawText(cell, index.data(Qt::TextAlignmentRole).toInt(), text);
        if (last && cell.width() > theme.px(kShare)) {
            cell.setWidth(theme.px(kBar));
            painter->setRenderHint(QPainter::Antialiasing);
            BarMeter::paint(*painter, cell, index.data(JointTableModel::kKey).toDouble(),
                            colorOf(toneOf(grade)));
        }
        painter->restore();
    }
};

}  // namespace

JointTable::JointTable(Selection& selection, QWidget* parent)
    : QTableView(parent),
      selection_(selection),
      joints_(new JointTableModel(this)),
      sorted_(new QSortFilterProxyModel(this)) {
    sorted_->setSourceModel(joints_);
    sorted_->setSortRole(JointTableModel::kKey);
    setModel(sorted_);
    setItemDelegate(new JointDelegate(this));
    setFrameShape(NoFrame);
    setShowGrid(false);
    setMouseTracking(true);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setTabKeyNavigation(false);
    setSortingEnabled(true);
    sortByColumn(JointTableModel::kJoint, Qt::AscendingOrder);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // the report scrolls as a whole
    verticalHeader()->hide();
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSortIndicatorShown(false);
    setAccessibleName(tr("Joints"));
    connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) {
                if (current.isValid())
                    selection_.setJoint(joints_->joint(sorted_->mapToSource(current).row()));
            });
    connect(&selection, &Selection::jointChanged, this, &JointTable::choose);
    connect(&Theme::get(), &Theme::changed, this, &JointTable::fitColumns);
    fitColumns();
}

void JointTable::setVerdict(std::shared_ptr<const TakeVerdict> verdict) {
    const QSignalBlocker quiet(selectionModel());
    joints_->setVerdict(std::move(verdict));
    fitColumns();
    choose(selection_.joint());
}

void JointTable::choose(const QString& joint) {
    const int row = joint.isEmpty() ? -1 : joints_->rowOf(joint);
    if (row < 0) {
        clearSelection();
        return;
    }
    const QModelIndex index = sorted_->mapFromSource(joints_->index(row, 0));
    if (index.row() != currentIndex().row())
        setCurrentIndex(index);
    selectRow(index.row());
}

void JointTable::fitColumns() {
    const Theme& theme = Theme::get();
    const bool errors = joints_->hasErrors();
    setColumnHidden(JointTableModel::kMean, !errors);
    setColumnHidden(JointTableModel::kWorst, !errors);
    setColumnHidden(JointTableModel::kRanges, !joints_->hasRanges());
    verticalHeader()->setMinimumSectionSize(theme.px(20));
    verticalHeader()->setDefaultSectionSize(theme.px(kTableRow));
    horizontalHeader()->setMinimumSectionSize(theme.px(20));
    horizontalHeader()->setFixedHeight(theme.px(kTableRow));
    const bool narrow = viewport()->width() < theme.px(kNarrow);
    const int ranges = theme.px((narrow ? kShare : kRanges) + kTableInset), number = theme.px(kNumberColumn);
    setColumnWidth(JointTableModel::kMean, number);
    setColumnWidth(JointTableModel::kWorst, number);
    setColumnWidth(JointTableModel::kRanges, ranges);
    const int rest = viewport()->width() - (joints_->hasRanges() ? ranges : 0) - (errors ? 2 * number : 0);
    setColumnWidth(JointTableModel::kJoint, std::max(theme.px(90), rest));
    setFixedHeight(contentHeight());
    updateGeometry();
}

int JointTable::contentHeight() const {
    return Theme::get().px(kTableRow) * (joints_->rowCount() + 1);
}

QSize JointTable::sizeHint() const {
    return {Theme::get().px(264), contentHeight()};
}

QSize JointTable::minimumSizeHint() const {
    return {Theme::get().px(200), contentHeight()};
}

void JointTable::resizeEvent(QResizeEvent* event) {
    QTableView::resizeEvent(event);
    if (event->oldSize().width() != event->size().width())
        fitColumns();
}

QString JointTable::asText() const {
    QStringList lines;
    for (int row = -1; row < sorted_->rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < sorted_->columnCount(); ++column)
            if (!isColumnHidden(column))
                cells += row < 0 ? sorted_->headerData(column, Qt::Horizontal).toString()
                                 : sorted_->index(row, column).data().toString();
        lines += cells.join('\t');
    }
    return lines.join('\n') + '\n';
}

void JointTable::copy() const {
    QGuiApplication::clipboard()->setText(asText());
}

void JointTable::keyPressEvent(QKeyEvent* event) {
    const bool walks = event->key() == Qt::Key_Up || event->key() == Qt::Key_Down ||
                       event->key() == Qt::Key_Tab || event->key() == Qt::Key_PageUp ||
                       event->key() == Qt::Key_PageDown;
    if (event->matches(QKeySequence::Copy))
        copy();
    else if (walks)
        QTableView::keyPressEvent(event);
    else
        event->ignore();  // the page plays and steps with these
}

void JointTable::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    menu.addAction(tr("Copy table"), this, &JointTable::copy, QKeySequence::Copy);
    menu.exec(event->globalPos());
}

}  // namespace noctule::ui
