// SPDX-License-Identifier: Apache-2.0
// Boards and sources of a performer as a table: number, name, and how far each has been moved from where the
// suit has it.
#pragma once

#include <QAbstractTableModel>

#include "ui/scene/suit_part.h"

namespace noctule::ui {

class PerformerEditor;

class SuitPartsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kNumber, kName, kMoved, kColumnCount };

    explicit SuitPartsModel(PerformerEditor& editor, QObject* parent = nullptr);

    SuitPart partAt(int row) const;
    int rowOf(SuitPart part) const;  ///< -1: none

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void refresh();
    QString text(SuitPart part, int column) const;
    QString spokenText(SuitPart part, int column) const;
    QString movedText(SuitPart part) const;

    PerformerEditor& editor_;
    int boards_ = 0, sources_ = 0;
};

}  // namespace noctule::ui
