// SPDX-License-Identifier: Apache-2.0
// Files for tests of takes: a folder that goes away, copies of the tiny take, and SQL as any other program
// would run it.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/recording/take.h"

namespace noctule::test {

inline const std::string kTinyTake = NOCTULE_TEST_DATA "/takes/tiny_take.noctule";

class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "noctule_take_XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { std::filesystem::remove_all(path_); }

    std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string tinyTake() const {
        std::filesystem::copy_file(kTinyTake, file("tiny.noctule"),
                                   std::filesystem::copy_options::overwrite_existing);
        return file("tiny.noctule");
    }
    size_t fileCount() const {
        return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
    }

private:
    std::filesystem::path path_;
};

inline void runSql(const std::string& path, const std::string& sql) {
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(handle) << ": " << sql;
    sqlite3_close(handle);
}

inline std::string readBytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void writeBytes(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

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
