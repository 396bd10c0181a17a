// SPDX-License-Identifier: Apache-2.0
#include "core/formats/csv_cells.h"

#include "core/formats/number_text.h"

namespace noctule {

CsvCells csvCells(std::string_view line, char separator) {
    std::vector<std::string> cells(1);
    bool within_quotes = false;
    for (size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && within_quotes && i + 1 < line.size() && line[i + 1] == '"')
            cells.back() += line[++i];
        else if (line[i] == '"')
            within_quotes = !within_quotes;
        else if (line[i] == separator && !within_quotes)
            cells.emplace_back();
        else
            cells.back() += line[i];
    }
    for (std::string& cell : cells)
        cell = std::string(trimmed(cell));
    return {std::move(cells), within_quotes};
}

char csvSeparator(std::string_view header) {
    char best = ',';
    size_t most = 1;
    for (const char separator : {';', '\t', ','})
        if (const size_t cells = csvCells(header, separator).cells.size(); cells > most)
            most = cells, best = separator;
    return best;
}

std::string withDecimalPoint(std::string_view cell) {
    std::string text(cell);
    const size_t comma = text.find(',');
    if (comma != std::string::npos && text.find(',', comma + 1) == std::string::npos &&
        text.find('.') == std::string::npos)
        text[comma] = '.';
    return text;
}

std::string_view cutLine(std::string_view& text) {
    const size_t end = text.find_first_of("\r\n");
    const std::string_view line = text.substr(0, end);
    if (end == std::string_view::npos)
        text = {};
    else
        text.remove_prefix(end + (text.substr(end, 2) == "\r\n" ? 2 : 1));
    return line;
}

}  // namespace noctule
