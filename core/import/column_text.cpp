// SPDX-License-Identifier: Apache-2.0
#include "core/import/column_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/formats/csv_cells.h"
#include "core/formats/number_text.h"

namespace noctule {

namespace {

bool isWord(std::string_view cell, std::string_view word) {
    return cell.size() == word.size() &&
           std::equal(cell.begin(), cell.end(), word.begin(),
                      [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// `blank_separates`: the separator is a blank, so blanks are not cut off the line.
class RowSplitter {
public:
    explicit RowSplitter(char separator) : separator_(separator) {}

    const std::vector<std::string_view>& split(std::string_view line) {
        cells_.clear();
        size_t begin = 0;
        bool quoted = false;
        for (size_t i = 0; i <= line.size(); ++i) {
            if (i < line.size() && line[i] == '"')
                quoted = !quoted;
            if (i < line.size() && (quoted || line[i] != separator_))
                continue;
            cells_.push_back(bare(line.substr(begin, i - begin)));
            begin = i + 1;
        }
        return cells_;
    }

private:
    static std::string_view bare(std::string_view cell) {
        cell = trimmed(cell);
        if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
            cell = trimmed(cell.substr(1, cell.size() - 2));
        return cell;
    }

    char separator_;
    std::vector<std::string_view> cells_;
};

/// Reads row after row into the columns.
class ColumnReader {
public:
    ColumnReader(const ColumnRequest& request, const std::string& where)
        : request_(request), where_(where), splitter_(request.separator) {
        result_.columns.resize(request.wanted.size());
    }

    Status add(std::string_view line, size_t number) {
        const auto& cells = splitter_.split(line);
        const size_t width = request_.names.size();
        const bool trailing = cells.size() == width + 1 && cells.back().empty();
        if (cells.size() != width && !trailing)
            return damaged(number, "it has " + std::to_string(cells.size()) + " cells instead of " +
                                       std::to_string(width));
        for (size_t i = 0; i < request_.wanted.size(); ++i) {
            const std::string_view cell = cells[request_.wanted[i]];
            double value = kMissing;
            if (!readCell(cell, request_.decimal_comma, value) &&
                !(request_.wanted[i] == request_.time && readTime(cell, value)))
                return damaged(number, "column " + request_.names[request_.wanted[i]] + " holds " +
                                           inQuotes(cell) + ", which is no number");
            result_.missing += std::isnan(value);
            result_.columns[i].push_back(value);
        }
        ++result_.rows;
        return Done{};
    }
    NumberColumns take() { return std::move(result_); }
    void cut() { result_.cut = true; }
    Error damaged(size_t line, const std::string& what) const {
        return {ErrorKind::kUnreadable, where_ + ", line " + std::to_string(line) + ": " + what,
                "Export the recording again"};
    }

private:
    /// Times of day begin anew at midnight.
    bool readTime(std::string_view cell, double& value) {
        constexpr double kDay_s = 86400;
        const auto instant = readInstant(cell);
        if (!instant)
            return false;
        const bool is_of_day = *instant <= kDay_s;
        if (is_of_day && last_of_day_s_) {
            double step_s = *instant - *last_of_day_s_;
            if (step_s < -kDay_s / 2) {
                midnights_s_ += kDay_s;
                step_s += kDay_s;
            }
            result_.longest_hole_s = std::max(result_.longest_hole_s, step_s);
            result_.longest_return_s = std::max(result_.longest_return_s, -step_s);
        }
        if (is_of_day)
            last_of_day_s_ = *instant;
        value = *instant + midnights_s_;
        return true;
    }

    const ColumnRequest& request_;
    const std::string& where_;
    RowSplitter splitter_;
    NumberColumns result_;
    std::optional<double> last_of_day_s_;
    double midnights_s_ = 0;
};

}  // namespace

bool readCell(std::string_view cell, bool decimal_comma, double& value) {
    value = kMissing;
    if (cell.empty() || isWord(cell, "nan") || isWord(cell, "-nan") || isWord(cell, "null"))
        return true;
    if (decimal_comma && cell.find(',') != std::string_view::npos) {
        const std::string point = withDecimalPoint(cell);
        return readCell(point, false, value);
    }
    const char* end = cell.data() + cell.size();
    if (parseNumber(cell.data(), end, value) != end)
        return false;
    if (!std::isfinite(value))
        value = kMissing;
    return true;
}

std::vector<std::string> cellsOfLine(std::string_view line, char separator) {
    RowSplitter splitter(separator);
    const auto& cells = splitter.split(line);
    return {cells.begin(), cells.end()};
}

char separatorOf(std::string_view header) {
    char best = ',';
    long most = 0;
    for (const char separator : {'\t', ';', ',', ' '})
        if (const long count = std::count(header.begin(), header.end(), separator); count > most) {
            best = separator;
            most = count;
            if (separator != ' ' && count >= 2)
                break;  // names hold blanks: any other separator wins
        }
    return best;
}

Result<NumberColumns> columnsOfText(std::string_view text, const ColumnRequest& request,
                                    const std::string& where, const JobContext& job) {
    ColumnReader reader(request, where);
    size_t number = request.first_line;
    size_t rows = 0;
    while (!text.empty()) {
        const bool has_end = text.find_first_of("\r\n") != std::string_view::npos;
        const std::string_view line = cutLine(text);
        if (trimmed(line).empty()) {
            ++number;
            continue;
        }
        if (!has_end) {
            reader.cut();
            break;
        }
        if (Status added = reader.add(line, number); !added)
            return added.error();
        ++number;
        if (++rows % 4096 == 0 && job.cancelled())
            return JobContext::cancelledError();
    }
    NumberColumns columns = reader.take();
    if (columns.rows == 0)
        return reader.damaged(number, "it ends before the first whole row of numbers");
    return columns;
}

}  // namespace noctule
