// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer/performer_placement_panel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QTableView>

#include "core/math/euler.h"
#include "ui/models/part_names.h"
#include "ui/style/theme.h"
#include "ui/views/number_box.h"
#include "ui/views/performer/performer_editor.h"
#include "ui/views/performer/suit_parts_model.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"

namespace noctule::ui {
namespace {

constexpr int kPartRow = 26, kNumberWidth = 44, kMovedWidth = 76, kFewestParts = 6;
constexpr double kFarthest_mm = 2000;

QDoubleSpinBox* makeNumber(double limit, double step, const QString& suffix) {
    auto* box = new NumberBox;
    box->setRange(-limit, limit);
    box->setDecimals(1);
    box->setSingleStep(step);
    box->setSuffix(suffix);
    box->setAlignment(Qt::AlignRight);
    box->setKeyboardTracking(false);
    return box;
}

void showNumber(QDoubleSpinBox& box, double value) {
    const QSignalBlocker quiet(box);
    if (!box.hasFocus() || std::abs(box.value() - value) > 0.05)
        box.setValue(value);
}

}  // namespace

PerformerPlacementPanel::PerformerPlacementPanel(PerformerEditor& editor, QWidget* parent)
    : QWidget(parent), editor_(editor), parts_(new SuitPartsModel(editor, this)), table_(new QTableView) {
    auto* column = makeColumn(this);
    makeTable();
    detail_ = makeDetail();
    nothing_ = new Label(tr("Choose a board or a source in the list or on the body to move and turn it."),
                         TextRole::kBody, Ink::kLabel);
    nothing_->wrapped();
    auto* cost = new Label(tr("A board 5 mm and 3° away from where it is placed here costs about 2° in the "
                              "joints around it."),
                           TextRole::kSecondary, Ink::kHint);
    cost->wrapped();
    column->addWidget(table_, 1);
    column->addWidget(new Divider);
    column->addWidget(detail_);
    auto* text = addRow(column, 0, {12, 12, 12, 0});
    text->addWidget(nothing_);
    addRow(column, 0, {12, 8, 12, 12})->addWidget(cost);
    connect(&editor, &PerformerEditor::performerChanged, this, &PerformerPlacementPanel::refresh);
    connect(&editor, &PerformerEditor::partChanged, this, &PerformerPlacementPanel::choose);
    connect(&Theme::get(), &Theme::changed, this, &PerformerPlacementPanel::fitTable);
    fitTable();
    choose();
}

void PerformerPlacementPanel::makeTable() {
    table_->setModel(parts_);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setShowGrid(false);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->setWordWrap(false);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setHighlightSections(false);
    table_->setAccessibleName(tr("Boards and sources"));
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) { editor_.choosePart(parts_->partAt(current.row())); });
}

void PerformerPlacementPanel::fitTable() {
    const Theme& theme = Theme::get();
    QHeaderView& header = *table_->horizontalHeader();
    header.setMinimumSectionSize(theme.px(kNumberWidth));
    header.setSectionResizeMode(SuitPartsModel::kNumber, QHeaderView::Fixed);
    header.setSectionResizeMode(SuitPartsModel::kName, QHeaderView::Stretch);
    header.setSectionResizeMode(SuitPartsModel::kMoved, QHeaderView::Fixed);
    header.resizeSection(SuitPartsModel::kNumber, theme.px(kNumberWidth));
    header.resizeSection(SuitPartsModel::kMoved, theme.px(kMovedWidth));
    table_->verticalHeader()->setDefaultSectionSize(theme.px(kPartRow));
    table_->setMinimumHeight(theme.px(kPartRow) * kFewestParts);
}

QWidget* PerformerPlacementPanel::makeDetail() {
    auto* detail = new QWidget;
    auto* column = makeColumn(detail, {12, 12, 12, 0}, 8);
    title_ = new Label({}, TextRole::kBody, Ink::kValue, true);
    column->addWidget(title_);
    auto* rows = new FormRows;
    segment_ = new QComboBox;
    fillSegments();
    rows->addRow(tr("Segment"), segment_);
    const std::array<QString, 3> axes{tr("X, to the left"), tr("Y, up"), tr("Z, forward")};
    for (size_t axis = 0; axis < 3; ++axis) {
        position_[axis] = makeNumber(kFarthest_mm, 1, tr(" mm", "unit after a number"));
        rows->addRow(axes[axis], position_[axis]);
        connect(position_[axis], QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
                [this, axis](double value_mm) { positionEdited(axis, value_mm / 1000); });
    }
    rows->addHint(tr("Axes of the segment as they lie in a T pose."));
    for (size_t axis = 0; axis < 3; ++axis) {
        rotation_[axis] = makeNumber(360, 1, tr("°", "degrees after a number"));
        rotation_names_[axis] = rows->addRow({}, rotation_[axis]);
        connect(rotation_[axis], QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
                [this, axis](double value_deg) { rotationEdited(axis, radians(value_deg)); });
    }
    column->addWidget(rows);
    mirror_ = makeButton(ButtonKind::kOutlined, tr("Mirror to the other side"), "swap");
    back_ = makeButton(ButtonKind::kText, tr("Back to the suit’s place"));
    auto* mirror_row = addRow(column);
    mirror_row->addWidget(mirror_);
    mirror_row->addStretch();
    auto* back_row = addRow(column);
    back_row->addWidget(back_);
    back_row->addStretch();
    connect(segment_, QOverload<int>::of(&QComboBox::activated), this,
            [this](int row) { editor_.setSegment(segment_->itemData(row).toString().toStdString()); });
    connect(mirror_, &QPushButton::clicked, &editor_, &PerformerEditor::mirror);
    connect(back_, &QPushButton::clicked, &editor_, &PerformerEditor::backToSuit);
    return detail;
}

