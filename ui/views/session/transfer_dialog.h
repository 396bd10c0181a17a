// SPDX-License-Identifier: Apache-2.0
// Asks for the session that a take goes to: one of the recent ones, or any other.
#pragma once

#include "ui/models/shared_context.h"
#include "ui/views/dialog_frame.h"

class QListWidget;

namespace noctule::ui {

class TransferDialog : public DialogFrame {
    Q_OBJECT
public:
    TransferDialog(SharedContext& shared, const QString& take, SessionModel::Transfer how,
                   QWidget* parent = nullptr);

    /// Of the chosen session; empty: none.
    QString folder() const;
    /// Chooses a session; one that is not listed comes to the top of the list. In words why not, else empty.
    QString choose(const QString& folder);

public slots:
    void accept() override;  ///< stays open with words when the session cannot be written

private:
    void addSession(int row, const QString& folder);
    void askForFolder();
    void refresh();
    bool isOpenHere(const QString& folder) const;

    SharedContext& shared_;
    QListWidget* sessions_;
};

}  // namespace noctule::ui
