// SPDX-License-Identifier: Apache-2.0
// Takes for tests: copies of the tiny take of the specification, and SQL as any other program would run it.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>
#include <string>
#include <vector>

#include "tests/support/files.h"

namespace noctule::test {

inline const std::string kTinyTake = NOCTULE_TEST_DATA "/takes/tiny_take.noctule";

/// A copy of it in the folder.
inline std::string tinyTake(const Folder& folder) {
    std::filesystem::copy_file(kTinyTake, folder.file("tiny.noctule"),
                               std::filesystem::copy_options::overwrite_existing);
    return folder.file("tiny.noctule");
}

inline void runSql(const std::string& path, const std::string& sql) {
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(handle) << ": " << sql;
    sqlite3_close(handle);
}

/// Overwrites all pages that hold rows of the table, as a failing disk may.
inline void damageRowsOf(const std::string& path, const std::string& table) {
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
    const auto collect = [](void* into, int, char** values, char**) {
        static_cast<std::vector<std::pair<int64_t, size_t>>*>(into)->emplace_back(std::stoll(values[0]),
                                                                                  std::stoul(values[1]));
        return 0;
    };
    std::vector<std::pair<int64_t, size_t>> pages;
    const std::string sql =
        "SELECT pgoffset, pgsize FROM dbstat WHERE name='" + table + "' AND pagetype='leaf'";
    EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), collect, &pages, nullptr), SQLITE_OK)
        << sqlite3_errmsg(handle);
    sqlite3_close(handle);
    EXPECT_FALSE(pages.empty()) << table;
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    for (const auto& [at, bytes] : pages) {
        file.seekp(at);
        file << std::string(bytes, '\xff');
    }
}

}  // namespace noctule::test
