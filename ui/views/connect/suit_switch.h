// SPDX-License-Identifier: Apache-2.0
// Whose suit is looked at, where several are connected: a button for each performer. Hidden for one.
#pragma once

#include "ui/models/capture_context.h"
#include "ui/views/performer_buttons.h"

namespace noctule::ui {

class SuitSwitch : public PerformerButtons {
    Q_OBJECT
public:
    explicit SuitSwitch(CaptureContext& capture, QWidget* parent = nullptr);

private:
    void refresh();
    void choose(int index);

    CaptureContext& capture_;
};

}  // namespace noctule::ui
