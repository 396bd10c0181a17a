// SPDX-License-Identifier: Apache-2.0
// What the studio's side of the link tells its owner, in the order in which it happened. SoundBlock, pulses,
// Gap, BoxStatus and BoxError are the data; the others say how the conversation goes. A take reaches from
// Started to Stopped or TakeEnded, whichever comes; LinkLost and Resumed may lie between.
#pragma once

#include <variant>

#include "core/job/result.h"
#include "devices/driver_box/hello.h"
#include "devices/driver_box/sample_sequence.h"

namespace noctule::link {

/// A box is there; also when what it says about itself has changed.
struct Greeted {
    Hello hello;
};
/// The first data since START have come; sample 0 is the first of the take.
struct Started {};
/// The take is over as it should be: the box has sent all that it held, or was given up on.
struct Stopped {};
/// The take is over although nobody stopped it; what has come is intact.
struct TakeEnded {
    Error why;
};
/// For half a second no sound has come; Flowing follows, or LinkLost.
struct Stalled {};
struct Flowing {};
/// Close the stream. A take stays open.
struct LinkLost {
    Error why;
};
/// Open the stream again, then call opened(), or closed() when that fails.
struct ConnectWanted {
    int attempt = 1;  ///< since the link was lost
};
/// The box went on with the open take; the hole will be a Gap.
struct Resumed {};
struct RequestDone {
    Type type = Type::kQuery;
};
/// START, STOP, IDENTIFY or SET did not work. A failed STOP is followed by Stopped.
struct RequestFailed {
    Type type = Type::kQuery;
    Error why;
};
/// No box answers, or none that this program can work with: close the stream, the conversation is over.
struct Refused {
    Error why;
};

using Pulses = std::vector<EmittedPulse>;
using StudioEvent =
    std::variant<Greeted, Started, Stopped, TakeEnded, Stalled, Flowing, LinkLost, ConnectWanted, Resumed,
                 RequestDone, RequestFailed, Refused, SoundBlock, Pulses, Gap, BoxStatus, BoxError>;

}  // namespace noctule::link
