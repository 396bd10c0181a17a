// SPDX-License-Identifier: Apache-2.0
#include "core/recording/lost_branches.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/recording/database.h"
#include "core/recording/page_reader.h"
#include "core/recording/schema.h"
#include "core/recording/table_pages.h"

namespace noctule {
namespace {

struct ColumnShape {
    std::string type;  ///< "INTEGER"
    bool is_row_number = false, may_be_null = true;
};

struct DamagedTable {
    std::string name;
    std::vector<ColumnShape> columns;
    std::vector<RowPage> pages;  ///< damaged ones that may have led to others, in the order of their rows
};

/// A sound page that nothing leads to, with the numbers of the first and last row on it and below it.
struct Branch {
    int64_t page = 0, first = 0, last = 0;
};

/// A value of this type may stand in the column. `serial_type`: SQLite file format, section 2.1.
bool fits(const ColumnShape& column, int64_t serial_type) {
    if (serial_type == 0)
        return column.may_be_null;
    if (column.is_row_number)
        return false;  // it stands elsewhere
    const bool is_integer = (serial_type >= 1 && serial_type <= 6) || serial_type == 8 || serial_type == 9;
    if (column.type == "INTEGER")
        return is_integer;
    if (column.type == "REAL")
        return is_integer || serial_type == 7;
    if (column.type == "TEXT")
        return serial_type >= 13 && serial_type % 2 == 1;
    return column.type == "BLOB" && serial_type >= 12 && serial_type % 2 == 0;
}

int64_t bytesOf(int64_t serial_type) {
    constexpr int64_t kBytes[] = {0, 1, 2, 3, 4, 6, 8, 8, 0, 0};
    return serial_type < 10 ? kBytes[serial_type] : (serial_type - 12) / 2;
}

class BranchMender {
public:
    BranchMender(std::fstream& file, int64_t page_bytes, int64_t page_count)
        : file_(file), page_bytes_(page_bytes), page_count_(page_count), page_(file, page_bytes) {}

    /// False: what is free cannot be told from what is lost.
    bool markFreePages() {
        if (!page_.read(1))
            return false;
        constexpr int64_t kFirstAt = 32, kCountAt = 36;
        const int64_t count = page_.number(kCountAt, 4);
        int64_t seen = 0;
        for (int64_t trunk = page_.number(kFirstAt, 4); trunk != 0; ++seen) {
            if (seen > count || !page_.read(trunk) || !free_.insert(trunk).second)
                return false;
            const int64_t leaves = page_.number(4, 4);
            if (leaves > page_bytes_ / 4 - 2)
                return false;
            for (int64_t i = 0; i < leaves; ++i)
                free_.insert(page_.number(8 + 4 * i, 4));
            seen += leaves;
            trunk = page_.number(0, 4);
        }
        return seen == count;
    }

    /// The list of free pages is an old one: a tree leads to one of them.
    bool isFreeListStale() const {
        return std::ranges::any_of(free_, [&](int64_t page) { return reached_.contains(page); });
    }

    bool isWhole(int64_t root) {
        return std::ranges::all_of(rowPages(file_, page_bytes_, root, &reached_), &RowPage::is_readable);
    }

    /// The damaged pages of a table.
    std::vector<RowPage> markTree(int64_t root) {
        std::vector<RowPage> damaged;
        for (const RowPage& each : rowPages(file_, page_bytes_, root, &reached_)) {
            const int kind =
                !each.is_readable && each.page > 1 && page_.read(each.page) ? page_.kind() : kRowPage;
            constexpr int kInnerOfIndex = 2, kLeafOfIndex = 10;
            if (kind != kInnerPage && kind != kRowPage && kind != kInnerOfIndex && kind != kLeafOfIndex)
                damaged.push_back(each);
        }
        return damaged;
    }

    /// Pages of tables that no tree and no other lost page leads to; none when lost pages lead to each other
    /// in a circle.
    std::vector<int64_t> lostPages(const JobContext& job) {
        std::vector<int64_t> lost;
        std::set<int64_t> below;
        int64_t looks = 0;
        for (int64_t page = 2; page <= page_count_ && !job.cancelled(); ++page) {
            if (reached_.contains(page) || free_.contains(page) || !page_.read(page))
                continue;
            const int kind = page_.kind();
            if (kind != kInnerPage && kind != kRowPage)
                continue;
            lost.push_back(page);
            if (kind == kInnerPage) {
                std::set<int64_t> all;
                (void)rowPages(file_, page_bytes_, page, &all);
                looks += static_cast<int64_t>(all.size());
                if (looks > kMostLevels * page_count_)  // more than trees need: a circle
                    return {};
                all.erase(page);
                below.merge(all);
            }
        }
        std::erase_if(lost, [&](int64_t page) { return below.contains(page); });
        return lost;
    }

