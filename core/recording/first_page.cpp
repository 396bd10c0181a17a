// SPDX-License-Identifier: Apache-2.0
#include "core/recording/first_page.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "core/job/atomic_file.h"
#include "core/recording/database.h"
#include "core/recording/schema.h"

namespace noctule {
namespace {

constexpr int64_t kLargestPage_bytes = 65536, kSmallestPage_bytes = 512;

struct TableEntry {
    std::string name, sql;
    int64_t root = 0;
};

std::string readAt(std::istream& file, int64_t at, int64_t bytes) {
    std::string read(static_cast<size_t>(bytes), '\0');
    file.clear();
    file.seekg(at);
    file.read(read.data(), bytes);
    read.resize(static_cast<size_t>(std::max<std::streamsize>(0, file.gcount())));
    return read;
}

/// "CREATE TABLE t(...)" from `begin` on, to the bracket that closes it.
std::string statementAt(const std::string& page, size_t begin) {
    int open = 0;
    for (size_t at = begin; at < page.size(); ++at) {
        open += page[at] == '(' ? 1 : page[at] == ')' ? -1 : 0;
        if (page[at] == ')' && open == 0)
            return page.substr(begin, at + 1 - begin);
    }
    return "";
}

/// An entry is the texts "table", name and name, the number of the table's first page, and its statement
/// (SQLite file format, section 2.6).
std::vector<TableEntry> entriesIn(std::istream& file) {
    const std::string page = readAt(file, 0, kLargestPage_bytes);
    std::vector<TableEntry> found;
    for (const TableDefinition& table : takeTables()) {
        const std::string texts = "table" + table.name + table.name;
        const size_t at = page.find(texts), number = at + texts.size();
        const size_t begin =
            at == std::string::npos ? at : page.find("CREATE TABLE " + table.name + "(", number);
        constexpr size_t kLongestNumber_bytes = 4;
        if (begin == std::string::npos || begin == number || begin - number > kLongestNumber_bytes)
            continue;
        TableEntry entry{table.name, statementAt(page, begin)};
        for (size_t i = number; i < begin; ++i)
            entry.root = entry.root << 8 | static_cast<unsigned char>(page[i]);
        if (!entry.sql.empty())
            found.push_back(entry);
    }
    return found;
}

/// With which most tables begin at a page of a table.
int64_t pageBytesOf(std::istream& file, const std::vector<TableEntry>& entries) {
    int64_t best = 0;
    std::ptrdiff_t most = 0;
    for (int64_t bytes = kSmallestPage_bytes; bytes <= kLargestPage_bytes; bytes *= 2) {
        const std::ptrdiff_t fit = std::ranges::count_if(entries, [&](const TableEntry& entry) {
            const std::string kind = readAt(file, (entry.root - 1) * bytes, 1);
            return kind == "\x05" || kind == "\x0d";
        });
        if (fit > most)
            most = fit, best = bytes;
    }
    return best;
}

bool isListReadable(const std::string& path) {
    Result<Database> database = Database::open(path, Access::kRead);
    // Whether the rest of the file is there does not matter.
    return database && database->tolerateDamage() &&
           database->queryInteger("SELECT sum(length(sql)) FROM sqlite_schema").ok();
}

/// A database that has nothing but the list.
Status writeList(const std::string& path, const std::vector<TableEntry>& entries, int64_t page_bytes) {
    Result<Database> database = Database::create(path);
    if (!database)
        return database.error();
    if (const Status tolerant = database->tolerateDamage(); !tolerant)
        return tolerant;
    if (const Status set = database->execute("PRAGMA page_size=" + std::to_string(page_bytes)); !set)
        return set;
    for (const TableEntry& entry : entries) {
        Result<Statement> insert = database->prepare("INSERT INTO sqlite_schema VALUES('table',?1,?1,?2,?3)");
        if (!insert)
            return insert.error();
        if (const Status done = insert->bind(0, entry.name).bind(1, entry.root).bind(2, entry.sql).run();
            !done)
            return done;
    }
    return database->close();
}

}  // namespace

bool hasRemainsOfFirstPage(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<TableEntry> entries = entriesIn(file);
    return pageBytesOf(file, entries) > 0 && !isListReadable(path);
}

Status mendFirstPage(const std::string& path) {
    const Error nothing{ErrorKind::kUnreadable, path + ": nothing in it can be read",
                        "Use a copy of it, if there is one"};
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    const std::vector<TableEntry> entries = entriesIn(file);
    const int64_t page_bytes = pageBytesOf(file, entries);
    if (page_bytes == 0 || isListReadable(path))
        return nothing;
    const std::string list = asidePath(path);
    const Status written = writeList(list, entries, page_bytes);
    std::ifstream first(list, std::ios::binary);
    std::string page = readAt(first, 0, page_bytes);
    std::error_code ignored;
    // A list that is longer than a page leads to others, which are something else here.
    const bool is_one_page =
        std::filesystem::file_size(list, ignored) == static_cast<std::uintmax_t>(page_bytes);
    std::filesystem::remove(list, ignored);
    if (!written)
        return written;
    if (!is_one_page)
        return nothing;
    constexpr size_t kPageCountAt = 28;
    const auto pages =
        static_cast<uint64_t>(std::filesystem::file_size(path, ignored)) / static_cast<uint64_t>(page_bytes);
    for (size_t i = 0; i < 4; ++i)
        page.at(kPageCountAt + i) = static_cast<char>(pages >> (24 - 8 * i) & 255);
    file.clear();
    file.seekp(0);
    file.write(page.data(), static_cast<std::streamsize>(page.size())).flush();
    return file ? Status(Done{}) : nothing;
}

}  // namespace noctule
