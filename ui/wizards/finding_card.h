// SPDX-License-Identifier: Apache-2.0
// A finding of a calibration or a survey as a card: what is wrong, and what to do.
#pragma once

#include "core/calibration/findings.h"
#include "ui/style/ink.h"

namespace noctule::ui {

class ProblemCard;

Tone toneOf(const Finding& finding);
ProblemCard* findingCard(const Finding& finding, Tone tone);

}  // namespace noctule::ui
