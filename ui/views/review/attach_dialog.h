// SPDX-License-Identifier: Apache-2.0
// How another system's recording of the performance goes into the take: as what, and when it begins.
#pragma once

#include <optional>

#include "core/processing/attach_reference.h"
#include "core/review/take_review.h"
#include "ui/views/dialog_frame.h"

class QDoubleSpinBox;

namespace noctule::ui {

class ChoiceRow;
class Label;

struct AttachChoice {
    QString path;
    AttachAs as = AttachAs::kReference;
    std::optional<double> shift_s;  ///< none: found by motion
    bool overwrite = false;
};

class AttachDialog : public DialogFrame {
    Q_OBJECT
public:
    AttachDialog(const TakeOverview& overview, const QString& path, QWidget* parent = nullptr);

    AttachChoice choice() const;

    ChoiceRow *as_reference, *as_external_root;
    ChoiceRow *align_auto, *align_given;
    QDoubleSpinBox* milliseconds;

private:
    void refresh();

    const QString path_;
    const bool is_positions_, has_reference_, has_external_root_, has_result_;
    Label* replaces_;
};

}  // namespace noctule::ui
