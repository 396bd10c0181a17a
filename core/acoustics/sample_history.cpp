// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/sample_history.h"

#include <algorithm>

#include "core/job/contract.h"

namespace noctule {

SampleHistory::SampleHistory(int board_count, int64_t max_samples)
    : board_count_(board_count), max_samples_(max_samples) {
    require(board_count >= 1 && board_count <= 32, "a suit has 1 to 32 boards");
}

void SampleHistory::push(int64_t first_sample, std::span<const int16_t> values) {
    require(values.size() % board_count_ == 0, "a block holds whole samples");
    int64_t count = int64_t(values.size()) / board_count_;
    if (first_sample + count <= end())
        return;
    if (const int64_t known = end() - first_sample; known > 0) {
        values = values.subspan(size_t(known * board_count_));
        first_sample += known;
        count -= known;
    }
    if (const int64_t hole = first_sample - end(); hole > 0) {
        markMissing(end(), hole, std::nullopt);
        if (hole >= max_samples_)
            dropBefore(first_sample);
        else
            values_.resize(values_.size() + size_t(hole * board_count_));
    }
    values_.insert(values_.end(), values.begin(), values.end());
    dropBefore(end() - max_samples_);
}

void SampleHistory::markMissing(int64_t first_sample, int64_t sample_count, std::optional<int> board) {
    const uint32_t boards = board ? uint32_t(1) << *board : ~uint32_t(0);
    const int64_t end = first_sample + sample_count;
    if (!gaps_.empty() && gaps_.back().end == first_sample && gaps_.back().boards == boards)
        gaps_.back().end = end;
    else if (end > begin_)
        gaps_.push_back({first_sample, end, boards});
}

void SampleHistory::dropBefore(int64_t sample) {
    if (sample <= begin_)
        return;
    used_from_ = std::min(values_.size(),
                          used_from_ + size_t(std::min(sample - begin_, end() - begin_)) * board_count_);
    begin_ = sample;
    std::erase_if(gaps_, [sample](const Gap& gap) { return gap.end <= sample; });
    if (used_from_ < values_.size() / 2)  // moving the rest down is worth it only when little is left
        return;
    values_.erase(values_.begin(), values_.begin() + ptrdiff_t(used_from_));
    used_from_ = 0;
}

std::span<const int16_t> SampleHistory::window(int64_t first, int64_t count) const {
    if (first < begin_ || first + count > end())
        return {};
    return std::span(values_).subspan(used_from_ + size_t((first - begin_) * board_count_),
                                      size_t(count * board_count_));
}

uint32_t SampleHistory::missingBoards(int64_t first, int64_t count) const {
    uint32_t boards = 0;
    for (const Gap& gap : gaps_)
        if (gap.begin < first + count && gap.end > first)
            boards |= gap.boards;
    return boards;
}

}  // namespace noctule