void PerformerPlacementPanel::fillSegments() {
    for (const std::string& joint : canonicalJointNames())
        segment_->addItem(segmentName(joint), QString::fromStdString(joint));
}

void PerformerPlacementPanel::choose() {
    const int row = parts_->rowOf(editor_.part());
    {
        const QSignalBlocker quiet(table_->selectionModel());
        if (row < 0)
            table_->clearSelection();
        else
            table_->selectRow(row);
    }
    table_->viewport()->update();
    if (row >= 0)
        table_->scrollTo(parts_->index(row, 0));
    shown_angles_rad_.setZero();
    refresh();
}

void PerformerPlacementPanel::refresh() {
    const bool any = editor_.board() || editor_.source();
    setEnabled(editor_.hasPerformer());
    detail_->setVisible(any);
    nothing_->setVisible(!any);
    if (!any)
        return;
    title_->setText(editor_.partTitle());
    nameAngles(editor_.board());
    if (editor_.board())
        refreshBoard();
    else
        refreshSource();
    mirror_->setDisabledBecause(editor_.hasOtherSide() ? QString()
                                                       : tr("It has no counterpart on the other side."));
    const auto offset = editor_.offsetOf(editor_.part());
    const bool known = editor_.isKnownToSuit();
    const bool moved = !offset || offset->distance_m > 1e-9 || offset->angle_rad > 1e-6;
    back_->setDisabledBecause(!known   ? tr("The suit that comes with Noctule has no such part.")
                              : !moved ? tr("It is where the suit has it.")
                                       : QString());
}

void PerformerPlacementPanel::nameAngles(bool of_board) {
    const std::array<QString, 3> board_names{tr("Turned about X"), tr("Turned about Y"),
                                             tr("Turned about Z")};
    const std::array<QString, 3> source_names{tr("Points to the left"), tr("Points up"), QString()};
    for (size_t axis = 0; axis < 3; ++axis) {
        const QString& name = of_board ? board_names[axis] : source_names[axis];
        rotation_names_[axis]->setText(name);
        rotation_[axis]->setAccessibleName(name);
        rotation_names_[axis]->setVisible(!name.isEmpty());
        rotation_[axis]->setVisible(!name.isEmpty());
    }
}

void PerformerPlacementPanel::refreshBoard() {
    const Board& board = *editor_.board();
    segment_->setCurrentIndex(segment_->findData(QString::fromStdString(board.segment)));
    showNumbers(board.p_segment_board_m,
                eulerFromRotation(kEulerXYZ, board.q_segment_board, shown_angles_rad_));
}

void PerformerPlacementPanel::refreshSource() {
    const Source& source = *editor_.source();
    segment_->setCurrentIndex(segment_->findData(QString::fromStdString(source.segment)));
    const SourceDirection direction = directionOf(source.normal_segment);
    showNumbers(source.p_segment_source_m, {direction.left_rad, direction.up_rad, 0});
}

void PerformerPlacementPanel::showNumbers(const Vector3d& p_m, const Vector3d& angles_rad) {
    shown_angles_rad_ = angles_rad;
    for (size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        showNumber(*position_[axis], 1000 * p_m[i]);
        showNumber(*rotation_[axis], degrees(angles_rad[i]));
    }
}

// Only the number that was edited goes through what the screen shows of it.
void PerformerPlacementPanel::positionEdited(size_t axis, double value_m) {
    if (!editor_.board() && !editor_.source())
        return;
    Vector3d p_m =
        editor_.board() ? editor_.board()->p_segment_board_m : editor_.source()->p_segment_source_m;
    p_m[static_cast<Eigen::Index>(axis)] = value_m;
    editor_.setPosition(p_m);
}

void PerformerPlacementPanel::rotationEdited(size_t axis, double value_rad) {
    shown_angles_rad_[static_cast<Eigen::Index>(axis)] = value_rad;
    if (editor_.board())
        editor_.setRotation(rotationFromEuler(kEulerXYZ, shown_angles_rad_));
    else
        editor_.setDirection({shown_angles_rad_[0], shown_angles_rad_[1]});
}

}  // namespace noctule::ui
