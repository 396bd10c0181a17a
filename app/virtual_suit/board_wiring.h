// SPDX-License-Identifier: Apache-2.0
// The cables between the boards and the box's channels: pulled out, or two of them exchanged. Boards are
// indices in HELLO.
#pragma once

#include <random>
#include <vector>

#include "devices/driver_box/messages.h"

namespace noctule::virtual_suit {

class BoardWiring {
public:
    BoardWiring(int board_count, int sample_rate_hz, uint64_t seed);

    /// False: it was so already.
    bool unplug(int board) { return connect(board, false); }
    bool plug(int board) { return connect(board, true); }
    /// Each is heard on the other's channel from now on.
    void swap(int a, int b) { std::swap(heard_on_[a], heard_on_[b]); }
    /// The box has been started: the last one's clipping is forgotten.
    void restart() { last_clipping_.assign(last_clipping_.size(), kNever); }

    /// What the boards put out becomes what the channels convert. An open channel sees a count of noise.
    void apply(link::SoundBlock& block);
    /// Of STATUS, after all that was applied.
    uint16_t flags(int board) const;

private:
    static constexpr int64_t kNever = INT64_MIN / 2;
    bool connect(int board, bool connected);
    void exchange(link::SoundBlock& block);
    void noteClipping(const link::SoundBlock& block);

    int64_t second_samples_, next_sample_ = 0;
    std::vector<char> connected_;
    std::vector<int> heard_on_;  ///< per channel the board on its cable
    std::vector<int64_t> last_clipping_;
    std::minstd_rand random_;
    std::vector<int16_t> sample_;
};

}  // namespace noctule::virtual_suit