    /// When all rows have these columns and ascend.
    std::optional<Branch> branchAt(int64_t page, const std::vector<ColumnShape>& columns) {
        std::optional<Branch> branch;
        for (const RowPage& each : rowPages(file_, page_bytes_, page)) {
            if (!each.is_readable || !page_.read(each.page) || page_.kind() != kRowPage)
                return std::nullopt;
            const std::optional<Branch> rows = rowsOfPage(columns);
            if (!rows || (branch && rows->first <= branch->last))
                return std::nullopt;
            branch = Branch{page, branch ? branch->first : rows->first, rows->last};
        }
        return branch;
    }

    /// In the place of the damaged page. False when they contradict each other.
    bool lead(const RowPage& to, std::vector<Branch> branches) {
        std::ranges::sort(branches, {}, &Branch::first);
        for (size_t i = 1; i < branches.size(); ++i)
            if (branches[i].first <= branches[i - 1].last)
                return false;
        return branches.size() == 1 ? page_.read(branches[0].page) && write(to.page, page_.bytes())
                                    : writeInnerPage(to.page, branches);
    }

private:
    bool write(int64_t page, const std::string& bytes) {
        file_.clear();
        file_.seekp((page - 1) * page_bytes_);
        file_.write(bytes.data(), page_bytes_).flush();
        return static_cast<bool>(file_);
    }

    /// At least two branches: SQLite refuses an inner page with a single child. False when there is no room.
    bool writeInnerPage(int64_t page, const std::vector<Branch>& branches) {
        std::string made(static_cast<size_t>(page_bytes_), '\0');
        constexpr size_t kList = 12;
        size_t end = made.size() - reservedBytes();
        const auto put = [&](size_t at, int64_t value, size_t length) {
            for (size_t i = 0; i < length; ++i)
                made[at + i] = static_cast<char>(value >> (8 * (length - 1 - i)) & 255);
        };
        const size_t entries = branches.size() - 1;
        for (size_t i = 0; i < entries; ++i) {
            const std::string key = varint(branches[i].last);
            if (end < kList + 2 * entries + 4 + key.size())
                return false;
            end -= 4 + key.size();
            put(end, branches[i].page, 4);
            made.replace(end + 4, key.size(), key);
            put(kList + 2 * i, static_cast<int64_t>(end), 2);
        }
        put(0, kInnerPage, 1);
        put(3, static_cast<int64_t>(entries), 2);
        put(5, static_cast<int64_t>(end), 2);
        put(8, branches.back().page, 4);
        return write(page, made);
    }

    /// Of the one that was read last: first and last number, when all rows fit and ascend.
    std::optional<Branch> rowsOfPage(const std::vector<ColumnShape>& columns) const {
        constexpr int64_t kList = 8;
        const int64_t rows = page_.entries();
        Branch numbers;
        for (int64_t i = 0; i < rows; ++i) {
            int64_t at = page_.number(kList + 2 * i, 2);
            if (at < kList + 2 * rows || at >= page_bytes_)
                return std::nullopt;
            const int64_t bytes = page_.varint(at), row = page_.varint(at);
            if ((i > 0 && row <= numbers.last) || !isRow(columns, at, bytes))
                return std::nullopt;
            numbers = {0, i == 0 ? row : numbers.first, row};
        }
        return rows > 0 ? std::optional(numbers) : std::nullopt;
    }

    bool isRow(const std::vector<ColumnShape>& columns, int64_t at, int64_t bytes) const {
        const int64_t begin = at, header_bytes = page_.varint(at);
        if (header_bytes < 2 || header_bytes > page_bytes_ - begin)
            return false;
        const int64_t end = begin + header_bytes;
        int64_t all_bytes = header_bytes;
        size_t column = 0;
        for (; at < end; ++column) {
            const int64_t type = page_.varint(at);
            if (column == columns.size() || type < 0 || type > kMostBytes || !fits(columns[column], type))
                return false;
            all_bytes += bytesOf(type);
        }
        return at == end && all_bytes == bytes;
    }

    size_t reservedBytes() {
        constexpr int64_t kReservedAt = 20;
        return page_.read(1) ? static_cast<size_t>(page_.byte(kReservedAt)) : 0;
    }

