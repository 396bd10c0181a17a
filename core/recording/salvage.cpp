// SPDX-License-Identifier: Apache-2.0
#include "core/recording/salvage.h"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <utility>
#include <vector>

#include "core/job/outside_text.h"
#include "core/recording/database.h"
#include "core/recording/schema.h"
#include "core/recording/table_pages.h"

namespace noctule {
namespace {

/// Unreadable stretches in a row after which the rest of a page is given up, a tenth of a second.
constexpr int kMostFailures = 2'000;

/// What the torn file has of the table's columns; empty: it has no such table.
Result<std::vector<ColumnDefinition>> columnsIn(const Database& database, const TableDefinition& table) {
    Result<Statement> info = database.prepare("PRAGMA torn.table_info(" + table.name + ")");
    if (!info)
        return info.error();
    std::vector<ColumnDefinition> columns;
    for (Result<bool> row = info->step();; row = info->step()) {
        if (!row)
            return row.error();
        if (!*row)
            return columns;
        const std::string name = info->text(1).value_or("");
        for (const ColumnDefinition& column : table.columns)
            if (column.name == name)
                columns.push_back(column);
    }
}

/// Of the file that is read; empty when the list of tables does not say where it begins.
std::vector<RowPage> pagesOf(const Database& database, const std::string& torn, const std::string& table) {
    const auto page_bytes = database.queryInteger("PRAGMA torn.page_size");
    const auto root = database.queryInteger(
        "SELECT rootpage FROM torn.sqlite_schema WHERE type='table' AND "
        "name='" +
        table + "' COLLATE NOCASE");
    std::ifstream file(torn, std::ios::binary);
    return page_bytes && *page_bytes && root && *root ? rowPages(file, **page_bytes, **root)
                                                      : std::vector<RowPage>();
}

/// Where the torn row's value has the column's type: SQLite lets anyone store anything. A number in a text's
/// place loses nothing when it becomes text.
std::string typeCheck(const ColumnDefinition& column) {
    const std::string_view type(column.declaration);
    const bool is_number = type.starts_with("INTEGER") || type.starts_with("REAL");
    std::string types = is_number                  ? "'integer','real'"
                        : type.starts_with("BLOB") ? "'blob'"
                                                   : "'text','integer','real'";
    if (type.find("NOT NULL") == std::string_view::npos)
        types += ",'null'";
    std::string check = " AND ";
    check += "typeof(";
    check += column.name;
    check += ") IN(";
    check += types;
    return check += ")";
}

class TableCopy {
public:
    /// `columns`: those of the table that the torn file has.
    static Result<TableCopy> make(const Database& database, const std::string& table,
                                  const std::vector<ColumnDefinition>& columns, const JobContext& job) {
        std::string names, checks;
        for (const ColumnDefinition& column : columns) {
            names += (names.empty() ? "" : ",") + column.name;
            checks += typeCheck(column);
        }
        Result<Statement> insert =
            database.prepare("INSERT OR IGNORE INTO main." + table + "(" + names + ") SELECT " + names +
                             " FROM torn." + table + " NOT INDEXED WHERE rowid BETWEEN ? AND ?" + checks);
        if (!insert)
            return insert.error();
        return TableCopy(database, std::move(*insert), job);
    }

    /// True when all of them could be read.
    Result<bool> copy(int64_t first, int64_t last) {
        if (job_->cancelled())
            return JobContext::cancelledError();
        const Status done = insert_.bind(0, first).bind(1, last).run();
        if (job_->cancelled())
            return JobContext::cancelledError();
        if (!done && done.error().kind == ErrorKind::kDisk)
            return done.error();
        if (!done)
            return false;
        const auto rows = database_->queryInteger("SELECT changes()");
        copied_ += rows ? rows->value_or(0) : 0;
        return true;
    }

    /// Page by page, since the table as a whole cannot be read; many at once, where they can.
    Status copyPages(const std::vector<RowPage>& pages) {
        if (pages.size() == 1)
            return copyRowsOf(pages[0]);
        Stretches<size_t> stretches;
        halve<size_t>(stretches, 0, pages.size() - 1);
        while (!stretches.empty()) {
            const auto [first, last] = stretches.back();
            stretches.pop_back();
            if (first == last && !pages[first].is_readable)
                continue;
            const Result<bool> all = copy(pages[first].first, pages[last].last);
            if (!all)
                return all.error();
            if (*all)
                continue;
            if (first == last) {
                if (const Status rows = copyRowsOf(pages[first]); !rows)
                    return rows;
                continue;
            }
            halve(stretches, first, last);
        }
        return Done{};
    }

    int64_t copied() const { return copied_; }

private:
    TableCopy(const Database& database, Statement insert, const JobContext& job)
        : database_(&database), insert_(std::move(insert)), job_(&job) {}

    /// First and last of each, in reverse order.
    template <class Number>
    using Stretches = std::vector<std::pair<Number, Number>>;

