// SPDX-License-Identifier: Apache-2.0
// The clocks of a take's boxes from its sound, to a fraction of a pulse interval, before any range is
// measured. They say which arrival belongs to which pulse; ranges then give the clocks to microseconds
// (take_clocks.h).
#pragma once

#include <map>
#include <utility>

#include "core/cooperative/offset_line.h"
#include "core/processing/measure_sound.h"
#include "core/processing/sound_log.h"

namespace noctule {

struct SoundParty {
    const SoundOfSuit& of;
    SuitClock guess;
    SoundLog log;
    /// How far the recorder's guess of its clock is ahead of take time.
    cooperative::OffsetLine error{};
    bool is_joined = false;

    double rate_hz() const { return of.decoder.train.sample_rate_hz; }
    double guessedTake_s(double sample) const { return guess.takeTime_s(sample / rate_hz()); }
    double sampleAt(double guessed_take_s) const { return guess.suitTime_s(guessed_take_s) * rate_hz(); }
    bool hears() const { return !of.described.boards.empty(); }
    bool sounds() const { return !of.described.sources.empty() && !log.pulses.empty(); }
    /// The source in this board's own housing sounds then, millimetres away: on whatever carrier, nothing
    /// else is heard.
    bool isDeafAt(int board, double sample) const;
};

/// By sender and listener: how long sound takes at first, source x board, in seconds.
using FirstWays = std::map<std::pair<size_t, size_t>, Eigen::MatrixXd>;

/// Fills in `error` and `is_joined`, against the first of them. Whoever cannot be joined is named in
/// `warnings`.
Result<FirstWays> findSoundClocks(const Take& take, std::vector<SoundParty>& parties,
                                  std::vector<std::string>& warnings, const JobContext& job);

/// For the pulses of one party in the sound of another.
Result<PulseReceiver> receiverBetween(const SoundParty& from, const SoundParty& to);

}  // namespace noctule
