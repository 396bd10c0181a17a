// SPDX-License-Identifier: Apache-2.0
// What a recorder writes into: a take file; in tests something slow, full or broken. Used by one thread.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/job/result.h"
#include "core/recording/take_writer.h"
#include "devices/live/live_item.h"

namespace noctule {

class TakeSink {
public:
    virtual ~TakeSink() = default;

    virtual const std::string& path() const = 0;
    /// Whether what is written now would not wait for another program; does not wait itself.
    virtual Result<bool> ready() { return true; }
    virtual Status write(const LiveItem& item) = 0;
    /// Makes safe what was written.
    virtual Status commit() = 0;
    /// After a failure: as it was at the last commit().
    virtual Status rollBack() = 0;
    /// Leaves one complete file.
    virtual Status finish() = 0;
    /// After finish(): the take is complete with the -wal file beside it, for another program reads it.
    virtual bool leftLog() const { return false; }
    /// On the disk that it is written to; absent: cannot be told.
    virtual std::optional<int64_t> freeBytes() const = 0;
};

/// What is known before the first sample.
struct TakePlan {
    std::filesystem::path folder;
    std::string name = "take";  ///< "walk" becomes the next free walk_###
    TakeHeader header;          ///< its name and uuid are made
    Suit suit;
    std::optional<Calibration> calibration;
    std::optional<Actor> actor;
    std::map<std::string, std::string> meta;  ///< performer, actor_name, box_serial, ...
    std::vector<MarkerRow> markers;
    bool compress = false;  ///< blocks as zstd: about three quarters of the size
};

/// Makes the file under its name and commits what is known.
Result<std::unique_ptr<TakeSink>> makeTakeFile(const TakePlan& plan);

/// One file of several suits, which count from 1: a sink each, every one for a thread of its own. The first
/// plan names the file and describes the take. What fails for one has failed for all; the last one to finish
/// completes the file. The clocks of the suits are guessed from when their first blocks came.
Result<std::vector<std::unique_ptr<TakeSink>>> makeTakeFiles(const std::vector<TakePlan>& plans);

/// A take that did not come to be: removes the file, and what SQLite keeps beside it.
void discardTakeFile(const std::string& path);

}  // namespace noctule
