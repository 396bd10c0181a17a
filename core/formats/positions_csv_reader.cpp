// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <map>

#include "core/formats/csv_cells.h"
#include "core/formats/number_text.h"
#include "core/formats/positions_csv.h"
#include "core/job/atomic_file.h"

namespace noctule {
namespace {

constexpr size_t kAbsent = static_cast<size_t>(-1);

using Cells = std::vector<std::string>;

class PositionsReader {
public:
    PositionsReader(std::string_view text, const std::string& where) : rest_(text), where_(where) {}

    Result<PositionTable> read() {
        if (Status header = readHeader(); !header)
            return header.error();
        while (nextLine())
            if (Status row = readRow(); !row)
                return row.error();
        if (table_.time_s.empty())
            return error("no row follows the header", "Give at least one row of positions");
        return std::move(table_);
    }

    Result<std::vector<double>> readColumns(const std::vector<std::string>& names) {
        if (Status header = readHeader(); !header)
            return header.error();
        std::vector<size_t> columns;
        for (const std::string& name : names) {
            const auto found = std::find(header_.begin(), header_.end(), name);
            if (found == header_.end())
                return error("there is no column " + name, "Write the table again with its angles");
            columns.push_back(static_cast<size_t>(found - header_.begin()));
        }
        std::vector<double> values;
        while (nextLine()) {
            const Result<Cells> cells = rowCells();
            if (!cells)
                return cells.error();
            for (const size_t column : columns) {
                const Result<double> value = number(*cells, column);
                if (!value)
                    return value.error();
                values.push_back(*value);
            }
        }
        return values;
    }

private:
    Error error(const std::string& what, const std::string& remedy) const {
        return {ErrorKind::kUnreadable, where_ + ", line " + std::to_string(line_number_) + ": " + what,
                remedy};
    }

    /// The next line that is not blank.
    bool nextLine() {
        while (!rest_.empty()) {
            const size_t end = rest_.find('\n');
            line_ = trimmed(rest_.substr(0, end));
            rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
            ++line_number_;
            if (!line_.empty())
                return true;
        }
        return false;
    }

    Status readHeader();
    Status findColumns();
    Status readRow();
    Result<Cells> rowCells() const;
    Result<double> number(const Cells& cells, size_t column) const;

    std::string_view rest_;
    const std::string& where_;
    std::string_view line_;
    size_t line_number_ = 0;
    char separator_ = ',';
    Cells header_;
    size_t time_column_ = kAbsent;
    std::vector<std::array<size_t, 3>> columns_;  ///< per joint those of x, y and z
    PositionTable table_;
};

Status PositionsReader::readHeader() {
    if (!nextLine())
        return Error{ErrorKind::kUnreadable, where_ + " is empty",
                     "Give a table with time_s and JOINT.x, .y, .z"};
    for (const char separator : {',', ';', '\t'})
        if (line_.find(separator) != std::string_view::npos) {
            separator_ = separator;
            break;
        }
    header_ = csvCells(line_, separator_).cells;
    return findColumns();
}

Status PositionsReader::findColumns() {
    std::map<std::string, size_t> joint_index;
    for (size_t c = 0; c < header_.size(); ++c) {
        const std::string& name = header_[c];
        const size_t dot = name.rfind('.');
        const size_t axis = dot == std::string::npos || dot + 2 != name.size()
                                ? kAbsent
                                : std::string_view("xyz").find(name[dot + 1]);
        size_t* column = name == "time_s" ? &time_column_ : nullptr;
        if (axis < 3) {
            const auto [joint, is_new] = joint_index.emplace(name.substr(0, dot), table_.joints.size());
            if (is_new) {
                table_.joints.push_back(joint->first);
                columns_.push_back({kAbsent, kAbsent, kAbsent});
            }
            column = &columns_[joint->second][axis];
        }
        if (column && *column != kAbsent)
            return error("two columns are named " + inQuotes(name), "Keep one of them");
        if (column)
            *column = c;
    }
    if (time_column_ == kAbsent)
        return error("there is no column time_s", "Name the column with the time in seconds time_s");
    if (table_.joints.empty())
        return error("there is no column JOINT.x",
                     "Name the columns LeftHand.x, LeftHand.y, LeftHand.z and so on");
    for (size_t j = 0; j < columns_.size(); ++j)
        for (size_t axis = 0; axis < 3; ++axis)
            if (columns_[j][axis] == kAbsent)
                return error(
                    "joint " + table_.joints[j] + " has no column " + table_.joints[j] + "." + "xyz"[axis],
                    "Give x, y and z of every joint");
    return Done{};
}

Result<double> PositionsReader::number(const Cells& cells, size_t column) const {
    double value = 0;
    if (parseFiniteNumber(cells[column], value))
        return value;
    return error(header_[column] + " is " + inQuotes(cells[column]),
                 "Give a finite number with a decimal point, or leave the row out");
}

Result<Cells> PositionsReader::rowCells() const {
    Cells cells = csvCells(line_, separator_).cells;
    if (cells.size() != header_.size())
        return error("this row has " + std::to_string(cells.size()) + " cells, but the header has " +
                         std::to_string(header_.size()),
                     "Give every row one cell per column");
    return cells;
}

Status PositionsReader::readRow() {
    const Result<Cells> row = rowCells();
    if (!row)
        return row.error();
    const Cells& cells = *row;
    const Result<double> time_s = number(cells, time_column_);
    if (!time_s)
        return time_s.error();
    if (!table_.time_s.empty() && *time_s <= table_.time_s.back())
        return error("time_s does not rise (" + cells[time_column_] + ")",
                     "Sort the rows by time, each time once");
    table_.time_s.push_back(*time_s);
    for (const std::array<size_t, 3>& columns : columns_) {
        Vector3d p_world_m;
        for (size_t axis = 0; axis < 3; ++axis) {
            const Result<double> value = number(cells, columns[axis]);
            if (!value)
                return value.error();
            p_world_m[static_cast<int>(axis)] = *value;
        }
        table_.p_world_m.push_back(p_world_m);
    }
    return Done{};
}

}  // namespace

Result<PositionTable> parsePositionsCsv(std::string_view text, const std::string& where) {
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    return PositionsReader(text, where).read();
}

Result<std::vector<double>> readNumberColumns(const std::string& path,
                                              const std::vector<std::string>& names) {
    const Result<std::string> text = readWholeFile(path);
    return text ? PositionsReader(*text, path).readColumns(names) : text.error();
}

Result<PositionTable> readPositionsCsv(const std::string& path) {
    const Result<std::string> text = readWholeFile(path);
    return text ? parsePositionsCsv(*text, path) : text.error();
}

}  // namespace noctule
