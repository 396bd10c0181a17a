// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/board_wiring.h"

#include <algorithm>
#include <numeric>

namespace noctule::virtual_suit {
namespace {

constexpr int kFullScale = 32767;

}  // namespace

BoardWiring::BoardWiring(int board_count, int sample_rate_hz, uint64_t seed)
    : second_samples_(sample_rate_hz),
      connected_(board_count, 1),
      heard_on_(board_count),
      last_clipping_(board_count, kNever),
      random_(static_cast<std::minstd_rand::result_type>(seed)),
      sample_(board_count) {
    std::iota(heard_on_.begin(), heard_on_.end(), 0);
}

bool BoardWiring::connect(int board, bool connected) {
    return std::exchange(connected_[board], connected) != static_cast<char>(connected);
}

void BoardWiring::exchange(link::SoundBlock& block) {
    const size_t boards = heard_on_.size();
    for (size_t at = 0; at < block.values.size(); at += boards) {
        std::copy_n(block.values.data() + at, boards, sample_.data());
        for (size_t channel = 0; channel < boards; ++channel)
            block.values[at + channel] = connected_[channel]
                                             ? sample_[heard_on_[channel]]
                                             : static_cast<int16_t>(static_cast<int>(random_() % 3) - 1);
    }
}

void BoardWiring::noteClipping(const link::SoundBlock& block) {
    const size_t boards = heard_on_.size();
    for (size_t i = 0; i < block.values.size(); ++i)
        if (std::abs(block.values[i]) >= kFullScale)
            last_clipping_[i % boards] = block.first_sample + static_cast<int64_t>(i / boards);
}

void BoardWiring::apply(link::SoundBlock& block) {
    const bool as_made = std::is_sorted(heard_on_.begin(), heard_on_.end()) &&
                         std::find(connected_.begin(), connected_.end(), 0) == connected_.end();
    if (!as_made)
        exchange(block);
    noteClipping(block);
    next_sample_ = block.first_sample + block.sampleCount();
}

uint16_t BoardWiring::flags(int board) const {
    const bool clipping = next_sample_ - last_clipping_[board] <= second_samples_;
    return static_cast<uint16_t>((connected_[board] ? link::kBoardConnected : 0) |
                                 (clipping ? link::kBoardClipping : 0));
}

}  // namespace noctule::virtual_suit
