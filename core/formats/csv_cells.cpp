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

}  // namespace noctule
