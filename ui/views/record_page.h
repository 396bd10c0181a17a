// SPDX-License-Identifier: Apache-2.0
// Step Record: the ring that will start a take, resting, and the two ways to a take that there are now.
#pragma once

#include "ui/views/coming_page.h"

namespace noctule::ui {

class RecordPage : public ComingPage {
    Q_OBJECT
public:
    explicit RecordPage(Studio& studio, QWidget* parent = nullptr);
};

}  // namespace noctule::ui
