// SPDX-License-Identifier: Apache-2.0
// Rows with instants, placed on an even grid: lost rows become empty ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/job/result.h"

namespace noctule {

struct RowGrid {
    double rate_hz = 0;
    double start_s = 0;        ///< instant of grid row 0
    size_t rows = 0;           ///< of the grid
    std::vector<size_t> from;  ///< per grid row the given row, or kNoRow
    size_t lost = 0;           ///< grid rows without a given one
    size_t gaps = 0;           ///< runs of them
    size_t backwards = 0;      ///< given rows left out since the clock did not go on
    double longest_gap_s = 0;

    static constexpr size_t kNoRow = size_t(-1);
    /// Sentences for a recording's warnings; empty when all is well.
    std::vector<std::string> findings(const std::string& who) const;
};

/// The rate is that of the usual step between rows. NaN instants are left out. kUnreadable: fewer than two
/// rows, no rate between 1 and 10000 Hz, or gaps that are longer than the rows together fivefold.
Result<RowGrid> gridOfTimes(const std::vector<double>& time_s, const std::string& where);
/// The same with whole numbers that count rows, and a known rate.
Result<RowGrid> gridOfCounts(const std::vector<int64_t>& counts, double rate_hz, const std::string& where);

}  // namespace noctule
