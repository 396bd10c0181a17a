// SPDX-License-Identifier: Apache-2.0
// A take that was recorded with its live results against the same take processed from its file.
#pragma once

#include <vector>

#include "core/processing/process_take.h"
#include "tests/support/take_files.h"

namespace noctule::test {

/// Every row of a query as text, numbers to their last bit.
inline std::vector<std::string> rowsOf(const std::string& path, const std::string& query) {
    std::vector<std::string> rows;
    sqlite3* handle = nullptr;
    EXPECT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
    sqlite3_stmt* select = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(handle, query.c_str(), -1, &select, nullptr), SQLITE_OK)
        << sqlite3_errmsg(handle);
    while (sqlite3_step(select) == SQLITE_ROW) {
        std::string row;
        for (int column = 0; column < sqlite3_column_count(select); ++column) {
            if (sqlite3_column_type(select, column) == SQLITE_FLOAT) {
                const double value = sqlite3_column_double(select, column);
                row.append(reinterpret_cast<const char*>(&value), sizeof value);
            } else if (const void* bytes = sqlite3_column_blob(select, column)) {
                row.append(static_cast<const char*>(bytes),
                           static_cast<size_t>(sqlite3_column_bytes(select, column)));
            }
            row += '|';
        }
        rows.push_back(row);
    }
    sqlite3_finalize(select);
    sqlite3_close(handle);
    return rows;
}

inline void expectSameResults(const std::string& live, const std::string& from_file) {
    for (const std::string query :
         {"SELECT * FROM inertial ORDER BY run,suit,board,frame",
          "SELECT * FROM range ORDER BY run,pulse,board", "SELECT * FROM pose ORDER BY run,time_ns",
          "SELECT * FROM derived ORDER BY run", "SELECT * FROM marker", "SELECT * FROM adc_block"}) {
        const auto a = rowsOf(live, query), b = rowsOf(from_file, query);
        EXPECT_GT(a.size(), 0u) << query;
        ASSERT_EQ(a.size(), b.size()) << query;
        for (size_t i = 0; i < a.size(); ++i)
            ASSERT_EQ(a[i], b[i]) << query << ", row " << i;
    }
}

/// A copy of the live take without its results, processed.
inline std::string processedFromFile(const Folder& folder, const std::string& live) {
    const std::string copy = folder.file("from_file.noctule");
    std::filesystem::copy_file(live, copy);
    for (const char* table : {"derived", "inertial", "range", "pose"})
        runSql(copy, std::string("DELETE FROM ") + table);
    ProcessRequest request;
    request.take_path = copy;
    request.software = "test";
    request.created_utc = "2026-01-01T00:00:00Z";
    const auto processed = processTake(request, {});
    EXPECT_TRUE(processed) << processed.error().text();
    return copy;
}

}  // namespace noctule::test
