// SPDX-License-Identifier: Apache-2.0
// The shot list as text: pasted from any document or edited, one shot a line.
#pragma once

#include "core/session/session.h"
#include "ui/views/dialog_frame.h"

class QPlainTextEdit;

namespace noctule::ui {

class Label;

class ShotListDialog : public DialogFrame {
    Q_OBJECT
public:
    /// `pasted`: the text comes from somewhere else.
    ShotListDialog(const QString& text, bool pasted, QWidget* parent);

    std::vector<Shot> shots() const;

    QPlainTextEdit* const editor;

private:
    void count();

    Label* counted_;
};

}  // namespace noctule::ui
