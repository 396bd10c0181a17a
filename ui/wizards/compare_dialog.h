// SPDX-License-Identifier: Apache-2.0
// A calibration of the session beside the one in use: what differs, part by part. It can be used from here.
#pragma once

#include "ui/models/capture_context.h"
#include "ui/views/dialog_frame.h"

namespace noctule::ui {

class CompareDialog : public DialogFrame {
    Q_OBJECT
public:
    /// `other`: not the one in use.
    CompareDialog(CaptureContext& capture, const ShelvedCalibration& other, QWidget* parent = nullptr);
};

}  // namespace noctule::ui
