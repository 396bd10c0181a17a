// SPDX-License-Identifier: Apache-2.0
#include "core/inertial/sample_buffer.h"

#include <algorithm>

namespace noctule {

void SampleBuffer::startAt(int64_t sample) {
    first_ = sample - margin_;
    samples_.assign(margin_, 0.0f);
    std::erase_if(missing_, [&](const Range& range) { return range.end <= sample; });
    missing_.push_back({first_, sample});
}

void SampleBuffer::append(std::span<const int16_t> interleaved, int column, int columns) {
    const int64_t begin = end();
    const size_t count = interleaved.size() / columns, old_size = samples_.size();
    samples_.resize(old_size + count);
    const int16_t* in = interleaved.data() + column;
    for (float* out = samples_.data() + old_size; out != samples_.data() + samples_.size(); in += columns)
        *out++ = *in;
    for (const Range& range : missing_) {
        const int64_t from = std::max(range.first, begin), to = std::min(range.end, end());
        for (int64_t s = from; s < to; ++s)
            samples_[s - first_] = 0;
    }
}

void SampleBuffer::appendMissing(int64_t count) {
    const int64_t begin = end();
    samples_.resize(samples_.size() + count, 0.0f);
    missing_.push_back({begin, end()});
}

void SampleBuffer::markMissing(int64_t first, int64_t last) {
    if (started())
        first = std::max(first, end());
    if (first < last)
        missing_.push_back({first, last});
}

bool SampleBuffer::anyMissing(int64_t first, int64_t last) const {
    return std::any_of(missing_.begin(), missing_.end(),
                       [&](const Range& range) { return range.first < last && first < range.end; });
}

void SampleBuffer::forgetBefore(int64_t sample) {
    constexpr int64_t kWorthwhile = 8192;  // moving what remains pays off only now and then
    const int64_t gone = std::min(sample, end()) - first_;
    if (gone < kWorthwhile)
        return;
    samples_.erase(samples_.begin(), samples_.begin() + gone);
    first_ += gone;
    std::erase_if(missing_, [&](const Range& range) { return range.end <= first_; });
}

}  // namespace noctule
