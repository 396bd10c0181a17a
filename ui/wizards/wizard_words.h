// SPDX-License-Identifier: Apache-2.0
// What a wizard's page says about the moment: the live sentence with its reason, the measures and their
// limits, and what skipping a board costs.
#pragma once

#include <vector>

#include "ui/style/ink.h"
#include "ui/wizards/wizard_run.h"

namespace noctule::ui {

struct LiveSentence {
    Tone tone = Tone::kNeutral;
    QString sentence;  ///< "Not yet: board 7 sits 4.2° askew in its slot"
    QString detail;    ///< which, why and what to do
};
LiveSentence sentenceOf(const WizardRun& run);

struct LiveMeasure {
    QString name, value;  ///< "Still", "0.02 m/s², limit 0.20"
    double share = 0;     ///< of the limit, 0..1
    bool is_right = false;
};
std::vector<LiveMeasure> measuresOf(const WizardRun& run);

/// What the calibration lacks when a board is left out of it.
QString costOfSkipping(const WizardRun& run, int board);

}  // namespace noctule::ui
