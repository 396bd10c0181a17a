// SPDX-License-Identifier: Apache-2.0
// The last few seconds of a suit's samples, sample-interleaved, and which of them are missing. Blocks come in
// any size; what is pushed twice is ignored, what is never pushed is missing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace noctule {

class SampleHistory {
public:
    /// Never keeps more than max_samples: the oldest go first.
    SampleHistory(int board_count, int64_t max_samples);

    /// `values` holds whole samples of all boards.
    void push(int64_t first_sample, std::span<const int16_t> values);
    /// Of one board, or of all. May come before or after the samples.
    void markMissing(int64_t first_sample, int64_t sample_count, std::optional<int> board);
    /// Forgets everything before `sample`.
    void dropBefore(int64_t sample);

    int64_t begin() const { return begin_; }
    int64_t end() const { return begin_ + int64_t(values_.size() - used_from_) / board_count_; }

    /// Samples first..first+count; empty when they are not all here.
    std::span<const int16_t> window(int64_t first, int64_t count) const;
    /// Bit b is set when any sample of board b in first..first+count is missing. At most 32 boards.
    uint32_t missingBoards(int64_t first, int64_t count) const;

private:
    struct Gap {
        int64_t begin, end;
        uint32_t boards;
    };

    int board_count_;
    int64_t max_samples_;
    int64_t begin_ = 0;
    size_t used_from_ = 0;  // values_ before this are dropped already
    std::vector<int16_t> values_;
    std::vector<Gap> gaps_;
};

}  // namespace noctule
