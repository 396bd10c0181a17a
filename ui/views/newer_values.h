// SPDX-License-Identifier: Apache-2.0
// A card that offers values of the connected suit which another session found later. Hidden where none are.
#pragma once

#include <QWidget>

#include "ui/models/capture_context.h"

namespace noctule::ui {

class ProblemCard;

class NewerValues : public QWidget {
    Q_OBJECT
public:
    explicit NewerValues(CaptureContext& capture, QWidget* parent = nullptr);

    /// Null: there are none.
    ProblemCard* card() { return card_; }

private:
    void refresh();
    void use();

    CaptureContext& capture_;
    ProblemCard* card_ = nullptr;
    QString made_;  ///< that the card tells of
};

}  // namespace noctule::ui
