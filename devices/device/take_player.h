// SPDX-License-Identifier: Apache-2.0
// A take of sound as what a driver box would have said: HELLO from its suit, then pulses, ADC blocks of up to
// 600 samples, status, gaps, and boards that were lost for a while, in the order of the samples. Only the
// first suit of a take is played. Not for several threads at once; reads no clock.
#pragma once

#include "core/recording/take.h"
#include "devices/driver_box/studio_event.h"

namespace noctule {

class TakePlayer {
public:
    /// kUnusable for a take without sound.
    static Result<TakePlayer> open(const std::string& path);

    const link::Hello& hello() const { return hello_; }
    /// What a box that does not stream would report; absent when the take has no status.
    std::optional<link::BoxStatus> idleStatus() const;

    /// `due_sample`: the box would have had it when it had taken that many samples. False ends the play.
    using Sink = std::function<bool(link::StudioEvent event, int64_t due_sample)>;
    Status play(const Sink& sink) const;

private:
    /// A board whose values are 0 because it was not heard.
    struct BoardGap {
        int64_t sample = 0;
        int board = 0;
        bool begins = true;
    };
    class Course;

    explicit TakePlayer(Take take) : take_(std::move(take)) {}
    Status load();
    Status loadHello();
    void loadGaps(const std::vector<GapRow>& gaps);
    link::BoxStatus statusOf(const StatusRow& row) const;
    link::GapReason reasonOf(int64_t first_sample) const;

    Take take_;
    int suit_ = 1;
    link::Hello hello_;
    int64_t end_sample_ = 0;
    std::vector<link::EmittedPulse> pulses_;  ///< these three rise
    std::vector<StatusRow> statuses_;
    std::vector<BoardGap> board_gaps_;
    std::vector<GapRow> gaps_;  ///< of all boards
};

}  // namespace noctule
