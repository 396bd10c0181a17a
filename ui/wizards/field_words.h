// SPDX-License-Identifier: Apache-2.0
// What the wizard of the magnetometers says of the moment: what to do in words that are read from three
// metres, the sentence beside the ring, and the three checks.
#pragma once

#include "ui/wizards/wizard_words.h"

namespace noctule::ui {

/// "the lower side"
QString sideName(FieldSide side);
/// "Turn it upside down"
QString fieldInstruction(const WizardRun& run);
LiveSentence fieldSentence(const WizardRun& run);
std::vector<LiveMeasure> fieldMeasures(const FieldGuide& guide);

/// What a step that is done has found, for the rail: "48.1 µT, even within 1.9 %"; empty: it is not done.
QString fieldFound(const FieldGuide& guide, int step);
/// "Right hand (sensor 9)"
QString sensorName(const WizardRun& run, int board);
/// "12 % stronger", "4 % weaker"
QString strongerText(double percent);
/// "48.1 µT ±0.9"
QString microteslaText(double value_ut, std::optional<double> sigma_ut = {});

}  // namespace noctule::ui
