// SPDX-License-Identifier: Apache-2.0
// Text in one of the type sizes and colours of the style guide; follows theme and scale.
#pragma once

#include <QLabel>

#include "ui/style/ink.h"
#include "ui/style/theme.h"

namespace noctule::ui {

class Label : public QLabel {
    Q_OBJECT
public:
    explicit Label(const QString& text = {}, TextRole role = TextRole::kBody, Ink ink = Ink::kValue,
                   bool medium = false, QWidget* parent = nullptr);

    void setInk(Ink ink);
    void setRole(TextRole role, bool medium = false);
    /// Breaks lines where the width ends; the height follows.
    Label* wrapped();
    /// May be selected and copied.
    Label* selectable();

private:
    void restyle();

    TextRole role_;
    Ink ink_;
    bool medium_;
};

}  // namespace noctule::ui
