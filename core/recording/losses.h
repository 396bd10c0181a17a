// SPDX-License-Identifier: Apache-2.0
// What of a damaged take could be read, and what could not.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace noctule {

struct TableLoss {
    std::string table;
    int64_t saved = 0;              ///< rows
    std::optional<int64_t> lost{};  ///< rows, an estimate from the pages that hold them; absent: unknown
};

struct TakeLosses {
    std::vector<TableLoss> tables;   ///< those of which something is lost
    std::optional<double> sound_s;   ///< of the one suit's sound, when something of it is lost
    double whole_sound_s = 0;        ///< as it was recorded, with `sound_s`
    bool may_have_had_more = false;  ///< the list of tables is damaged
    int64_t mended_texts = 0;        ///< in which U+FFFD stands for bytes that are no UTF-8
    bool empty() const { return tables.empty() && !may_have_had_more; }
};

/// "Saved of it: 41.00 s of 60.00 s of the sound, nothing of the list of notes; everything else is complete"
std::string savedText(const TakeLosses& losses);

}  // namespace noctule
