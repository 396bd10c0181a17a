// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/source_offsets/measured_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/formats/csv_cells.h"
#include "core/formats/number_text.h"
#include "core/formats/text_file.h"

namespace noctule {
namespace {

std::string inLowerCase(std::string text) {
    for (char& c : text)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
    return text;
}

bool isBlankRow(const std::vector<std::string>& cells) {
    return std::ranges::all_of(cells, &std::string::empty);
}

}  // namespace

Result<MeasuredTable> MeasuredTable::parse(std::string_view text, const std::string& where) {
    const std::optional<std::string> decoded = fromUtf16(text);
    text = decoded ? std::string_view(*decoded) : withoutByteOrderMark(text);
    MeasuredTable table(where);
    if (text.find('\0') != std::string_view::npos)
        return Error{ErrorKind::kUnreadable, where + " is no plain text", "Save the table as CSV in UTF-8"};
    for (size_t number = 1; !text.empty(); ++number)
        if (const Status added = table.addLine(cutLine(text), number); !added)
            return added.error();
    if (table.header_.empty())
        return Error{ErrorKind::kUnreadable, where + " is empty",
                     "Give a table with a header and one row per measurement"};
    if (table.rows_.empty())
        return table.headerError("no row follows the header", "Add one row per measurement");
    return table;
}

Status MeasuredTable::addLine(std::string_view line, size_t number) {
    if (trimmed(line).empty())
        return Done{};
    return header_.empty() ? readHeader(line, number) : readRow(line, number);
}

Status MeasuredTable::readHeader(std::string_view line, size_t number) {
    header_line_ = number;
    separator_ = csvSeparator(line);
    const CsvCells parts = csvCells(line, separator_);
    if (parts.quote_stays_open)
        return headerError("a quotation mark stays open", "Close it in the same line");
    for (const std::string& cell : parts.cells) {
        std::string name = inLowerCase(cell);
        if (!name.empty() && column(name))
            return headerError("two columns are named " + inQuotes(name), "Keep one of them");
        header_.push_back(std::move(name));
    }
    return Done{};
}

Status MeasuredTable::readRow(std::string_view line, size_t number) {
    auto [cells, quote_stays_open] = csvCells(line, separator_);
    if (quote_stays_open)
        return error(number, "a quotation mark stays open", "Close it in the same line");
    if (isBlankRow(cells))
        return Done{};
    while (cells.size() > header_.size() && cells.back().empty())
        cells.pop_back();
    if (cells.size() > header_.size())
        return error(number,
                     "there are " + std::to_string(cells.size()) + " cells under " +
                         std::to_string(header_.size()) + " columns",
                     separator_ == ',' ? "Write decimals with a point, or put semicolons between the cells"
                                       : "Remove what is too much");
    cells.resize(header_.size());
    rows_.push_back({number, std::move(cells)});
    return Done{};
}

std::optional<size_t> MeasuredTable::column(std::string_view name) const {
    const auto found = std::ranges::find(header_, name);
    return found == header_.end() ? std::nullopt : std::optional<size_t>(found - header_.begin());
}

Result<std::string> MeasuredTable::word(size_t row, size_t column) const {
    const std::string& cell = rows_[row].cells[column];
    if (cell.empty())
        return rowError(row, "column " + header_[column] + " is empty", "Fill it in or remove the row");
    return cell;
}

Result<double> MeasuredTable::number(size_t row, size_t column) const {
    const Result<std::string> cell = word(row, column);
    if (!cell)
        return cell.error();
    const std::string text = withDecimalPoint(*cell);
    const char* begin = text.data() + (text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
    const char* end = text.data() + text.size();
    double value = 0;
    const auto [after, problem] = std::from_chars(begin, end, value);
    if (problem != std::errc() || after != end || !std::isfinite(value))
        return rowError(row, "column " + header_[column] + " is " + inQuotes(*cell),
                        "Give a number such as 0.512");
    return value;
}

Error MeasuredTable::headerError(const std::string& what, const std::string& remedy) const {
    return error(header_line_, what, remedy);
}

Error MeasuredTable::rowError(size_t row, const std::string& what, const std::string& remedy) const {
    return error(rows_[row].line, what, remedy);
}

Error MeasuredTable::error(size_t line, const std::string& what, const std::string& remedy) const {
    return {ErrorKind::kUnreadable, where_ + ", line " + std::to_string(line) + ": " + what, remedy};
}

}  // namespace noctule
