// SPDX-License-Identifier: Apache-2.0
// What the open take was made with: calibration, suit, skeleton, dates.
#pragma once

#include <QWidget>

#include "ui/models/review_context.h"

namespace noctule::ui {

class Label;

class MadeWithPanel : public QWidget {
    Q_OBJECT
public:
    explicit MadeWithPanel(ReviewContext& review, QWidget* parent = nullptr);

private:
    void refresh();

    ReviewContext& review_;
    Label *performer_, *recorded_, *offsets_, *inertial_, *rest_, *skeleton_, *suit_, *sound_;
};

}  // namespace noctule::ui
