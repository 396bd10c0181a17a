// SPDX-License-Identifier: Apache-2.0
#include "core/processing/sound_clocks.h"

#include <algorithm>
#include <cmath>

#include "core/cooperative/coarse_clock.h"
#include "core/processing/take_clocks.h"

namespace noctule {
namespace {

constexpr double kStretch_s = 1.5, kStretchesApart_s = 10;  ///< in which the clocks are sought
/// The first stretch of a pair with a room: of the rest pose, which lasts for three seconds. Anchors hear
/// little.
constexpr double kStanding_s = 2.5;
constexpr double kOutlier_s = 0.001;
constexpr std::ptrdiff_t kRecent = 12;  ///< stretches
/// A pulse in the own housing: what is found of it on another carrier lies from 0.1 ms before it to 1 ms
/// after.
constexpr double kOwnLead_s = 0.0001, kOwnPulse_s = 0.001;

struct Stretch {
    double from_s, to_s;  ///< guessed take time
};

/// By source: a board that is near it on the same suit.
std::vector<int> boardsNear(const Suit& suit) {
    std::vector<int> near = suit.housings();
    for (size_t s = 0; s < near.size(); ++s) {
        const std::string& segment = suit.sources[s].segment;
        for (size_t b = 0; b < suit.boards.size() && near[s] < 0 && !segment.empty(); ++b)
            if (suit.boards[b].segment == segment)
                near[s] = static_cast<int>(b);
    }
    return near;
}

class SoundClocks {
public:
    SoundClocks(const Take& take, std::vector<SoundParty>& parties, std::vector<std::string>& warnings,
                const JobContext& job)
        : take_(take), parties_(parties), warnings_(warnings), job_(job) {}

    Status run() {
        parties_.front().is_joined = true;
        if (clocksAreShared(take_))
            for (SoundParty& party : parties_)
                party.is_joined = true;
        for (bool any = true; any;) {  // from those that are joined to those that they hear
            any = false;
            for (size_t a = 0; a < parties_.size(); ++a)
                for (size_t b = 0; b < parties_.size(); ++b) {
                    if (!parties_[a].is_joined || parties_[b].is_joined)
                        continue;
                    const auto found = clockBetween(a, b);
                    if (!found)
                        return found.error();
                    if (!*found)
                        continue;
                    const cooperative::OffsetLine& known = parties_[a].error;
                    parties_[b].error = {(*found)->at_0_s + known.at_0_s, (*found)->slope + known.slope};
                    parties_[b].is_joined = any = true;
                }
        }
        for (size_t a = 0; a < parties_.size(); ++a)
            for (size_t b = a + 1; b < parties_.size(); ++b)
                if (Status found = findWays(a, b); !found)
                    return found;
        for (const SoundParty& party : parties_)
            if (!party.is_joined)
                warnings_.push_back(
                    "The clock of suit " + std::to_string(party.of.suit) +
                    " cannot be found from the sound: it and the others do not hear each other well "
                    "enough. Distances to it are not used.");
        return Done{};
    }

    FirstWays ways;

private:
    Result<std::optional<cooperative::OffsetLine>> clockBetween(size_t a, size_t b) {
        std::optional<cooperative::OffsetLine> none;
        if (!parties_[a].sounds() && !parties_[b].sounds())
            return none;
        const auto [begin_s, end_s] = soundingTime(a, b);
        const int stretches = std::max(1, static_cast<int>((end_s - begin_s) / kStretchesApart_s) + 1);
        std::vector<cooperative::ClockOffset> points;
        std::optional<cooperative::CoarseClock> before;
        for (int i = 0; i < stretches; ++i) {  // the first lies where the standing pose is held
            const double from_s = begin_s + (end_s - begin_s - kStretch_s) * i / stretches;
            const bool is_room = parties_[a].of.is_room || parties_[b].of.is_room;
            const double lasts_s = i == 0 && is_room ? kStanding_s : kStretch_s;
            auto found = coarseClock(a, b, {from_s, from_s + lasts_s}, before);
            if (!found)
                return found.error();
            if (*found) {
                points.push_back({from_s + lasts_s / 2, (*found)->ahead_s});
                before = std::move(*found);
            }
            // Where nobody is heard for a while, the clock is believed to go on as it did.
            if (before && points.size() > 1)
                before->ahead_s =
                    cooperative::lineThroughMost(
                        {points.end() - std::min(std::ssize(points), kRecent), points.end()}, kOutlier_s)
                        .at(from_s + kStretchesApart_s + kStretch_s / 2);
            job_.progress(0, "Finding the clocks");
        }
        if (points.empty())
            return none;
        return std::optional(cooperative::lineThroughMost(std::move(points), kOutlier_s));
    }

    /// From the first to the last pulse of the first of the two that sends any, on guessed take time.
    std::pair<double, double> soundingTime(size_t a, size_t b) const {
        const SoundParty& party = parties_[a].sounds() ? parties_[a] : parties_[b];
        return {party.guessedTake_s(static_cast<double>(party.log.pulses.front().sample)),
                party.guessedTake_s(static_cast<double>(party.log.pulses.back().sample))};
    }

