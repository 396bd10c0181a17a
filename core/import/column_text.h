// SPDX-License-Identifier: Apache-2.0
// Columns of numbers out of text tables. Empty cells and NaN are missing values; anything else that is no
// number is an error with line and column.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/job/job.h"

namespace noctule {

inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

struct ColumnRequest {
    char separator = ',';
    std::vector<std::string> names;   ///< the header's cells: a row has as many
    std::vector<size_t> wanted;       ///< indices in `names`
    size_t first_line = 2;            ///< number of the first row's line, for messages
    bool decimal_comma = false;       ///< "0,25" is a number
    std::optional<size_t> time = {};  ///< in `names`: its cells may be dates
};

struct NumberColumns {
    std::vector<std::vector<double>> columns;  ///< one for each wanted
    size_t rows = 0;
    size_t missing = 0;  ///< cells that hold no number
    /// The last line has no end, so it may have been cut anywhere: it was left out.
    bool cut = false;
    // Of times of day without a date: the longest step ahead, midnights counted, and the longest one back.
    double longest_hole_s = 0, longest_return_s = 0;
};

/// Cells are split at every separator; a quoted cell may hold it. Empty lines are skipped, and a separator
/// behind the last cell is ignored. kUnreadable: no rows, a row of another width, a cell that is no number.
Result<NumberColumns> columnsOfText(std::string_view text, const ColumnRequest& request,
                                    const std::string& where, const JobContext& job);

/// Cells as texts, quotes and blanks around them cut off.
std::vector<std::string> cellsOfLine(std::string_view line, char separator);

/// The one of tab, semicolon, comma and space that stands most often in a header.
char separatorOf(std::string_view header);

/// A number, or kMissing for nothing, NaN or infinity; false when it is neither.
bool readCell(std::string_view cell, bool decimal_comma, double& value);

/// "2024-05-01T10:00:00.25Z", "2024/05/01 10:00:00,25", "10:00:00.25": seconds since 1970, or of the day.
/// Nothing when it is no such instant. Without a zone it counts as UTC.
std::optional<double> readInstant(std::string_view cell);
/// The same with a date: nothing for a time of day alone.
std::optional<double> readDateAndTime(std::string_view text);

}  // namespace noctule
