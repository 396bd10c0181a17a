// SPDX-License-Identifier: Apache-2.0
// Step Calibrate: the four wizards as they will be, each with what it finds out and what it takes.
#pragma once

#include "ui/views/coming_page.h"

namespace noctule::ui {

class CalibratePage : public ComingPage {
    Q_OBJECT
public:
    explicit CalibratePage(Studio& studio, QWidget* parent = nullptr);
};

}  // namespace noctule::ui
