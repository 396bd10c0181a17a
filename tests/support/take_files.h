// SPDX-License-Identifier: Apache-2.0
// Takes for tests: copies of the tiny take of the specification, and SQL as any other program would run it.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <string>

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

}  // namespace noctule::test
