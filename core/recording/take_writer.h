// SPDX-License-Identifier: Apache-2.0
// Makes a new take file. For a simulation or an import it is written aside and gets its name in finish(), so
// that no half file is ever seen. A recording (Journal::kWal) stands under its name from the start, and what
// commit() has written survives a crash.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/recording/take_tables.h"

namespace noctule {

class TakeWriter : public TakeTables {
public:
    enum class Journal {
        kAside,  ///< all or nothing
        kWal,    ///< survives kill -9 and power loss up to the last commit(); never overwrites
    };
    struct Options {
        bool overwrite = false;  ///< kAside only
        Journal journal = Journal::kAside;
    };

    /// Makes the tables and writes the header. kUsage when something stands at `path` already.
    static Result<TakeWriter> create(const std::string& path, const TakeHeader& header,
                                     const Options& options);
    static Result<TakeWriter> create(const std::string& path, const TakeHeader& header) {
        return create(path, header, Options{});
    }
    TakeWriter(TakeWriter&&) = default;
    /// Unless finished: a file written aside is removed, a recording keeps what was committed.
    ~TakeWriter();

    /// `values` holds whole samples of all boards of the suit, at most 65536 samples; compressed with zstd on
    /// request. Blocks must not overlap.
    Status addBlock(const AdcBlock& block, int board_count, int suit, bool compress = false);

    /// Makes everything so far safe (kWal); a recorder calls it at least every 200 ms.
    Status commit();
    /// Takes the right to write (kWal), which commit() keeps as far as it can. False: another program has it,
    /// and what would be added now would wait for that program. Does not wait.
    Result<bool> ready();
    /// After a write that failed (kWal): everything since the last commit() is gone, finish() may follow.
    Status rollBack();
    /// Sets `state` to complete and `sample_count`, and leaves one file under its name; a recording that
    /// another program reads keeps its log beside it, which the next to open it folds in.
    Status finish();
    bool leftLog() const { return left_log_; }
    /// Removes what was written.
    void abandon();

private:
    TakeWriter(std::unique_ptr<Database> file, std::string path, const Options& options)
        : TakeTables(file.get(), {}), file_(std::move(file)), path_(std::move(path)), options_(options) {}
    Status prepare(const TakeHeader& header);
    Status writeHeader(const TakeHeader& header);
    Status closeFile();
    Status foldLog();

    std::unique_ptr<Database> file_;  ///< empty once finished or abandoned
    std::string path_;
    Options options_;
    int64_t end_sample_ = 0, committed_end_sample_ = 0;
    bool left_log_ = false;
    std::vector<std::byte> packed_;
};

}  // namespace noctule
