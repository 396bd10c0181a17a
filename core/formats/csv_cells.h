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

/// The one of comma, semicolon and tab that stands most often in a header outside of quotes.
char csvSeparator(std::string_view header);

/// "0,25" as "0.25": with one comma and no point. Others stay as they are.
std::string withDecimalPoint(std::string_view cell);

/// The next line without its end, which is CRLF, LF or CR; `text` goes on behind it.
std::string_view cutLine(std::string_view& text);

}  // namespace noctule
