// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "core/formats/number_text.h"
#include "core/formats/opensim.h"
#include "core/job/atomic_file.h"

namespace noctule {
namespace {

constexpr int kTableDecimals = 9;

/// Whether the columns after time are quaternions.
bool holdsQuaternions(const OpenSimTable& table) {
    return table.width != table.columns.size();
}

std::string formatOpenSimTable(const OpenSimTable& table) {
    std::string text;
    for (const std::string& line : table.header)
        text += line + '\n';
    text += "endheader\n";
    for (size_t c = 0; c < table.columns.size(); ++c)
        text += (c ? "\t" : "") + table.columns[c];
    const bool quaternions = holdsQuaternions(table);
    for (size_t v = 0; v < table.values.size(); ++v) {
        const size_t in_row = v % table.width;
        text += in_row == 0 ? '\n' : quaternions && (in_row - 1) % 4 != 0 ? ',' : '\t';
        appendFixed(text, table.values[v], kTableDecimals);
    }
    return text + '\n';
}

std::vector<std::string> cellsOf(const std::string& line, const char* separators) {
    std::vector<std::string> cells;
    for (size_t begin = 0; begin <= line.size();) {
        const size_t end = std::min(line.find_first_of(separators, begin), line.size());
        cells.push_back(line.substr(begin, end - begin));
        begin = end + 1;
    }
    return cells;
}

bool isNan(std::string_view cell) {
    std::string lower(trimmed(cell));
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return lower == "nan" || lower == "-nan";
}

Status sameTable(const OpenSimTable& wanted, const Result<OpenSimTable>& read, const std::string& path) {
    bool same = read && read->columns == wanted.columns && read->header == wanted.header &&
                read->values.size() == wanted.values.size();
    for (size_t v = 0; same && v < wanted.values.size(); ++v)
        same = std::abs(read->values[v] - wanted.values[v]) <
               0.51 * std::pow(10, -kTableDecimals) + 1e-15 * std::abs(wanted.values[v]);
    if (same)
        return Done{};
    return Error{ErrorKind::kDisk,
                 path + ": what was written does not read back the same" +
                     (read ? "" : " (" + read.error().message + ")"),
                 "Check the disk and try again"};
}

}  // namespace

Result<OpenSimTable> parseOpenSimTable(const std::string& text, const std::string& where,
                                       MissingCells missing) {
    OpenSimTable table;
    size_t line_number = 0;
    const auto damaged = [&](const std::string& what) {
        return Error{ErrorKind::kUnreadable, where + ", line " + std::to_string(line_number) + ": " + what,
                     "Export the motion again"};
    };
    bool in_header = true;
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        begin = end + 1;
        ++line_number;
        if (in_header) {
            in_header = line != "endheader";
            if (in_header)
                table.header.push_back(line);
        } else if (table.columns.empty()) {
            table.columns = cellsOf(line, "\t");
            if (table.columns.front() != "time")
                return damaged("the first column is not time");
        } else {
            const std::vector<std::string> cells = cellsOf(line, "\t,");
            if (table.width == 0)
                table.width = cells.size();
            if (cells.size() != table.width)
                return damaged("it holds " + std::to_string(cells.size()) + " numbers instead of " +
                               std::to_string(table.width));
            for (size_t c = 0; c < cells.size(); ++c) {
                double& value = table.values.emplace_back();
                if (c > 0 && missing == MissingCells::kNan && isNan(cells[c]))
                    value = std::numeric_limits<double>::quiet_NaN();
                else if (!parseFiniteNumber(cells[c], value))
                    return damaged(inQuotes(cells[c]) + " is not a number");
            }
        }
    }
    if (table.rows() == 0)
        return damaged("it ends before the first row of numbers");
    return table;
}

Status writeOpenSimTable(const std::string& path, const OpenSimTable& table, bool overwrite) {
    return writeFileAtomically(
        path, formatOpenSimTable(table), overwrite, [&](const std::string& aside) -> Status {
            const auto text = readWholeFile(aside);
            return text ? sameTable(table, parseOpenSimTable(*text, path), path) : Status(text.error());
        });
}

}  // namespace noctule
