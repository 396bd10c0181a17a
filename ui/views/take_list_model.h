// SPDX-License-Identifier: Apache-2.0
// The takes of the session as rows, in the order in which they were made.
#pragma once

#include <QAbstractListModel>

#include "ui/models/review_context.h"
#include "ui/style/ink.h"

namespace noctule::ui {

class TakeListModel : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role { kName = Qt::UserRole, kDuration, kRating, kTone, kState, kOpen };

    explicit TakeListModel(ReviewContext& review, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Renames the take.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    /// Row of the take that is open for review, -1: none of them.
    int openRow() const;
    const SessionTake& take(int row) const {
        return review_.shared().session().session().takes[static_cast<size_t>(row)];
    }

    /// Of a take, for dots and screen readers.
    static Tone toneOf(const SessionTake& take);
    static QString stateInWords(const SessionTake& take);

private:
    void refresh();

    ReviewContext& review_;
    int rows_ = 0;
};

}  // namespace noctule::ui