    template <class Number>
    static void halve(Stretches<Number>& stretches, Number first, Number last) {
        const Number middle = std::midpoint(first, last);
        stretches.emplace_back(middle + 1, last);
        stretches.emplace_back(first, middle);
    }

    /// Of a page that cannot be read as a whole. The first and the last one have room for all numbers there
    /// are: the likely ones come first.
    Status copyRowsOf(const RowPage& page) {
        constexpr int64_t kLikely = 10'000;
        Stretches<int64_t> stretches;
        if (!page.is_readable)
            return Done{};
        int64_t first = page.first;
        if (first <= 0 && page.last > 0) {
            stretches.emplace_back(first, 0);
            first = 1;
        }
        if (first > 0 && page.last - first > kLikely) {
            stretches.emplace_back(first, first + kLikely);
            first += kLikely + 1;
        }
        if (stretches.empty()) {
            if (first == page.last)
                return Done{};
            Stretches<int64_t> halves;
            halve(halves, first, page.last);
            return copyHalves(std::move(halves));
        }
        stretches.emplace_back(first, page.last);
        for (const auto& stretch : stretches)
            if (const Status halved = copyHalves({stretch}); !halved)
                return halved;
        return Done{};
    }

    /// A stretch that cannot be read as a whole is halved, down to single rows.
    Status copyHalves(Stretches<int64_t> stretches) {
        for (int failures = 0; !stretches.empty() && failures < kMostFailures;) {
            const auto [first, last] = stretches.back();
            stretches.pop_back();
            const int64_t before = copied_;
            const Result<bool> all = copy(first, last);
            if (!all)
                return all.error();
            failures = copied_ > before ? 0 : failures + !*all;
            if (!*all && first < last)
                halve(stretches, first, last);
        }
        return Done{};
    }

