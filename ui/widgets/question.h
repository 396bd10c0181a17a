// SPDX-License-Identifier: Apache-2.0
// A question before something that cannot be taken back, or that may be a mistake.
#pragma once

#include <QString>

class QWidget;

namespace noctule::ui {

struct Question {
    QString title, text, detail;
    QString no, yes;  ///< words of the two buttons
};
/// Modal. True: `yes` was pressed. Return, Escape and closing it mean `no`.
bool isAnsweredYes(const Question& question, QWidget* parent);

}  // namespace noctule::ui
