// SPDX-License-Identifier: Apache-2.0
// Where a table of another program begins. Programs write lines about the recording before it and units below
// its names.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/formats/csv_cells.h"
#include "core/formats/number_text.h"
#include "core/import/column_text.h"
#include "core/import/table_columns.h"

namespace noctule {
namespace {

constexpr size_t kLinesBeforeRows = 200, kRowsBelowNames = 50, kLinesOfUnits = 3;

bool isNumberOrInstant(const std::string& cell) {
    double value;
    return readCell(cell, true, value) || readInstant(cell);
}

bool isEmpty(const std::string& cell) {
    return cell.empty();
}

bool isComment(std::string_view line) {
    return line.starts_with("#") || line.starts_with("//");
}

/// Without the cell that a separator at the end of the line opens.
std::vector<std::string> cellsOfRow(std::string_view line, char separator) {
    std::vector<std::string> cells = cellsOfLine(line, separator);
    if (!cells.empty() && cells.back().empty())
        cells.pop_back();
    return cells;
}

/// `rows`: the text behind the line.
TableHead headOfLine(std::string_view line, std::string_view rows) {
    TableHead head;
    head.separator = separatorOf(line);
    head.names = cellsOfRow(line, head.separator);
    head.has_names = !std::ranges::all_of(head.names, isNumberOrInstant);
    head.rows = rows;
    return head;
}

bool fitsRows(const TableHead& head) {
    std::string_view rest = head.rows;
    size_t seen = 0, same = 0;
    while (!rest.empty() && seen < kRowsBelowNames) {
        const std::string_view line = cutLine(rest);
        if (trimmed(line).empty())
            continue;
        const std::vector<std::string> cells = cellsOfLine(line, head.separator);
        const bool trailing = cells.size() == head.names.size() + 1 && cells.back().empty();
        same += cells.size() == head.names.size() || trailing;
        ++seen;
    }
    return same > 0 && 2 * same >= seen;
}

/// Lines of words below the names, as many as these; the last of them says the units.
void takeUnitLines(TableHead& head) {
    for (size_t i = 0; i < kLinesOfUnits; ++i) {
        std::string_view rest = head.rows;
        std::vector<std::string> cells = cellsOfRow(cutLine(rest), head.separator);
        const bool are_words =
            std::ranges::none_of(
                cells, [](const std::string& cell) { return !isEmpty(cell) && isNumberOrInstant(cell); }) &&
            !std::ranges::all_of(cells, isEmpty);
        if (cells.size() != head.names.size() || !are_words || rest.empty())
            return;
        head.units = std::move(cells);
        head.rows = rest;
        ++head.first_line;
    }
}

}  // namespace

Result<TableHead> tableHead(std::string_view text, const std::string& path) {
    std::optional<TableHead> first;
    for (size_t number = 1; !text.empty() && number <= kLinesBeforeRows; ++number) {
        const std::string_view before = text;
        const std::string_view line = cutLine(text);
        if (trimmed(line).empty() || isComment(line))
            continue;
        TableHead head = headOfLine(line, text);
        if (head.names.size() < 2 || std::ranges::all_of(head.names, isEmpty))
            continue;
        head.first_line = number + 1;
        if (!head.has_names) {
            if (first)
                break;  // its rows begin, and none of the lines before fits them
            head.first_line = number;
            head.rows = before;
            for (size_t i = 0; i < head.names.size(); ++i)
                head.names[i] = "column " + std::to_string(i + 1);
            return head;
        }
        const bool fits = fitsRows(head);
        if (fits || !first)
            first = std::move(head);
        if (fits)
            break;
    }
    if (first) {
        takeUnitLines(*first);
        return *first;
    }
    return Error{ErrorKind::kUnreadable, path + ": no line has the names of columns or numbers",
                 "Give a table with comma, semicolon, tab or blank between its cells"};
}

}  // namespace noctule
