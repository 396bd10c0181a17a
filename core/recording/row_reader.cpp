// SPDX-License-Identifier: Apache-2.0
#include "core/recording/row_reader.h"

namespace noctule {

void SkipLog::add(const std::string& what, const std::string& row, const std::string& why, int64_t count) {
    SkippedRows& skipped = rows_[what];
    if (skipped.count == 0) {
        skipped.table = what;
        skipped.first = "row " + row + ": " + why;
    }
    skipped.count += count;
}

void SkipLog::explain(const std::string& what, const std::string& why) {
    if (const auto skipped = rows_.find(what); skipped != rows_.end())
        skipped->second.first += "; " + why;
}

std::vector<SkippedRows> SkipLog::all() const {
    std::vector<SkippedRows> all;
    for (const auto& entry : rows_)
        all.push_back(entry.second);
    return all;
}

std::string rowsOfSuit(const std::string& table, int suit) {
    return suit == 1 ? table : table + " of suit " + std::to_string(suit);
}

bool isSample(std::optional<int64_t> sample) {
    return sample && *sample >= 0 && *sample <= kLastSample;
}

}  // namespace noctule
