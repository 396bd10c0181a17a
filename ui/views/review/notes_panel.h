// SPDX-License-Identifier: Apache-2.0
// What the operator says about the open take; kept in the session, one undo step per visit. Notes that the
// take itself brought stand above and cannot be changed.
#pragma once

#include <QPlainTextEdit>
#include <QTimer>

#include "ui/models/review_context.h"

namespace noctule::ui {

class Label;

class NotesPanel : public QWidget {
    Q_OBJECT
public:
    explicit NotesPanel(ReviewContext& review, QWidget* parent = nullptr);

    QPlainTextEdit& editor() { return *editor_; }
    void edit();  ///< gives it the keyboard

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void readTake();
    void readNotes();
    void save();
    void fitHeight();

    ReviewContext& review_;
    Label* of_take_;
    QPlainTextEdit* editor_;
    QTimer pause_;
    bool written_ = false;  ///< something that the session does not have yet
    int take_ = -1;
    std::string take_name_;
};

}  // namespace noctule::ui
