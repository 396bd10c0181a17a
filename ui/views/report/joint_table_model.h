// SPDX-License-Identifier: Apache-2.0
// The joints of a verdict as a table: name, mean and worst error, and how much of the time ranges backed it.
#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "core/report/take_verdict.h"

namespace noctule::ui {

class JointTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kJoint, kMean, kWorst, kRanges, kColumns };
    /// Sort key of a cell, and the grade of the joint.
    enum Role { kKey = Qt::UserRole, kGrade };

    using QAbstractTableModel::QAbstractTableModel;

    void setVerdict(std::shared_ptr<const TakeVerdict> verdict);
    bool hasErrors() const { return has_errors_; }
    bool hasRanges() const { return has_ranges_; }
    QString joint(int row) const { return QString::fromStdString(at(row).joint); }
    int rowOf(const QString& joint) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& = {}) const override { return kColumns; }
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    const VerdictJoint& at(int row) const { return verdict_->joints[static_cast<size_t>(row)]; }
    QString text(const VerdictJoint& joint, int column) const;

    std::shared_ptr<const TakeVerdict> verdict_;
    bool has_errors_ = false, has_ranges_ = false;
};

}  // namespace noctule::ui