    static std::string varint(int64_t value) {
        auto rest = static_cast<uint64_t>(value);
        std::string bytes;
        if (rest >> 56 != 0) {
            bytes = static_cast<char>(rest & 255);
            rest >>= 8;
            for (int i = 0; i < 8; ++i, rest >>= 7)
                bytes.insert(bytes.begin(), static_cast<char>((rest & 127) | 128));
            return bytes;
        }
        do {
            bytes.insert(bytes.begin(), static_cast<char>((rest & 127) | (bytes.empty() ? 0 : 128)));
            rest >>= 7;
        } while (rest != 0);
        return bytes;
    }

    static constexpr int64_t kMostBytes = int64_t{1} << 32;

    std::fstream& file_;
    const int64_t page_bytes_, page_count_;
    PageReader page_;
    std::set<int64_t> reached_, free_;
};

std::vector<ColumnShape> columnsOf(const Database& database, const std::string& table) {
    std::vector<ColumnShape> columns;
    std::vector<size_t> key;
    Result<Statement> info = database.prepare("PRAGMA table_info(" + table + ")");
    if (!info)
        return columns;
    for (Result<bool> row = info->step(); row && *row; row = info->step()) {
        if (info->integer(5).value_or(0) > 0)
            key.push_back(columns.size());
        columns.push_back({info->text(2).value_or(""), false, info->integer(3).value_or(0) == 0});
    }
    if (key.size() == 1 && columns[key[0]].type == "INTEGER")
        columns[key[0]] = {"INTEGER", true, true};
    return columns;
}

/// Nothing where the list of tables or of free pages is damaged: what is lost cannot be told then.
std::vector<DamagedTable> damagedTables(const Database& database, BranchMender& mender) {
    std::vector<DamagedTable> damaged;
    Result<Statement> list =
        database.prepare("SELECT lower(name), rootpage FROM sqlite_schema WHERE type='table' AND rootpage>0");
    if (!list || !mender.markFreePages() || !mender.isWhole(1))
        return {};
    while (true) {
        const Result<bool> row = list->step();
        if (!row)
            return {};
        if (!*row)
            return mender.isFreeListStale() ? std::vector<DamagedTable>() : damaged;
        const std::string name = list->text(0).value_or("");
        std::vector<RowPage> pages = mender.markTree(list->integer(1).value_or(0));
        if (!pages.empty() &&
            std::ranges::find(takeTables(), name, &TableDefinition::name) != takeTables().end())
            damaged.push_back({name, columnsOf(database, name), std::move(pages)});
    }
}

/// The one damaged page below which the branch belongs; none when there are several, of tables that are
/// alike.
std::optional<std::pair<size_t, size_t>> placeOf(int64_t page, const std::vector<DamagedTable>& tables,
                                                 BranchMender& mender, Branch& found) {
    std::optional<std::pair<size_t, size_t>> place;
    for (size_t table = 0; table < tables.size(); ++table) {
        const std::optional<Branch> branch = mender.branchAt(page, tables[table].columns);
        if (!branch)
            continue;
        const std::vector<RowPage>& pages = tables[table].pages;
        const auto after = std::ranges::upper_bound(pages, branch->first, {}, &RowPage::first);
        if (after == pages.begin() || branch->last > (after - 1)->last)
            continue;
        if (place)
            return std::nullopt;
        place = std::pair(table, static_cast<size_t>(after - 1 - pages.begin()));
        found = *branch;
    }
    return place;
}

}  // namespace

std::set<std::string> mendBranches(const std::string& path, const JobContext& job) {
    std::error_code ignored;
    std::fstream file;
    std::optional<BranchMender> mender;
    std::vector<DamagedTable> tables;
    {
        Result<Database> database = Database::open(path, Access::kRead, {job.cancel});
        if (!database || !database->tolerateDamage())
            return {};
        const auto page_bytes = database->queryInteger("PRAGMA page_size");
        if (!page_bytes || page_bytes->value_or(0) < 1)
            return {};
        file.open(path, std::ios::binary | std::ios::in | std::ios::out);
        mender.emplace(file, **page_bytes,
                       static_cast<int64_t>(std::filesystem::file_size(path, ignored)) / **page_bytes);
        tables = damagedTables(*database, *mender);
    }
    if (tables.empty())
        return {};
    std::map<std::pair<size_t, size_t>, std::vector<Branch>> places;
    for (const int64_t page : mender->lostPages(job)) {
        if (job.cancelled())
            return {};
        Branch branch;
        if (const auto place = placeOf(page, tables, *mender, branch))
            places[*place].push_back(branch);
    }
    std::set<std::string> mended;
    for (const auto& [place, branches] : places)
        if (mender->lead(tables[place.first].pages[place.second], branches))
            mended.insert(tables[place.first].name);
    return mended;
}

}  // namespace noctule
