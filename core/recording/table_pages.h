// SPDX-License-Identifier: Apache-2.0
// The pages that hold a table's rows, found without SQLite, which stops at the first damaged page (SQLite
// file format, section 1.6).
#pragma once

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <optional>
#include <set>
#include <vector>

namespace noctule {

struct RowPage {
    int64_t first = std::numeric_limits<int64_t>::min();  ///< number of the first row that may be on it
    int64_t last = std::numeric_limits<int64_t>::max();
    std::optional<int64_t> rows{};  ///< so many; where it is damaged an estimate, absent when there is none
    bool is_readable = true;        ///< as far as can be told: its rows may still be damaged
    int64_t page = 0;               ///< its number, from 1
};

/// In the order of their rows; together they have room for all numbers. A damaged page of the tree stands for
/// all pages below it. `root`: number of the table's first page. `reached` gets all pages of the tree.
std::vector<RowPage> rowPages(std::istream& file, int64_t page_bytes, int64_t root,
                              std::set<int64_t>* reached = nullptr);

}  // namespace noctule
