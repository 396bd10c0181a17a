// SPDX-License-Identifier: Apache-2.0
// A table of measured values as spreadsheets and instruments write it: a header, then one row per line;
// comma, semicolon or tab between cells, quotes, blank lines, CRLF and a byte order mark allowed. Where
// semicolons or tabs separate, the decimal sign may be a comma. Errors are kUnreadable and name file, line
// and column.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/job/result.h"

namespace noctule {

class MeasuredTable {
public:
    static Result<MeasuredTable> parse(std::string_view text, const std::string& where);

    size_t rowCount() const { return rows_.size(); }
    /// By its name in any case; nothing when the header lacks it.
    std::optional<size_t> column(std::string_view name) const;

    /// A cell that must not be empty.
    Result<std::string> word(size_t row, size_t column) const;
    /// A finite number.
    Result<double> number(size_t row, size_t column) const;

    Error headerError(const std::string& what, const std::string& remedy) const;
    Error rowError(size_t row, const std::string& what, const std::string& remedy) const;
    size_t lineOf(size_t row) const { return rows_[row].line; }

private:
    struct Row {
        size_t line = 0;
        std::vector<std::string> cells;
    };

    explicit MeasuredTable(const std::string& where) : where_(where) {}
    Status readHeader(std::string_view line, size_t number);
    Status readRow(std::string_view line, size_t number);
    Status addLine(std::string_view line, size_t number);
    Error error(size_t line, const std::string& what, const std::string& remedy) const;

    std::string where_;
    char separator_ = ',';
    size_t header_line_ = 0;
    std::vector<std::string> header_;  ///< lower case
    std::vector<Row> rows_;
};

}  // namespace noctule
