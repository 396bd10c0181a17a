// SPDX-License-Identifier: Apache-2.0
// The take in one word and the reasons for it, worst first.
#pragma once

#include "core/job/grade.h"
#include "core/report/report_data.h"

namespace noctule {

struct Verdict {
    Grade grade = Grade::kUnknown;
    std::string headline;              ///< "Good. Mean joint error 0.7° against the simulated truth."
    std::vector<std::string> reasons;  ///< whole sentences; empty when nothing is wrong
};

/// Mean joint error: the paper's complete system had 5.7 to 8.0 degrees and was a success; an animator sees
/// less than about 3.
inline constexpr double kGoodMean_deg = 3, kUsableMean_deg = 8;
/// A single joint whose mean is worse than this makes a take usable at best.
inline constexpr double kGoodJoint_deg = 8;
/// Share of a board's readings below which it is named.
inline constexpr double kGoodReadings = 0.98, kUsableReadings = 0.80;
/// Share of the heard ranges that the gate may throw out without remark.
inline constexpr double kManyRejected = 0.15;

Verdict judge(const ReportData& data);
std::string gradeName(Grade grade);  ///< "Good", "Usable", "Not usable", "Not judged"

}  // namespace noctule
