// SPDX-License-Identifier: Apache-2.0
// The take in one word and the reasons for it, worst first: take_verdict.h in sentences.
#pragma once

#include "core/job/grade.h"
#include "core/report/report_data.h"

namespace noctule {

struct Verdict {
    Grade grade = Grade::kUnknown;
    std::string headline;              ///< "Good. Mean joint error 0.7° against the simulated truth."
    std::vector<std::string> reasons;  ///< whole sentences; empty when nothing is wrong
};

/// Share of a board's readings below which it is named.
inline constexpr double kGoodReadings = 0.98;
/// Share of the heard ranges that the gate may throw out without remark.
inline constexpr double kManyRejected = 0.15;

Verdict judge(const ReportData& data);
std::string gradeName(Grade grade);  ///< "Good", "Usable", "Not usable"; "Not judged": there is no run

}  // namespace noctule
