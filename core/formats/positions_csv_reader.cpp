// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "core/formats/csv_cells.h"
#include "core/formats/number_text.h"
#include "core/formats/positions_csv.h"
#include "core/formats/text_file.h"

namespace noctule {
namespace {

constexpr size_t kAbsent = static_cast<size_t>(-1);

using Cells = std::vector<std::string>;

/// Of a column that holds the time, by its name: "time_s", "Time [ms]"; 0 of others.
double timeUnit_s(const std::string& name) {
    std::string letters;
    for (const char c : name)
        if (std::isalpha(static_cast<unsigned char>(c)))
            letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const auto& [known, unit_s] :
         {std::pair{"times", 1.0}, std::pair{"timesec", 1.0}, std::pair{"timeseconds", 1.0},
          std::pair{"timems", 1e-3}, std::pair{"timemsec", 1e-3}, std::pair{"timemilliseconds", 1e-3},
          std::pair{"timeus", 1e-6}, std::pair{"timemicroseconds", 1e-6}, std::pair{"timens", 1e-9},
          std::pair{"timenanoseconds", 1e-9}})
        if (letters == known)
            return unit_s;
    return 0;
}

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
        if (falling_rows_ > 0)
            return fallingError();
        warnOfJumps();
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
            line_ = trimmed(cutLine(rest_));
            ++line_number_;
            if (!line_.empty())
                return true;
        }
        return false;
    }

    Status readHeader();
    Status findColumns();
    Status readRow();
    Error fallingError() const;
    void warnOfJumps();
    Result<Cells> rowCells() const;
    Result<double> number(const Cells& cells, size_t column) const;

    std::string_view rest_;
    const std::string& where_;
    std::string_view line_;
    size_t line_number_ = 0;
    char separator_ = ',';
    Cells header_;
    size_t time_column_ = kAbsent;
    double time_unit_s_ = 1;
    std::vector<size_t> lines_;                 ///< of the rows
    size_t falling_rows_ = 0, first_fall_ = 0;  ///< rows that are not later than the one before; a line
    std::string first_fall_text_;
    std::vector<std::array<size_t, 3>> columns_;  ///< per joint those of x, y and z
    PositionTable table_;
};

Status PositionsReader::readHeader() {
    if (!nextLine())
        return Error{ErrorKind::kUnreadable, where_ + " is empty",
                     "Give a table with time_s and JOINT.x, .y, .z"};
    separator_ = csvSeparator(line_);
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
        const double unit_s = timeUnit_s(name);
        size_t* column = unit_s > 0 ? &time_column_ : nullptr;
        if (column)
            time_unit_s_ = unit_s;
        if (axis < 3) {
            const auto [joint, is_new] = joint_index.emplace(name.substr(0, dot), table_.joints.size());
            if (is_new) {
                table_.joints.push_back(joint->first);
                columns_.push_back({kAbsent, kAbsent, kAbsent});
            }
            column = &columns_[joint->second][axis];
        }
        if (column && *column != kAbsent)
            return error(unit_s > 0 ? "two columns hold the time" : "two columns are named " + inQuotes(name),
                         "Keep one of them");
        if (column)
            *column = c;
    }
    if (time_column_ == kAbsent)
        return error("there is no column time_s",
                     "Name the column with the time time_s for seconds or time_ms for milliseconds");
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
    if (parseFiniteNumber(withDecimalPoint(cells[column]), value))
        return value;
    return error(header_[column] + " is " + inQuotes(cells[column]),
                 "Give a finite number with a decimal point, or leave the row out");
}

Result<Cells> PositionsReader::rowCells() const {
    Cells cells = csvCells(line_, separator_).cells;
    if (cells.size() != header_.size())
        return error("this row has " + std::to_string(cells.size()) + " cells, but the header has " +
                         std::to_string(header_.size()),
                     separator_ == ',' && cells.size() > header_.size()
                         ? "Write decimals with a point, or put semicolons between the cells"
                         : "Give every row one cell per column");
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
    const double seconds = *time_s * time_unit_s_;
    if (!table_.time_s.empty() && seconds <= table_.time_s.back() && falling_rows_++ == 0) {
        first_fall_ = line_number_;
        first_fall_text_ = cells[time_column_];
    }
    table_.time_s.push_back(seconds);
    lines_.push_back(line_number_);
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

Error PositionsReader::fallingError() const {
    const std::string more =
        falling_rows_ > 1 ? ", nor in " + std::to_string(falling_rows_ - 1) + " other rows" : "";
    return {ErrorKind::kUnreadable,
            where_ + ", line " + std::to_string(first_fall_) + ": " + header_[time_column_] +
                " does not rise (" + first_fall_text_ + ")" + more,
            "Sort the rows by time, each time once; where the clock was set anew, cut the table there"};
}

/// Holes of ten usual steps and more, half a second at least.
void PositionsReader::warnOfJumps() {
    std::vector<double> steps_s;
    for (size_t i = 1; i < table_.time_s.size(); ++i)
        steps_s.push_back(table_.time_s[i] - table_.time_s[i - 1]);
    if (steps_s.size() < 3)
        return;
    std::vector<double> sorted_s = steps_s;
    std::ranges::nth_element(sorted_s, sorted_s.begin() + static_cast<std::ptrdiff_t>(sorted_s.size() / 2));
    const double least_s = std::max(0.5, 10 * sorted_s[sorted_s.size() / 2]);
    const auto jumps = [&](double step_s) { return step_s >= least_s; };
    const auto first = std::ranges::find_if(steps_s, jumps);
    if (first == steps_s.end())
        return;
    std::string length;
    appendFixed(length, *first, 3);
    table_.warnings.push_back(
        where_ + ": the clock jumps at " + std::to_string(std::ranges::count_if(steps_s, jumps)) + " of " +
        std::to_string(table_.time_s.size()) + " rows, first by " + length + " s in line " +
        std::to_string(lines_[static_cast<size_t>(first - steps_s.begin()) + 1]) + ".");
}

}  // namespace

Result<PositionTable> parsePositionsCsv(std::string_view text, const std::string& where) {
    if (const std::optional<std::string> decoded = fromUtf16(text))
        return PositionsReader(*decoded, where).read();
    return PositionsReader(withoutByteOrderMark(text), where).read();
}

Result<std::vector<double>> readNumberColumns(const std::string& path,
                                              const std::vector<std::string>& names) {
    const Result<std::string> text = readTextFile(path);
    return text ? PositionsReader(*text, path).readColumns(names) : text.error();
}

Result<PositionTable> readPositionsCsv(const std::string& path, const CancelFlag* cancel) {
    const Result<std::string> text = readTextFile(path, cancel);
    return text ? parsePositionsCsv(*text, path) : text.error();
}

}  // namespace noctule
