// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/joint_table_model.h"

#include <algorithm>

#include "core/math/conventions.h"
#include "ui/models/part_names.h"
#include "ui/style/words.h"

namespace noctule::ui {

void JointTableModel::setVerdict(std::shared_ptr<const TakeVerdict> verdict) {
    beginResetModel();
    verdict_ = std::move(verdict);
    has_errors_ =
        verdict_ && std::any_of(verdict_->joints.begin(), verdict_->joints.end(),
                                [](const VerdictJoint& joint) { return joint.mean_deg.has_value(); });
    has_ranges_ = verdict_ && std::ranges::any_of(verdict_->joints, [](const VerdictJoint& joint) {
                      return joint.backed_by_ranges > 0;
                  });
    endResetModel();
}

int JointTableModel::rowOf(const QString& joint) const {
    for (int row = 0; row < rowCount(); ++row)
        if (this->joint(row) == joint)
            return row;
    return -1;
}

int JointTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !verdict_ ? 0 : static_cast<int>(verdict_->joints.size());
}

QString JointTableModel::text(const VerdictJoint& joint, int column) const {
    switch (column) {
        case kJoint:
            return jointName(joint.joint);
        case kMean:
            return joint.mean_deg ? degreesText(radians(*joint.mean_deg)) : kNoValue;
        case kWorst:
            return joint.worst_deg ? degreesText(radians(*joint.worst_deg)) : kNoValue;
        default:
            return percentText(joint.backed_by_ranges);
    }
}

QVariant JointTableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const VerdictJoint& joint = at(index.row());
    switch (role) {
        case Qt::DisplayRole:
            return text(joint, index.column());
        case Qt::TextAlignmentRole:
            return static_cast<int>(Qt::AlignVCenter |
                                    (index.column() == kJoint ? Qt::AlignLeft : Qt::AlignRight));
        case Qt::ToolTipRole:  // the name may be cut
            return index.column() == kJoint ? text(joint, kJoint) : QVariant();
        case Qt::AccessibleTextRole:
            return index.column() == kRanges ? tr("%1 backed by ranges").arg(text(joint, kRanges))
                                             : text(joint, index.column());
        case kGrade:
            return static_cast<int>(joint.grade);
        case kKey:
            switch (index.column()) {
                case kJoint:
                    return index.row();  // as the body is built
                case kMean:
                    return joint.mean_deg.value_or(-1);
                case kWorst:
                    return joint.worst_deg.value_or(-1);
                default:
                    return joint.backed_by_ranges;
            }
        default:
            return {};
    }
}

QVariant JointTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::DisplayRole) {
        const QString titles[] = {tr("Joint"), tr("Mean"), tr("Worst"), tr("Ranges")};
        return titles[section];
    }
    if (role == Qt::ToolTipRole) {
        const QString meanings[] = {
            tr("In the order of the body"), tr("Mean angle between result and reference"),
            tr("Largest angle between result and reference"),
            tr("Share of the time in which ranges backed the joint; in between it follows "
               "its gyroscope")};
        return meanings[section];
    }
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignVCenter | (section == kJoint ? Qt::AlignLeft : Qt::AlignRight));
    return {};
}

}  // namespace noctule::ui
