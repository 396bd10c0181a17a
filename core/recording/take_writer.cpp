// SPDX-License-Identifier: Apache-2.0
#include "core/recording/take_writer.h"

#include <zstd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "core/job/atomic_file.h"

namespace noctule {

namespace {

// Blocks of sound are long: big pages keep their chains of overflow pages short.
constexpr const char* kPageSize = "PRAGMA page_size=16384";
constexpr int kZstdLevel = 1;
constexpr double kPatienceAtEnd_s = 120;  // for another program that writes: without it nothing is complete
constexpr double kPatienceWithReaders_s = 10;  // their take is complete all the same

std::string number(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

bool exists(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

/// A log beside the file to be replaced belongs to a recording that runs or needs recovery; SQLite would also
/// apply it to the new file.
Status checkNoLogBeside(const std::string& path) {
    for (const char* ending : {"-wal", "-journal"})
        if (exists(path + ending))
            return Error{ErrorKind::kUsage,
                         path + ": " + path + ending + " stands beside it, so it is in use",
                         "Choose another name, or run `noctule --batch recover` on it first"};
    return Done{};
}

}  // namespace

Result<TakeWriter> TakeWriter::create(const std::string& path, const TakeHeader& header,
                                      const Options& options) {
    const bool aside = options.journal == Journal::kAside;
    if (const Status free = checkOutputPath(path, aside && options.overwrite); !free)
        return free.error();
    if (const Status free = checkNoLogBeside(path); !free)
        return free.error();
    Result<Database> made = Database::create(aside ? asidePath(path) : path);
    if (!made)
        return made.error();
    made->setDisplayName(path);
    TakeWriter writer(std::make_unique<Database>(std::move(*made)), path, options);
    if (const Status prepared = writer.prepare(header); !prepared) {
        writer.abandon();
        return prepared.error();
    }
    return writer;
}

TakeWriter::~TakeWriter() {
    if (!file_)
        return;
    if (options_.journal == Journal::kAside)
        abandon();
    else
        dropStatements();
}

Status TakeWriter::prepare(const TakeHeader& header) {
    // Written aside there is nothing to roll back to and publishFile() syncs once at the end.
    const std::string journal = options_.journal == Journal::kWal
                                    ? "PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL"
                                    : "PRAGMA journal_mode=MEMORY; PRAGMA synchronous=OFF";
    const std::string identity = "PRAGMA application_id=" + std::to_string(kTakeApplicationId) +
                                 "; PRAGMA user_version=" + std::to_string(kTakeUserVersion);
    for (const std::string& sql : {std::string(kPageSize), journal, identity, std::string("BEGIN")})
        if (const Status done = file_->execute(sql); !done)
            return done;
    for (const TableDefinition& table : takeTables())
        if (table.required)
            if (const Status made = schema().complete(*file_, table.name); !made)
                return made;
    if (const Status written = writeHeader(header); !written)
        return written;
    return options_.journal == Journal::kWal ? commit() : Status(Done{});
}

Status TakeWriter::writeHeader(const TakeHeader& header) {
    require(header.sample_rate_hz > 0, "a take needs a sample rate");
    const std::vector<std::pair<std::string, std::string>> entries{
        {"format", "noctule-take"},
        {"uuid", header.uuid},
        {"name", header.name},
        {"created_utc", header.created_utc},
        {"software", header.software},
        {"sample_rate_hz", std::to_string(header.sample_rate_hz)},
        {"board_count", std::to_string(header.board_count)},
        {"source_count", std::to_string(header.source_count)},
        {"pulse_interval_samples", std::to_string(header.pulse_interval_samples)},
        {"pulse_cycles", number(header.pulse_cycles)},
        {"drive_hz", number(header.drive_hz)},
        {"take_kind", header.take_kind},
        {"state", "recording"}};
    for (const auto& [key, value] : entries)
        if (const Status set = setMeta(key, value); !set)
            return set;
    return Done{};
}

Status TakeWriter::addBlock(const AdcBlock& block, int board_count, int suit, bool compress) {
    require(board_count > 0 && block.values.size() % static_cast<size_t>(board_count) == 0,
            "a block must hold whole samples");
    const auto sample_count = static_cast<int64_t>(block.values.size()) / board_count;
    require(sample_count >= 1 && sample_count <= kMaxBlockSamples, "a block must hold 1 to 65536 samples");
    require(block.first_sample >= 0, "a block must not begin before sample 0");
    std::span<const std::byte> data = std::as_bytes(block.values);
    if (compress) {
        packed_.resize(ZSTD_compressBound(data.size()));
        const size_t size =
            ZSTD_compress(packed_.data(), packed_.size(), data.data(), data.size(), kZstdLevel);
        require(!ZSTD_isError(size), "zstd refused a buffer of the size it asked for");
        data = std::span(packed_).first(size);
    }
    auto insert = insertInto("adc_block");
    if (!insert)
        return insert.error();
    (*insert)->bindNull(0).bind(1, int64_t{suit}).bind(2, block.first_sample).bind(3, sample_count);
    const Status added = (*insert)->bind(4, int64_t{compress ? 1 : 0}).bindBlob(5, data).run();
    if (added && suit == 1)  // meta speaks of suit 1
        end_sample_ = std::max(end_sample_, block.first_sample + sample_count);
    return added;
}

Status TakeWriter::commit() {
    if (options_.journal == Journal::kAside)
        return Done{};
    if (file_->inTransaction())
        if (const Status committed = file_->execute("COMMIT"); !committed)
            return committed;
    committed_end_sample_ = end_sample_;
    const auto goes_on = ready();
    return goes_on ? Status(Done{}) : Status(goes_on.error());
}

Result<bool> TakeWriter::ready() {
    if (options_.journal == Journal::kAside || file_->inTransaction())
        return true;
    file_->setPatience_s(0);
    const Status begun = file_->execute("BEGIN IMMEDIATE");
    const bool locked = !begun && file_->isLocked();
    file_->setPatience_s(Waiting().patience_s);
    return begun || locked ? Result<bool>(begun.ok()) : Result<bool>(begun.error());
}

Status TakeWriter::rollBack() {
    require(options_.journal == Journal::kWal, "only a recording has something to go back to");
    dropStatements();
    end_sample_ = committed_end_sample_;
    // A full disk may have made SQLite roll back by itself.
    if (file_->inTransaction())
        if (const Status back = file_->execute("ROLLBACK"); !back)
            return back;
    const auto begun = ready();
    return begun ? Status(Done{}) : Status(begun.error());
}

/// Readers keep it from being folded in; the take is whole with it, too.
Status TakeWriter::foldLog() {
    file_->setPatience_s(kPatienceWithReaders_s);
    const Status folded = file_->execute("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode=DELETE");
    left_log_ = !folded && file_->isLocked();
    return left_log_ ? Status(Done{}) : folded;
}

Status TakeWriter::closeFile() {
    file_->setPatience_s(kPatienceAtEnd_s);
    if (!file_->inTransaction())
        if (const Status begun = file_->execute("BEGIN IMMEDIATE"); !begun)
            return begun;
    if (end_sample_ > 0)
        if (const Status set = setMeta("sample_count", std::to_string(end_sample_)); !set)
            return set;
    if (const Status set = setMeta("state", "complete"); !set)
        return set;
    dropStatements();
    if (const Status done = file_->execute("COMMIT"); !done)
        return done;
    if (options_.journal == Journal::kWal)
        if (const Status done = foldLog(); !done)
            return done;
    return file_->close();
}

Status TakeWriter::finish() {
    require(file_ != nullptr, "a take can be finished once");
    const std::string written = file_->path();
    if (const Status closed = closeFile(); !closed)
        return closed;
    if (options_.journal == Journal::kAside)
        if (const Status published = publishFile(written, path_, options_.overwrite); !published)
            return published;
    file_.reset();
    return Done{};
}

void TakeWriter::abandon() {
    if (!file_)
        return;
    dropStatements();
    const std::string written = file_->path();
    file_.reset();
    std::error_code ignored;
    for (const char* ending : {"", "-wal", "-shm", "-journal"})
        std::filesystem::remove(written + ending, ignored);
}

}  // namespace noctule