    /// By what both hear of each other in one stretch. The ways of the first stretch are kept.
    Result<std::optional<cooperative::CoarseClock>> coarseClock(
        size_t a, size_t b, const Stretch& stretch, const std::optional<cooperative::CoarseClock>& before) {
        const auto there = listen(a, b, stretch), back = listen(b, a, stretch);
        if (!there)
            return there.error();
        if (!back)
            return back.error();
        if (job_.cancelled())
            return JobContext::cancelledError();
        auto found = cooperative::coarseClock(*there, *back, before);
        if (found) {
            ways.try_emplace({a, b}, found->there_s);
            ways.try_emplace({b, a}, found->back_s);
        }
        return found;
    }

    /// Of two that were joined by others, or share a clock: the first stretch in which they hear each other.
    Status findWays(size_t a, size_t b) {
        const SoundParty &first = parties_[a], &second = parties_[b];
        if (!first.is_joined || !second.is_joined || ways.contains({a, b}) ||
            (!first.sounds() && !second.sounds()))
            return Done{};
        const auto [begin_s, end_s] = soundingTime(a, b);
        for (double from_s = begin_s; from_s < end_s; from_s += kStretchesApart_s) {
            cooperative::CoarseClock known;
            known.ahead_s = second.error.at(from_s) - first.error.at(from_s);
            const auto found = coarseClock(a, b, {from_s, from_s + kStretch_s}, known);
            if (!found)
                return found.error();
            if (*found)
                break;
        }
        return Done{};
    }

    /// Everything that the boards of one suit hear on the carrier of another for a while.
    Result<cooperative::Direction> listen(size_t a, size_t b, const Stretch& stretch) {
        const SoundParty &from = parties_[a], &to = parties_[b];
        cooperative::Direction direction;
        direction.interval_s = from.of.decoder.train.interval_samples / from.rate_hz();
        direction.board_near = boardsNear(from.of.described);
        direction.places_m = from.of.source_places_m;
        direction.boards_m = to.of.board_places_m;
        direction.from_room = from.of.is_room;
        if (!from.sounds() || !to.hears())
            return direction;
        auto receiver = receiverBetween(from, to);
        if (!receiver)
            return receiver.error();
        const auto first = static_cast<int64_t>(to.sampleAt(stretch.from_s));
        const auto end = static_cast<int64_t>(to.sampleAt(stretch.to_s));
        std::vector<double> emissions;
        std::vector<PulseDetection> heard;
        const Status read =
            take_.forEachBlock(to.of.suit, SampleInterval{first, end}, [&](const AdcBlock& block) {
                receiver->pushBlock(block.first_sample, block.values);
                return !job_.cancelled();
            });
        if (!read)
            return read.error();
        for (const Pulse& pulse : from.log.pulses) {
            const double sample = to.sampleAt(from.guessedTake_s(static_cast<double>(pulse.sample)));
            if (sample < static_cast<double>(first) || sample > static_cast<double>(end))
                continue;
            receiver->pushPulse(
                {static_cast<int64_t>(emissions.size()), static_cast<int64_t>(sample), pulse.source});
            emissions.push_back(sample);
            direction.sources.push_back(pulse.source);
        }
        receiver->finish(heard);
        for (const PulseDetection& one : heard)
            if (!one.gap && !one.clipped && one.snr() >= RangeSettings{}.min_snr &&
                !to.isDeafAt(one.board, one.arrival_sample)) {
                const double delay_s =
                    (one.arrival_sample - emissions[static_cast<size_t>(one.pulse.id)]) / to.rate_hz();
                direction.arrivals.push_back({static_cast<int>(one.pulse.id), one.board,
                                              std::clamp(delay_s, 0.0, direction.interval_s)});
            }
        return direction;
    }

    const Take& take_;
    std::vector<SoundParty>& parties_;
    std::vector<std::string>& warnings_;
    const JobContext& job_;
};

}  // namespace

bool SoundParty::isDeafAt(int board, double sample) const {
    const std::string& housing = of.described.boards[static_cast<size_t>(board)].id;
    auto pulse = std::ranges::upper_bound(log.pulses, sample + kOwnLead_s * rate_hz(), {},
                                          [](const Pulse& one) { return static_cast<double>(one.sample); });
    while (pulse != log.pulses.begin() &&
           static_cast<double>((--pulse)->sample) > sample - kOwnPulse_s * rate_hz())
        if (of.described.sources[static_cast<size_t>(pulse->source)].board == housing)
            return true;
    return false;
}

Result<PulseReceiver> receiverBetween(const SoundParty& from, const SoundParty& to) {
    PulseTrain train = from.of.decoder.train;
    train.sample_rate_hz = to.rate_hz();
    return PulseReceiver::create(from.of.decoder.detector, train,
                                 static_cast<int>(to.of.described.boards.size()),
                                 shapesOf(from.of.described, from.of.calibration));
}

Result<FirstWays> findSoundClocks(const Take& take, std::vector<SoundParty>& parties,
                                  std::vector<std::string>& warnings, const JobContext& job) {
    SoundClocks clocks(take, parties, warnings, job);
    if (Status found = clocks.run(); !found)
        return found.error();
    return std::move(clocks.ways);
}

}  // namespace noctule
