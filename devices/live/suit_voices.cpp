// SPDX-License-Identifier: Apache-2.0
#include "devices/live/suit_voices.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace noctule {
namespace {

bool sounds(const SuitVoice& voice) {
    return !voice.hello.suit.sources.empty();
}

std::string kilohertz(double hz) {
    char text[32];
    std::snprintf(text, sizeof text, "%g kHz", hz / 1000);
    return text;
}

/// Calls `look` for each two voices until it yields an error.
template <class Look>
Status forEachPair(const std::vector<SuitVoice>& voices, Look look) {
    for (size_t i = 0; i < voices.size(); ++i)
        for (size_t j = i + 1; j < voices.size(); ++j)
            if (const Status fine = look(voices[i], voices[j]); !fine)
                return fine;
    return Done{};
}

Status checkPair(const SuitVoice& one, const SuitVoice& other) {
    if (one.hello.serial == other.hello.serial)
        return Error{ErrorKind::kDevice,
                     one.who + " and " + other.who + " are the same driver box, " + one.hello.serial,
                     "Give each suit a driver box of its own"};
    const double one_hz = one.hello.drive_hz, other_hz = other.hello.drive_hz;
    if (!sounds(one) || !sounds(other) || std::abs(one_hz - other_hz) > kLeastCarrierSpacing_hz - 1e-6)
        return Done{};
    const std::string carriers =
        one_hz == other_hz ? kilohertz(one_hz) : kilohertz(one_hz) + " and " + kilohertz(other_hz);
    return Error{
        ErrorKind::kDevice,
        one.who + " and " + other.who + " both sound at " + carriers +
            ", and only carriers 5 kHz apart can be told from each other",
        "Set one of the boxes to another carrier, such as 40, 48 or 58 kHz, in its firmware (virtual suits: "
        "start both from one --cast), or record them one after the other"};
}

}  // namespace

Status checkVoices(const std::vector<SuitVoice>& voices) {
    return forEachPair(voices, checkPair);
}

std::vector<std::string> voiceWarnings(const std::vector<SuitVoice>& voices) {
    std::vector<std::string> warnings;
    const Status looked = forEachPair(voices, [&](const SuitVoice& one, const SuitVoice& other) -> Status {
        const double one_s = static_cast<double>(one.hello.pulse_interval_samples) / one.hello.sample_rate_hz;
        const double other_s =
            static_cast<double>(other.hello.pulse_interval_samples) / other.hello.sample_rate_hz;
        if (sounds(one) && sounds(other) && one_s == other_s)
            warnings.push_back(
                one.who + " and " + other.who + " pulse at the same interval, " +
                std::to_string(one.hello.pulse_interval_samples) +
                " samples, so the same pulses may collide during the whole take. Set one of the "
                "boxes to another interval, such as 1200, 1230 or 1260 samples.");
        return Done{};
    });
    require(looked.ok(), "looking for warnings cannot fail");
    return warnings;
}

Suit withVoice(Suit suit, const link::Hello& hello) {
    suit.carrier_hz = hello.drive_hz;
    suit.pulse_interval_samples = hello.pulse_interval_samples;
    suit.pulse_cycles = hello.pulse_cycles;
    suit.sample_rate_hz = hello.sample_rate_hz;
    return suit;
}

}  // namespace noctule
