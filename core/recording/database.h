// SPDX-License-Identifier: Apache-2.0
// SQLite behind values and Results. A Database is one connection, a Statement one prepared query, a
// Transaction rolls back unless committed. Not for several threads at once. Errors name the file and the
// remedy; their kind is kUnreadable while reading and kDisk while writing. Foreign files are data, not
// programs: triggers and functions of their schema do not run, a walk that is cancelled or endless ends.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/job/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace noctule {

enum class Access { kRead, kReadWrite };

class CancelFlag;
struct JobContext;
struct ReadWatch;

/// For a file that another program holds, and for long walks.
struct Waiting {
    const CancelFlag* cancel = nullptr;  ///< must outlive the connection
    double patience_s = 5;               ///< larger: later told that another program holds the file
};

class Statement;

class Database {
public:
    /// Opens an existing file. kRead also works where nothing can be written beside it.
    static Result<Database> open(const std::string& path, Access access, const Waiting& waiting = {});
    /// Makes a new, empty file; the path must not exist.
    static Result<Database> create(const std::string& path, const Waiting& waiting = {});
    void setPatience_s(double patience_s);
    /// From now on `job` is told which part of the file has been read, and what it cancels ends at the next
    /// page.
    void watchReading(const JobContext& job, const std::string& stage);
    /// Reads files that are shorter than they say, and what is sound of a schema that is not. Only for rows
    /// of a damaged file that is a copy.
    Status tolerateDamage();
    /// The last failure was a lock of another program.
    bool isLocked() const;

    const std::string& path() const { return path_; }
    /// The name in errors when the file on disk has a temporary one.
    void setDisplayName(std::string name) { name_ = std::move(name); }
    const std::string& name() const { return name_; }

    Status execute(const std::string& sql) const;
    Result<Statement> prepare(const std::string& sql) const;
    /// First column of the first row as a number; absent when there is no row or it is NULL.
    Result<std::optional<int64_t>> queryInteger(const std::string& sql) const;
    int64_t lastInsertId() const;
    /// Of the file's header (SQLite file format, section 1.3.7): another one after every change that does not
    /// go through a write-ahead log. Read through the connection: closing a file gives up the locks on it.
    Result<int64_t> changeCounter() const;
    bool inTransaction() const;
    /// Closes now and says whether that worked; the object is empty afterwards. Statements must be gone.
    Status close();

    /// What SQLite says about the last failure, in our words.
    Error lastError() const;

private:
    struct Closer {
        void operator()(sqlite3* handle) const;
    };
    static Result<Database> openWith(const std::string& path, const std::string& uri, int flags,
                                     const Waiting& waiting = {});

    struct Watch {
        const CancelFlag* cancel = nullptr;
        int64_t steps = 0;  ///< since the last row
        int most_waits = 0;
        bool endless = false;
    };
    friend class Statement;
    static int onProgress(void* watch);
    static int onBusy(void* watch, int waits);
    static Error failure(sqlite3* handle, const std::string& name, const Watch& watch);
    void harden(const Waiting& waiting);

    std::unique_ptr<Watch> watch_ = std::make_unique<Watch>();  ///< outlives the handle, which refers to it
    std::shared_ptr<ReadWatch> read_watch_;                     ///< likewise
    std::unique_ptr<sqlite3, Closer> handle_;
    std::string path_;
    std::string name_;
};

/// The column and parameter numbers count from 0.
class Statement {
public:
    /// nullopt binds NULL. A number that is not finite makes the next run() or step() fail (kInternal).
    Statement& bind(int parameter, int64_t value);
    Statement& bind(int parameter, double value);
    Statement& bind(int parameter, const std::optional<int64_t>& value);
    Statement& bind(int parameter, const std::optional<double>& value);
    Statement& bind(int parameter, std::string_view text);
    /// The bytes must live until the statement has run.
    Statement& bindBlob(int parameter, std::span<const std::byte> bytes);
    Statement& bindNull(int parameter);

    /// For statements without rows: runs and resets.
    Status run();
    /// True when there is a row.
    Result<bool> step();
    void reset();

    // Columns of the present row. Values of another type than asked for are absent: SQLite lets anyone store
    // anything in any column.
    bool isNull(int column) const;
    std::optional<int64_t> integer(int column) const;  ///< also a REAL without fraction
    std::optional<double> real(int column) const;      ///< finite
    std::optional<std::string> text(int column) const;
    /// Cut to so many bytes; empty when it is no text.
    std::string shortened(int column, size_t most) const;
    /// Valid until the next step() or reset().
    std::optional<std::span<const std::byte>> blob(int column) const;

private:
    friend class Database;
    struct Finalizer {
        void operator()(sqlite3_stmt* statement) const;
    };
    Error failure() const;

    std::unique_ptr<sqlite3_stmt, Finalizer> statement_;
    std::string name_;
    Database::Watch* watch_ = nullptr;
    bool not_finite_ = false;
};

/// Everything read while it lives is of one moment, whatever other programs write meanwhile.
class Snapshot {
public:
    static Result<Snapshot> begin(const Database& database);
    Snapshot(Snapshot&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
    Snapshot& operator=(Snapshot&&) = delete;
    ~Snapshot();

private:
    explicit Snapshot(const Database& database) : database_(&database) {}
    const Database* database_;
};

/// BEGIN IMMEDIATE ... COMMIT; rolled back by the destructor unless committed.
class Transaction {
public:
    static Result<Transaction> begin(const Database& database);
    Transaction(Transaction&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
    Transaction& operator=(Transaction&&) = delete;
    ~Transaction();

    Status commit();

private:
    explicit Transaction(const Database& database) : database_(&database) {}
    const Database* database_;
};

}  // namespace noctule
