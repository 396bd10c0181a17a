// SPDX-License-Identifier: Apache-2.0
// The tables of a take file, version 1.0 (README.md, sections 2 and 3), and what of them a given file has.
// Files made elsewhere may lack columns and tables: queries are built from what is there.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/job/result.h"
#include "core/recording/database.h"

namespace noctule {

inline constexpr int64_t kTakeApplicationId = 0x4E4F4354;  ///< "NOCT"
inline constexpr int64_t kTakeMajorVersion = 1;
inline constexpr int64_t kTakeUserVersion = 1000 * kTakeMajorVersion;
inline constexpr int64_t kTakeNewestVersion = kTakeUserVersion + 1;  ///< of takes that need format 1.1

struct ColumnDefinition {
    std::string name;
    std::string declaration;  ///< "INTEGER NOT NULL DEFAULT 1"
};

struct TableDefinition {
    std::string name;
    std::vector<ColumnDefinition> columns;
    std::string constraint = {};  ///< "PRIMARY KEY(run, board)" or empty
    std::string index = {};       ///< "CREATE ... INDEX" statement or empty
    bool required = false;        ///< a writer must create it
};

/// All tables; required ones first.
const std::vector<TableDefinition>& takeTables();
const TableDefinition& takeTable(const std::string& name);

class TakeSchema {
public:
    /// What the file has of each table.
    static Result<TakeSchema> read(const Database& database);

    bool has(const std::string& table) const { return columns_.count(table) > 0; }
    bool has(const std::string& table, const std::string& column) const;

    /// "SELECT c1,c2 FROM table": a column the file lacks reads as NULL, `suit` as 1. Empty table when
    /// absent.
    std::string select(const std::string& table, const std::vector<std::string>& columns) const;
    /// The column's name, or the constant that stands for it where it is missing.
    std::string expression(const std::string& table, const std::string& column) const;

    /// Makes the table, or adds the columns it lacks.
    Status complete(const Database& database, const std::string& table);

private:
    std::map<std::string, std::set<std::string>> columns_;  ///< per existing table
};

}  // namespace noctule
