// SPDX-License-Identifier: Apache-2.0
// What waits for the take while another program holds it, oldest first. The first 64 MB of sound (12 s of a
// whole suit) wait in memory, the rest in a file without a name beside the take. Sound that this file cannot
// take becomes a gap of the studio.
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <variant>

#include "core/job/unnamed_file.h"
#include "devices/live/live_item.h"

namespace noctule {

class RecorderBacklog {
public:
    static constexpr int64_t kInMemory_bytes = 64'000'000;

    explicit RecorderBacklog(std::filesystem::path folder, int64_t in_memory_bytes = kInMemory_bytes)
        : folder_(std::move(folder)), in_memory_bytes_(in_memory_bytes) {}

    void push(LiveItem item);
    bool empty() const { return entries_.empty(); }
    /// The oldest one; not empty().
    LiveItem pop();

    struct Extent {
        int64_t memory_bytes = 0, file_bytes = 0;            ///< of sound that waits now
        int64_t most_memory_bytes = 0, most_file_bytes = 0;  ///< so far
    };
    const Extent& extent() const { return extent_; }

private:
    /// A block whose values stand in the file.
    struct Stored {
        ArrivedBlock shell;
        int64_t position = 0;
        size_t values = 0;
    };
    std::optional<Stored> store(const ArrivedBlock& block);
    LiveItem fetch(const Stored& stored);

    std::filesystem::path folder_;
    int64_t in_memory_bytes_;
    std::deque<std::variant<LiveItem, Stored>> entries_;
    std::optional<UnnamedFile> file_;
    int64_t end_ = 0;  ///< of the file
    Extent extent_;
};

}  // namespace noctule
