// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace noctule {

/// The cells of one line of a table, blanks around them cut off; quotes as in RFC 4180, but no line breaks
/// within them.
struct CsvCells {
    std::vector<std::string> cells;
    bool quote_stays_open = false;
};

CsvCells csvCells(std::string_view line, char separator);

}  // namespace noctule
