// SPDX-License-Identifier: Apache-2.0
#include "core/recording/database.h"

#include <sqlite3.h>

#include <filesystem>

#include "core/job/job.h"
#include "core/job/limits.h"
#include "core/recording/read_watch.h"
#include "core/recording/sqlite_error.h"

namespace noctule {

namespace {

// The longest value we write is a block of 65536 samples of 32 boards, 4 MiB. A damaged length field must not
// make SQLite ask for a gigabyte.
constexpr int kLongestValue = 64 * 1024 * 1024;
constexpr int kBetweenLooks_ms = 10;      // at a lock of another program
constexpr int kStepsBetweenLooks = 5000;  // of SQLite's machine, some 0.1 ms

/// file: URI for SQLite, which then does not ask for locks or write-ahead files.
std::string immutableUri(const std::string& path) {
    std::string uri = "file:";
    for (const char c : std::filesystem::absolute(path).string()) {
        if (c == '?' || c == '#' || c == '%') {
            constexpr char kHex[] = "0123456789ABCDEF";
            uri += {'%', kHex[(c >> 4) & 15], kHex[c & 15]};
        } else {
            uri += c;
        }
    }
    return uri + "?immutable=1";
}

bool hasWriteAheadLog(const std::string& path) {
    std::error_code ignored;
    const auto size = std::filesystem::file_size(path + "-wal", ignored);
    return !ignored && size > 0;
}

}  // namespace

int Database::onProgress(void* watching) {
    auto& watch = *static_cast<Watch*>(watching);
    watch.steps += kStepsBetweenLooks;
    watch.endless = watch.steps > limits::kStepsOfRow;
    return watch.endless || (watch.cancel && watch.cancel->cancelled());
}

int Database::onBusy(void* watching, int waits) {
    const auto& watch = *static_cast<const Watch*>(watching);
    if (waits >= watch.most_waits || (watch.cancel && watch.cancel->cancelled()))
        return 0;
    sqlite3_sleep(kBetweenLooks_ms);
    return 1;
}

void Database::setPatience_s(double patience_s) {
    watch_->most_waits = static_cast<int>(patience_s * 1000 / kBetweenLooks_ms);
}

Error Database::failure(sqlite3* handle, const std::string& name, const Watch& watch) {
    if (watch.cancel && watch.cancel->cancelled())
        return JobContext::cancelledError();
    if (watch.endless)
        return {ErrorKind::kUnreadable, name + ": reading one row takes too long",
                "Ask its author what is in it; `noctule --batch recover` may save the rest"};
    return sqliteError(handle, name);
}

/// Foreign files are data, not programs.
void Database::harden(const Waiting& waiting) {
    sqlite3* handle = handle_.get();
    watch_->cancel = waiting.cancel;
    setPatience_s(waiting.patience_s);
    sqlite3_busy_handler(handle, onBusy, watch_.get());
    sqlite3_progress_handler(handle, kStepsBetweenLooks, onProgress, watch_.get());
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, kLongestValue);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
}

Status Database::tolerateDamage() {
    sqlite3* handle = handle_.get();
    if (sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr) != SQLITE_OK ||
        sqlite3_db_config(handle, SQLITE_DBCONFIG_WRITABLE_SCHEMA, 1, nullptr) != SQLITE_OK)
        return lastError();
    return Done{};
}

void Database::watchReading(const JobContext& job, const std::string& stage) {
    watch_->cancel = job.cancel;
    read_watch_ = noctule::watchReading(handle_.get(), job, stage);
}

void Database::Closer::operator()(sqlite3* handle) const {
    sqlite3_close_v2(handle);
}

Result<Database> Database::openWith(const std::string& path, const std::string& uri, int flags,
                                    const Waiting& waiting) {
    Database database;
    database.path_ = path;
    database.name_ = path;
    sqlite3* handle = nullptr;
    const int code = sqlite3_open_v2(uri.c_str(), &handle, flags | SQLITE_OPEN_NOMUTEX, nullptr);
    database.handle_.reset(handle);
    if (code != SQLITE_OK)
        return database.lastError();
    database.harden(waiting);
    return database;
}

