// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer/suit_parts_model.h"

#include "ui/models/part_names.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/performer/performer_editor.h"

namespace noctule::ui {
namespace {

// Less cannot be measured on a body, and less the screen does not show.
constexpr double kMoved_m = 0.0005, kTurned_rad = 0.01;

}  // namespace

SuitPartsModel::SuitPartsModel(PerformerEditor& editor, QObject* parent)
    : QAbstractTableModel(parent), editor_(editor) {
    connect(&editor, &PerformerEditor::performerChanged, this, &SuitPartsModel::refresh);
    refresh();
}

void SuitPartsModel::refresh() {
    const bool any = editor_.hasPerformer();
    const int boards = any ? static_cast<int>(editor_.performer().suit.boards.size()) : 0;
    const int sources = any ? static_cast<int>(editor_.performer().suit.sources.size()) : 0;
    if (boards != boards_ || sources != sources_) {
        beginResetModel();
        boards_ = boards;
        sources_ = sources;
        endResetModel();
    } else if (rowCount() > 0) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, kColumnCount - 1));
    }
}

SuitPart SuitPartsModel::partAt(int row) const {
    if (row < 0 || row >= rowCount())
        return {};
    return row < boards_ ? SuitPart{SuitPart::Kind::kBoard, row}
                         : SuitPart{SuitPart::Kind::kSource, row - boards_};
}

int SuitPartsModel::rowOf(SuitPart part) const {
    if (part.kind == SuitPart::Kind::kNone)
        return -1;
    return part.kind == SuitPart::Kind::kBoard ? part.index : boards_ + part.index;
}

int SuitPartsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : boards_ + sources_;
}

int SuitPartsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumnCount;
}

QString SuitPartsModel::movedText(SuitPart part) const {
    const auto offset = editor_.offsetOf(part);
    if (!offset)
        return tr("own place");
    if (offset->distance_m >= kMoved_m)
        return millimetresText(offset->distance_m, 0);
    return offset->angle_rad >= kTurned_rad ? degreesText(offset->angle_rad, 0) : QString();
}

QString SuitPartsModel::spokenText(SuitPart part, int column) const {
    const Suit& suit = editor_.performer().suit;
    if (column == kName)
        return part.kind == SuitPart::Kind::kBoard ? boardTitle(suit, part.index)
                                                   : sourceTitle(suit, part.index);
    const QString written = text(part, column);
    return written.isEmpty() ? millimetresText(0, 0) : written;  // an empty cell: not moved
}

QString SuitPartsModel::text(SuitPart part, int column) const {
    const Suit& suit = editor_.performer().suit;
    const auto at = static_cast<size_t>(part.index);
    const bool is_board = part.kind == SuitPart::Kind::kBoard;
    switch (column) {
        case kNumber:
            return is_board ? QString::number(part.index + 1)
                            : tr("S%1", "short for source 1").arg(part.index + 1);
        case kName:
            return is_board ? boardName(suit.boards[at]) : sourcePlace(suit.sources[at]);
        default:
            return movedText(part);
    }
}

QVariant SuitPartsModel::data(const QModelIndex& index, int role) const {
    const SuitPart part = partAt(index.row());
    if (part.kind == SuitPart::Kind::kNone)
        return {};
    switch (role) {
        case Qt::DisplayRole:
            return text(part, index.column());
        case Qt::TextAlignmentRole:
            return int(Qt::AlignVCenter | (index.column() == kName ? Qt::AlignLeft : Qt::AlignRight));
        case Qt::ToolTipRole:  // the name may be cut
            return index.column() == kName ? text(part, kName) : QVariant();
        case Qt::AccessibleTextRole:
            return spokenText(part, index.column());
        case Qt::ForegroundRole:
            return Theme::get().tokens().*(index.column() == kName ? &Tokens::t1 : &Tokens::t2);
        default:
            return {};
    }
}

QVariant SuitPartsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (section == kName ? Qt::AlignLeft : Qt::AlignRight));
    if (role != Qt::DisplayRole)
        return {};
    return section == kNumber ? tr("No.") : section == kName ? tr("Name") : tr("Moved");
}

}  // namespace noctule::ui
