// SPDX-License-Identifier: Apache-2.0
// The requests of the studio that wait for their ACK (README.md, section 4.5). A request that is not answered
// within a second is sent again, twice at most, each time as a frame with a sequence number of its own; an
// ACK of any of them answers it. Times in nanoseconds of the caller's clock.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "devices/driver_box/messages.h"

namespace noctule::link {

class RequestBook {
public:
    static constexpr int64_t kAnswerTime_ns = 1'000'000'000;
    /// A box that goes on sending has until then to answer STOP; perhaps it never heard it.
    static constexpr int64_t kDrainTime_ns = 3'000'000'000;
    static constexpr size_t kMostSends = 3;

    /// Sends a frame and gives its sequence number.
    using Sender = std::function<uint32_t(Type, ByteView payload)>;

    void send(Type type, Bytes payload, int64_t now_ns, const Sender& sender);
    /// The type of the request that this ACK answers; nothing when none waits for it.
    std::optional<Type> answered(uint32_t sequence);
    void forget(Type type);
    /// Repeats what is due; gives what was repeated often enough. `last_sound_ns`: when ADC data last came.
    std::vector<Type> expire(int64_t now_ns, int64_t last_sound_ns, const Sender& sender);
    /// Forgets all and gives their types.
    std::vector<Type> giveUp();

private:
    struct Request {
        Type type;
        Bytes payload;
        std::vector<uint32_t> sequences;
        int64_t sent_ns;
    };
    std::vector<Request> requests_;
};

}  // namespace noctule::link