Result<Database> Database::open(const std::string& path, Access access, const Waiting& waiting) {
    std::error_code status_error;
    if (std::filesystem::is_directory(path, status_error))
        return Error{ErrorKind::kUnreadable, path + ": is a folder, not a take", "Choose a .noctule file"};
    if (!std::filesystem::is_regular_file(path, status_error))
        return Error{ErrorKind::kUnreadable, path + ": there is no such file", "Check the path"};
    const int flags = access == Access::kRead ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE;
    Result<Database> database = openWith(path, path, flags, waiting);
    // SQLite opens lazily: the first read tells.
    const bool readable = database.ok() && database->queryInteger("PRAGMA schema_version").ok();
    if (readable || access == Access::kReadWrite)
        return database;
    // Only a write-ahead database in a folder that cannot be written fails here and is sound. Without a log
    // beside it the file alone is complete.
    if (hasWriteAheadLog(path)) {
        const int code = database.ok() ? sqlite3_errcode(database->handle_.get()) & 0xff : SQLITE_CANTOPEN;
        if (code == SQLITE_CANTOPEN || code == SQLITE_READONLY)
            return Error{ErrorKind::kUnreadable, path + ": its -wal file cannot be used in this folder",
                         "Copy both files to a folder where you may write"};
        return database;
    }
    return openWith(path, immutableUri(path), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, waiting);
}

Result<Database> Database::create(const std::string& path, const Waiting& waiting) {
    std::error_code status_error;
    if (std::filesystem::exists(path, status_error))
        return Error{ErrorKind::kDisk, path + ": exists already", "Choose another name"};
    Result<Database> database = openWith(path, path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, waiting);
    if (!database.ok())
        return Error{ErrorKind::kDisk, database.error().message, database.error().remedy};
    return database;
}

Error Database::lastError() const {
    return failure(handle_.get(), name_, *watch_);
}

Status Database::execute(const std::string& sql) const {
    watch_->steps = 0;
    if (sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
        return lastError();
    return Done{};
}

Result<Statement> Database::prepare(const std::string& sql) const {
    sqlite3_stmt* compiled = nullptr;
    if (sqlite3_prepare_v2(handle_.get(), sql.c_str(), -1, &compiled, nullptr) != SQLITE_OK)
        return lastError();
    Statement statement;
    statement.statement_.reset(compiled);
    statement.name_ = name_;
    statement.watch_ = watch_.get();
    return statement;
}

Result<std::optional<int64_t>> Database::queryInteger(const std::string& sql) const {
    Result<Statement> statement = prepare(sql);
    if (!statement)
        return statement.error();
    const Result<bool> row = statement->step();
    if (!row)
        return row.error();
    return *row ? statement->integer(0) : std::nullopt;
}

Result<int64_t> Database::changeCounter() const {
    constexpr sqlite3_int64 kCounterAt = 24;
    sqlite3_file* file = nullptr;
    unsigned char bytes[4]{};
    if (sqlite3_file_control(handle_.get(), "main", SQLITE_FCNTL_FILE_POINTER, &file) != SQLITE_OK || !file ||
        !file->pMethods || file->pMethods->xRead(file, bytes, sizeof bytes, kCounterAt) != SQLITE_OK)
        return Error{ErrorKind::kUnreadable, name_ + ": cannot be read", "Check the disk"};
    return int64_t{bytes[0]} << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
}

int64_t Database::lastInsertId() const {
    return sqlite3_last_insert_rowid(handle_.get());
}

bool Database::isLocked() const {
    const int code = sqlite3_errcode(handle_.get()) & 0xff;
    return code == SQLITE_BUSY || code == SQLITE_LOCKED;
}

bool Database::inTransaction() const {
    return sqlite3_get_autocommit(handle_.get()) == 0;
}

Status Database::close() {
    if (handle_ && sqlite3_close(handle_.get()) != SQLITE_OK)
        return lastError();
    (void)handle_.release();
    return Done{};
}

Result<Snapshot> Snapshot::begin(const Database& database) {
    if (const Status begun = database.execute("BEGIN"); !begun)
        return begun.error();
    Snapshot snapshot(database);
    // SQLite takes the moment of the first read.
    if (const auto first = database.queryInteger("SELECT 1 FROM sqlite_schema LIMIT 1"); !first)
        return first.error();
    return snapshot;
}

Snapshot::~Snapshot() {
    if (database_ && database_->inTransaction())
        (void)database_->execute("COMMIT");
}

Result<Transaction> Transaction::begin(const Database& database) {
    const Status begun = database.execute("BEGIN IMMEDIATE");
    if (!begun)
        return begun.error();
    return Transaction(database);
}

Transaction::~Transaction() {
    if (database_ && database_->inTransaction())
        (void)database_->execute("ROLLBACK");
}

Status Transaction::commit() {
    const Status committed = database_->execute("COMMIT");
    if (committed)
        database_ = nullptr;
    return committed;
}

}  // namespace noctule
