// SPDX-License-Identifier: Apache-2.0
// The latest samples of one board, contiguous, and which of them are missing from the recording. Missing
// samples read as 0. Before the first and after the last sample lie a few more zeros, so that a filter can
// look beyond both ends.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace noctule {

class SampleBuffer {
public:
    /// margin: how many samples before the first one can be read
    explicit SampleBuffer(int margin) : margin_(margin) {}

    /// Drops what it holds and goes on with that sample; marks of later samples stay.
    void startAt(int64_t sample);
    bool started() const { return !samples_.empty(); }

    /// One past the last sample held.
    int64_t end() const { return first_ + static_cast<int64_t>(samples_.size()); }
    /// A sample from the oldest kept to end(); its neighbours follow in memory.
    const float* at(int64_t sample) const { return samples_.data() + (sample - first_); }

    /// Appends one column of sample-interleaved values.
    void append(std::span<const int16_t> interleaved, int column, int columns);
    void appendMissing(int64_t count);
    /// Samples still to be appended in [first, end) shall count as missing.
    void markMissing(int64_t first, int64_t end);
    /// Whether any sample of [first, end) is missing; asked about samples not yet forgotten.
    bool anyMissing(int64_t first, int64_t end) const;

    /// Samples before this one are not needed any more.
    void forgetBefore(int64_t sample);

private:
    struct Range {
        int64_t first, end;
    };
    int margin_;
    int64_t first_ = 0;  ///< sample number of samples_[0]
    std::vector<float> samples_;
    std::vector<Range> missing_;  ///< any order, may overlap; also of samples to come
};

}  // namespace noctule
