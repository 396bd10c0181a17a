// SPDX-License-Identifier: Apache-2.0
// What a box holds until its stream takes it (README.md, section 7). Answers, status and errors go first,
// then pulses, then sound, each in order. Beyond `most_samples` the oldest sound not yet begun is dropped,
// nothing else ever. Sequence numbers are given when a frame begins to be written.
#pragma once

#include <deque>
#include <optional>

#include "devices/driver_box/frame.h"
#include "devices/driver_box/messages.h"

namespace noctule::link {

class BoxQueue {
public:
    BoxQueue(int64_t most_samples, AdcFormat format) : most_samples_(most_samples), format_(format) {}

    void pushControl(Type type, Bytes payload);
    void pushPulses(const std::vector<EmittedPulse>& pulses);
    /// What had to go: its first sample and how many.
    struct Dropped {
        int64_t first_sample = 0;
        int64_t sample_count = 0;
    };
    std::optional<Dropped> pushSound(SoundBlock block);

    /// A new client: sequence numbers begin at 0, what the last one got only half of is sent again whole.
    void restart();
    /// Pulses and sound may be written.
    void allowData(bool allowed) { data_allowed_ = allowed; }
    void clearData();

    /// At most that many bytes of frames; they count as written.
    Bytes read(size_t most_bytes);

    bool holdsData() const { return resend_ || !pulses_.empty() || !sound_.empty(); }
    /// Of the sound that has not begun to be written.
    std::optional<int64_t> firstUnsentSample() const;
    int64_t heldSamples() const { return held_samples_; }
    size_t heldSmallBytes() const { return small_bytes_; }  ///< of all that is no sound
    bool holdsOverrun() const;                              ///< an ERROR about dropped sound

private:
    struct Message {
        Type type;
        Bytes payload;
    };
    std::optional<Message> next();
    Message take(std::deque<Message>& from);

    int64_t most_samples_;
    AdcFormat format_;
    std::deque<Message> control_, pulses_;
    std::deque<SoundBlock> sound_;
    std::optional<Message> resend_;  ///< data begun for a client that is gone
    int64_t held_samples_ = 0;
    size_t small_bytes_ = 0;
    bool data_allowed_ = false;

    std::optional<Message> begun_;
    Bytes frame_;         ///< of begun_
    size_t written_ = 0;  ///< of frame_
    uint32_t next_sequence_ = 0;
};

}  // namespace noctule::link
