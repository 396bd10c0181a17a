// SPDX-License-Identifier: Apache-2.0
// The pages that hold a table's rows, found without SQLite, which stops at the first damaged page (SQLite
// file format, section 1.6).
#pragma once

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <optional>
#include <vector>

namespace noctule {

struct RowPage {
    int64_t first = std::numeric_limits<int64_t>::min();  ///< number of the first row that may be on it
    int64_t last = std::numeric_limits<int64_t>::max();
    std::optional<int64_t> rows{};  ///< so many; where it is damaged an estimate, absent when there is none
    bool is_readable = true;        ///< as far as can be told: its rows may still be damaged
};

/// In the order of their rows; together they have room for all numbers. A damaged page of the tree stands for
/// all pages below it. `root`: number of the table's first page.
std::vector<RowPage> rowPages(std::istream& file, int64_t page_bytes, int64_t root);

}  // namespace noctule
