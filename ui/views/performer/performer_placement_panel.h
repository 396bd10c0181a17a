// SPDX-License-Identifier: Apache-2.0
// Where every board and source sits on the performer: the table of all, and segment, position and direction
// of the chosen one in numbers.
#pragma once

#include <QWidget>
#include <array>

#include "core/math/conventions.h"

class QComboBox;
class QDoubleSpinBox;
class QTableView;

namespace noctule::ui {

class Button;
class FormRows;
class Label;
class PerformerEditor;
class SuitPartsModel;

class PerformerPlacementPanel : public QWidget {
    Q_OBJECT
public:
    explicit PerformerPlacementPanel(PerformerEditor& editor, QWidget* parent = nullptr);

    QTableView& table() { return *table_; }
    QComboBox& segment() { return *segment_; }
    /// Millimetres along x, y, z of the segment.
    std::array<QDoubleSpinBox*, 3> position() { return position_; }
    /// Degrees about x, y, z; of a source only the first two are used: to the left and up.
    std::array<QDoubleSpinBox*, 3> rotation() { return rotation_; }
    Button& mirrorButton() { return *mirror_; }
    Button& backButton() { return *back_; }

private:
    void makeTable();
    QWidget* makeDetail();
    void fillSegments();
    void fitTable();
    void refresh();
    void refreshBoard();
    void refreshSource();
    void showNumbers(const Vector3d& p_m, const Vector3d& angles_rad);
    void nameAngles(bool of_board);
    void positionEdited(size_t axis, double value_m);
    void rotationEdited(size_t axis, double value_rad);
    void choose();

    PerformerEditor& editor_;
    SuitPartsModel* parts_;
    QTableView* table_;
    QWidget* detail_;
    Label* title_;
    Label* nothing_;
    QComboBox* segment_;
    std::array<QDoubleSpinBox*, 3> position_{}, rotation_{};
    std::array<Label*, 3> rotation_names_{};
    Button* mirror_;
    Button* back_;
    Vector3d shown_angles_rad_ = Vector3d::Zero();  ///< so that numbers do not jump to an equal triple
};

}  // namespace noctule::ui
