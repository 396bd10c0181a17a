// SPDX-License-Identifier: Apache-2.0
#include "core/recording/salvage.h"

#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "core/recording/database.h"
#include "core/recording/schema.h"

namespace noctule {
namespace {

/// Unreadable stretches in a row after which the rest of a table is given up, some seconds.
constexpr int kMostFailures = 10'000;

/// What the torn file has of the table's columns, with commas; empty: it has no such table.
Result<std::string> columnsIn(const Database& database, const TableDefinition& table) {
    Result<Statement> info = database.prepare("PRAGMA torn.table_info(" + table.name + ")");
    if (!info)
        return info.error();
    std::string columns;
    for (Result<bool> row = info->step();; row = info->step()) {
        if (!row)
            return row.error();
        if (!*row)
            return columns;
        const std::string name = info->text(1).value_or("");
        for (const ColumnDefinition& column : table.columns)
            if (column.name == name)
                columns += (columns.empty() ? "" : ",") + name;
    }
}

/// Stretches of rows that cannot be read as a whole are halved, down to single rows. The first is all there
/// can be: which rows are the true ends may be unreadable.
Result<int64_t> copyTable(const Database& database, const std::string& table, const std::string& columns,
                          const JobContext& job) {
    const std::string copy = "INSERT OR IGNORE INTO main." + table + "(" + columns + ") SELECT " + columns +
                             " FROM torn." + table + " NOT INDEXED WHERE rowid BETWEEN ";
    std::vector<std::pair<int64_t, int64_t>> stretches{
        {std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::max()}};
    int64_t copied = 0;
    for (int failures = 0; !stretches.empty() && failures < kMostFailures;) {
        if (job.cancelled())
            return JobContext::cancelledError();
        const auto [first, last] = stretches.back();
        stretches.pop_back();
        if (database.execute(copy + std::to_string(first) + " AND " + std::to_string(last))) {
            const auto rows = database.queryInteger("SELECT changes()");
            const int64_t count = rows ? rows->value_or(0) : 0;
            copied += count;
            if (count > 0)
                failures = 0;
            continue;
        }
        if (const Error error = database.lastError(); error.kind == ErrorKind::kDisk)
            return error;
        ++failures;
        if (first == last)
            continue;
        const int64_t middle = std::midpoint(first, last);
        stretches.emplace_back(middle + 1, last);
        stretches.emplace_back(first, middle);
    }
    return copied;
}

Status attach(Database& database, const std::string& torn) {
    if (const Status tolerant = database.tolerateDamage(); !tolerant)
        return tolerant;
    const std::string identity = "PRAGMA application_id=" + std::to_string(kTakeApplicationId) +
                                 "; PRAGMA user_version=" + std::to_string(kTakeNewestVersion);
    for (const std::string& sql :
         {std::string("PRAGMA journal_mode=MEMORY; PRAGMA synchronous=OFF"), identity})
        if (const Status done = database.execute(sql); !done)
            return done;
    Result<Statement> attached = database.prepare("ATTACH ? AS torn");
    if (!attached)
        return attached.error();
    return attached->bind(0, std::string_view(torn)).run();
}

Error nothingReadable(const std::string& torn) {
    return {ErrorKind::kUnreadable, torn + ": nothing in it can be read",
            "Use a copy of it, if there is one"};
}

/// Whoever reads it has asked for what can be read already.
Error inPlainWords(const Error& error, const std::string& torn) {
    return error.is_damage ? nothingReadable(torn) : error;
}

}  // namespace

Status copyReadableRows(const std::string& torn, const std::string& path, const JobContext& job) {
    Result<Database> database = Database::create(path);
    if (!database)
        return database.error();
    database->setDisplayName(torn);
    Result<TakeSchema> schema = TakeSchema::read(*database);
    if (!schema)
        return schema.error();
    // Before the other file is beside it: then each would seem to be there.
    for (const TableDefinition& table : takeTables())
        if (const Status made = schema->complete(*database, table.name); !made)
            return made;
    if (const Status attached = attach(*database, torn); !attached)
        return inPlainWords(attached.error(), torn);
    int64_t copied = 0;
    double done = 0;
    for (const TableDefinition& table : takeTables()) {
        job.progress(done++ / static_cast<double>(takeTables().size()), "Reading");
        const Result<std::string> columns = columnsIn(*database, table);
        if (!columns)
            return inPlainWords(columns.error(), torn);
        if (columns->empty()) {
            if (!table.required)
                if (const Status dropped = database->execute("DROP TABLE main." + table.name); !dropped)
                    return dropped;
            continue;
        }
        const Result<int64_t> rows = copyTable(*database, table.name, *columns, job);
        if (!rows)
            return rows.error();
        copied += *rows;
    }
    if (copied == 0)
        return nothingReadable(torn);
    // How long it was counts no more; the blocks tell how long it is.
    if (const Status counted = database->execute(
            "DELETE FROM main.meta WHERE key='sample_count' AND EXISTS(SELECT 1 FROM main.adc_block)");
        !counted)
        return counted;
    return database->close();
}

}  // namespace noctule
