// SPDX-License-Identifier: Apache-2.0
// Which pairs the report draws in full, and how boards are grouped under the heat map.
#pragma once

#include <string>
#include <vector>

#include "core/report/report_data.h"

namespace noctule {

/// The asked-for pairs; without any those of the paper's figure 5: two sources (the first and the last, belly
/// and hat) by three boards (chest, thigh, foot; else the first three). Pairs without pulses are left out.
std::vector<const ReportPair*> chosenPairs(const ReportData& data);

/// Neighbouring boards on the same part of the body.
struct BoardGroup {
    std::string name;  ///< "Left arm"
    int first = 0, last = 0;
};
std::vector<BoardGroup> boardGroups(const ReportData& data);

}  // namespace noctule