    const Database* database_;
    Statement insert_;
    const JobContext* job_;
    int64_t copied_ = 0;
};

Result<TableLoss> copyTable(const Database& database, const std::string& torn, const std::string& table,
                            const std::vector<ColumnDefinition>& columns, const JobContext& job) {
    Result<TableCopy> rows = TableCopy::make(database, table, columns, job);
    if (!rows)
        return rows.error();
    const Result<bool> all = rows->copy(RowPage().first, RowPage().last);
    if (!all)
        return all.error();
    if (*all) {
        const auto there = database.queryInteger("SELECT count(*) FROM torn." + table + " NOT INDEXED");
        const int64_t count = there ? there->value_or(0) : 0;
        return TableLoss{table, rows->copied(), std::max<int64_t>(0, count - rows->copied())};
    }
    std::vector<RowPage> pages = pagesOf(database, torn, table);
    if (pages.empty())
        pages.emplace_back();
    if (const Status copied = rows->copyPages(pages); !copied)
        return copied.error();
    std::optional<int64_t> lost = -rows->copied();
    for (const RowPage& page : pages)
        lost = lost && page.rows ? std::optional(*lost + *page.rows) : std::nullopt;
    // More rows than the pages seemed to hold: some is lost all the same, for not all could be read.
    return TableLoss{table, rows->copied(), lost ? std::optional(std::max<int64_t>(1, *lost)) : lost};
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

Error beginningGone(const std::string& torn) {
    return {
        ErrorKind::kUnreadable,
        torn + ": the beginning of the file is damaged, which says where the rest is; nothing can be read",
        "Use a copy of it, if there is one"};
}

/// Whoever reads it has asked for what can be read already.
Error inPlainWords(const Error& error, const std::string& torn) {
    return error.is_damage ? beginningGone(torn) : error;
}

/// Before anybody asks the torn file for them: then each would seem to be there.
Status makeEmptyTables(Database& database) {
    Result<TakeSchema> schema = TakeSchema::read(database);
    if (!schema)
        return schema.error();
    for (const TableDefinition& table : takeTables())
        if (const Status made = schema->complete(database, table.name); !made)
            return made;
    return Done{};
}

/// In seconds, where there is one suit and its take says how long it was.
void measureSound(const Database& database, TakeLosses& losses) {
    const auto meta = [&](const std::string& key) {
        const auto value =
            database.queryInteger("SELECT CAST(value AS INTEGER) FROM main.meta WHERE key='" + key + "'");
        return value ? value->value_or(0) : 0;
    };
    const int64_t rate_hz = meta("sample_rate_hz");
    const auto suits = database.queryInteger("SELECT count(DISTINCT suit) FROM main.adc_block");
    const auto samples = database.queryInteger("SELECT sum(sample_count) FROM main.adc_block");
    // What was never recorded is not lost.
    const auto holes = database.queryInteger("SELECT sum(sample_count) FROM main.gap WHERE board IS NULL");
    const int64_t whole = meta("sample_count") - (holes ? holes->value_or(0) : 0);
    if (rate_hz < 1 || whole < 1 || !suits || suits->value_or(0) > 1 || !samples)
        return;
    losses.whole_sound_s = static_cast<double>(whole) / static_cast<double>(rate_hz);
    losses.sound_s = std::clamp(static_cast<double>(samples->value_or(0)) / static_cast<double>(rate_hz), 0.0,
                                losses.whole_sound_s);
}

Result<int64_t> mendTextsOf(const Database& database, const std::string& table, const std::string& column) {
    if (const auto there =
            database.queryInteger("SELECT 1 FROM main.sqlite_schema WHERE name='" + table + "'");
        !there || !*there)
        return 0;
    std::vector<std::pair<int64_t, std::string>> odd;
    Result<Statement> texts = database.prepare("SELECT rowid," + column + " FROM main." + table);
    Result<Statement> set =
        database.prepare("UPDATE OR IGNORE main." + table + " SET " + column + "=? WHERE rowid=?");
    if (!texts || !set)
        return texts ? set.error() : texts.error();
    for (Result<bool> row = texts->step();; row = texts->step()) {
        if (!row)
            return row.error();
        if (!*row)
            break;
        const std::string text = texts->text(1).value_or("");
        if (std::string valid = validUtf8(text); valid != text)
            odd.emplace_back(texts->integer(0).value_or(0), std::move(valid));
    }
    for (const auto& [row, valid] : odd)
        if (const Status done = set->bind(0, std::string_view(valid)).bind(1, row).run(); !done)
            return done.error();
    return std::ssize(odd);
}

/// How many texts of the new take were no UTF-8.
Result<int64_t> mendTexts(const Database& database) {
    int64_t mended = 0;
    for (const TableDefinition& table : takeTables())
        for (const ColumnDefinition& column : table.columns) {
            if (!column.declaration.starts_with("TEXT"))
                continue;
            const Result<int64_t> texts = mendTextsOf(database, table.name, column.name);
            if (!texts)
                return texts;
            mended += *texts;
        }
    return mended;
}

/// Of every table of a take.
Result<TakeLosses> copyTables(const Database& database, const std::string& torn,
                              const std::set<std::string>& mended, const JobContext& job) {
    TakeLosses losses;
    std::ifstream file(torn, std::ios::binary);
    const auto page_bytes = database.queryInteger("PRAGMA torn.page_size");
    for (const RowPage& page : rowPages(file, page_bytes ? page_bytes->value_or(1) : 1, 1))
        losses.may_have_had_more |= !page.is_readable;
    int64_t copied = 0;
    double done = 0;
    for (const TableDefinition& table : takeTables()) {
        job.progress(done++ / static_cast<double>(takeTables().size()), "Reading");
        const Result<std::vector<ColumnDefinition>> columns = columnsIn(database, table);
        if (!columns)
            return inPlainWords(columns.error(), torn);
        if (columns->empty()) {
            if (!table.required)
                if (const Status dropped = database.execute("DROP TABLE main." + table.name); !dropped)
                    return dropped.error();
            continue;
        }
        Result<TableLoss> rows = copyTable(database, torn, table.name, *columns, job);
        if (!rows)
            return rows.error();
        if (mended.contains(table.name))
            rows->lost = std::nullopt;
        copied += rows->saved;
        if (rows->lost != 0)
            losses.tables.push_back(*rows);
    }
    // A take of readings never had sound, whatever cannot be read where its table began.
    const auto of_readings =
        database.queryInteger("SELECT 1 FROM main.meta WHERE key='level' AND value='readings'");
    if (of_readings && *of_readings)
        std::erase_if(losses.tables, [](const TableLoss& loss) { return loss.table == "adc_block"; });
    if (std::ranges::find(losses.tables, "adc_block", &TableLoss::table) != losses.tables.end())
        measureSound(database, losses);
    if (copied > 0)
        return losses;
    return losses.may_have_had_more ? beginningGone(torn) : nothingReadable(torn);
}

}  // namespace

Result<TakeLosses> copyReadableRows(const std::string& torn, const std::string& path, const JobContext& job,
                                    const std::set<std::string>& mended) {
    Result<Database> database = Database::create(path, {job.cancel});
    if (!database)
        return database.error();
    database->setDisplayName(torn);
    if (const Status made = makeEmptyTables(*database); !made)
        return made.error();
    if (const Status attached = attach(*database, torn); !attached)
        return inPlainWords(attached.error(), torn);
    Result<TakeLosses> losses = copyTables(*database, torn, mended, job);
    if (!losses)
        return losses;
    // How long it was counts no more; the blocks or readings tell how long it is.
    if (const Status counted = database->execute(
            "DELETE FROM main.meta WHERE key='sample_count' AND (EXISTS(SELECT 1 FROM main.adc_block) OR "
            "EXISTS(SELECT 1 FROM main.meta WHERE key='level' AND value='readings'))");
        !counted)
        return counted.error();
    const Result<int64_t> mended_texts = mendTexts(*database);
    if (!mended_texts)
        return mended_texts.error();
    losses->mended_texts = *mended_texts;
    if (const Status closed = database->close(); !closed)
        return closed.error();
    return losses;
}

}  // namespace noctule
