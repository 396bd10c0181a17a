// SPDX-License-Identifier: Apache-2.0
// What Review says of runs and verdicts.
#pragma once

#include <QString>

#include "core/report/take_verdict.h"
#include "core/review/take_review.h"
#include "ui/style/ink.h"

namespace noctule::ui {

/// "All sensors", "Gyroscopes only", "Filter of the paper, gyroscopes only".
QString runInWords(const RunSettings& settings);
/// Of several: "Ada, Ben: together, with ranges between them". One performer: empty.
QString peopleInWords(const ReviewRun& run);
/// The name that the operator gave it, else what it was made from; a second one of a kind has its number.
QString runTitle(const ReviewRun& run);
/// "2: All sensors", as the list of results in Review numbers them.
QString numberedTitle(const ReviewRun& run);

Tone toneOf(Grade grade);
/// "Good take". kUnknown is never asked for: what is judged has a run, or is not usable.
QString gradeInWords(Grade grade);
/// One or two sentences below the grade.
QString gradeExplained(const TakeVerdict& verdict);

struct ProblemWords {
    Tone tone = Tone::kWarn;
    QString title, text;
    QString action;                ///< "Show left knee"; empty: none
    QString joint;                 ///< that the action chooses, or
    int board = -1;                ///< the board that it chooses
    bool processes = false;        ///< the action asks how to process the take
    bool with_gyroscopes = false;  ///< which it proposes
    double time_s = -1;            ///< where it puts the cursor; negative: nowhere
};
/// What lowered the grade, worst first.
std::vector<ProblemWords> problemsInWords(const TakeVerdict& verdict, const TakeOverview& overview);

}  // namespace noctule::ui
