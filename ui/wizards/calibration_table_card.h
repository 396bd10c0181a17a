// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/report/calibration_document.h"
#include "ui/models/part_names.h"
#include "ui/widgets/card.h"

namespace noctule::ui {

/// A table of a calibration: its title, how to read it, and rows with their numbers at the right.
class CalibrationTableCard : public Card {
    Q_OBJECT
public:
    explicit CalibrationTableCard(const CalibrationTable& table, QWidget* parent = nullptr);
};

/// With the parts' names on this suit instead of their ids, in the first cells.
CalibrationTable named(CalibrationTable table, const PartNames& names);

}  // namespace noctule::ui
