// SPDX-License-Identifier: Apache-2.0
#include "ui/views/take_list_model.h"

#include "ui/language/core_words.h"
#include "ui/style/words.h"
#include "ui/views/open_take.h"

namespace noctule::ui {

TakeListModel::TakeListModel(ReviewContext& review, QObject* parent)
    : QAbstractListModel(parent), review_(review) {
    connect(&review.shared().session(), &SessionModel::opened, this, &TakeListModel::refresh);
    connect(&review.shared().session(), &SessionModel::changed, this, &TakeListModel::refresh);
    connect(&review.take(), &TakeDocument::opened, this, &TakeListModel::refresh);
    refresh();
}

void TakeListModel::refresh() {
    const SessionModel& session = review_.shared().session();
    const int rows = session.isOpen() ? static_cast<int>(session.session().takes.size()) : 0;
    if (rows != rows_) {
        beginResetModel();
        rows_ = rows;
        endResetModel();
    } else if (rows > 0) {
        emit dataChanged(index(0), index(rows - 1));
    }
}

int TakeListModel::rowCount(const QModelIndex& parent) const {
    // The session may have changed before refresh() hears of it.
    const bool is_there = !parent.isValid() && review_.shared().session().isOpen();
    return is_there ? std::min(rows_, static_cast<int>(review_.shared().session().session().takes.size()))
                    : 0;
}

int TakeListModel::openRow() const {
    return openTakeIndex(review_);
}

QVariant TakeListModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const SessionTake& take = this->take(index.row());
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
        case kName:
            return QString::fromStdString(take.name);
        case Qt::ToolTipRole:
            return take.problem.empty() ? stateInWords(take) : coreWords(take.problem);
        case Qt::AccessibleTextRole:
            return tr("%1, %2, %3, %n stars", nullptr, take.rating)
                .arg(QString::fromStdString(take.name), timeText(take.duration_s, 0), stateInWords(take));
        case kDuration:
            return take.duration_s > 0 ? timeText(take.duration_s, 0) : QString();
        case kRating:
            return take.rating;
        case kTone:
            return static_cast<int>(toneOf(take));
        case kState:
            return stateInWords(take);
        case kOpen:
            return index.row() == openRow();
        default:
            return {};
    }
}

Qt::ItemFlags TakeListModel::flags(const QModelIndex& index) const {
    return QAbstractListModel::flags(index) | (index.isValid() ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

bool TakeListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || role != Qt::EditRole)
        return false;
    review_.shared().session().renameTake(index.row(), value.toString());
    return true;
}

Tone TakeListModel::toneOf(const SessionTake& take) {
    switch (take.state) {
        case TakeState::kDamaged:
            return Tone::kError;
        case TakeState::kRecovered:
        case TakeState::kRecording:
            return Tone::kWarn;
        case TakeState::kComplete:
            break;
    }
    if (!take.problem.empty())
        return Tone::kWarn;
    return take.processed ? Tone::kOk : Tone::kNeutral;
}

QString TakeListModel::stateInWords(const SessionTake& take) {
    switch (take.state) {
        case TakeState::kDamaged:
            return tr("damaged");
        case TakeState::kRecovered:
            return take.processed ? tr("recovered and processed") : tr("recovered, not processed yet");
        case TakeState::kRecording:
            return tr("was not finished");
        case TakeState::kComplete:
            break;
    }
    return take.processed ? tr("processed") : tr("not processed yet");
}

}  // namespace noctule::ui
