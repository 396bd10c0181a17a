// SPDX-License-Identifier: Apache-2.0
// What tests of take files share: all rows of a cursor.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "core/recording/take.h"
#include "tests/support/take_files.h"

namespace noctule::test {

template <class Cursor>
auto collect(Cursor& cursor) {
    std::vector<typename std::decay_t<decltype(*cursor.next())>::value_type> rows;
    while (true) {
        auto row = cursor.next();
        EXPECT_TRUE(row) << row.error().text();
        if (!row || !*row)
            return rows;
        rows.push_back(**row);
    }
}

}  // namespace noctule::test
