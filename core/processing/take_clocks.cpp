// SPDX-License-Identifier: Apache-2.0
#include "core/processing/take_clocks.h"

#include <algorithm>
#include <cmath>

#include "core/cooperative/offset_line.h"
#include "core/processing/cross_clocks.h"

namespace noctule {
namespace {

/// Both directions of a way share its error, so a rough value serves.
constexpr double kSoundOfFlights_m_per_s = 344;
constexpr double kUnstatedFlight_m = 0.0025;  ///< sigma of a range that states none
constexpr double kLeastConfidence = 0.5;
constexpr size_t kMostFlights = 4'000'000;  ///< 400 MB; two people with four anchors fill it in an hour

struct SuitOfFlights {
    int id = 0;
    double rate_hz = 0;
    std::vector<int> housing_of_source;  ///< the board in the same housing; -1: none
    std::vector<char> board_has_source;
};

class FlightsOfTake {
public:
    explicit FlightsOfTake(const Take& take) : take_(take) {}

    Status addSuits() {
        for (const int id : take_.suitIds()) {
            const auto suit = take_.suit(id);
            if (!suit)
                return suit.error();
            SuitOfFlights of{id, sampleRateOf(take_, id), suit->housings(), {}};
            of.board_has_source.assign(suit->boards.size(), 0);
            for (const int housing : of.housing_of_source)
                if (housing >= 0)
                    of.board_has_source[static_cast<size_t>(housing)] = 1;
            const SuitClock clock = take_.suitClock(id);
            guesses.push_back({clock.offset_ns * 1e-9, clock.rate, suit->isFixed()});
            suits.push_back(std::move(of));
        }
        auto clocks = CrossClocks::of(take_);
        if (!clocks)
            return clocks.error();
        made_by_ = std::move(*clocks);
        return Done{};
    }

    Status read(const JobContext& job) {
        Status state = Done{};
        for (size_t to = 0; to < suits.size() && state; ++to) {
            const Status walked =
                take_.forEachCrossRange(kPrimaryRun, suits[to].id, [&](const Take::CrossRange& cross) {
                    if (job.cancelled())
                        state = JobContext::cancelledError();
                    heard = true;
                    if (state && flights.size() < kMostFlights)
                        add(to, cross);
                    return state.ok();
                });
            if (state && !walked)
                return walked;
        }
        return state;
    }

    std::vector<SuitOfFlights> suits;
    std::vector<cooperative::ClockGuess> guesses;
    std::vector<cooperative::TimedFlight> flights;
    bool heard = false;

private:
    void add(size_t to, const Take::CrossRange& cross) {
        const auto from_suit = std::ranges::find(suits, cross.from_suit, &SuitOfFlights::id);
        const auto from = static_cast<size_t>(from_suit - suits.begin());
        const int housing = from_suit->housing_of_source[static_cast<size_t>(cross.range.source)];
        if (housing < 0 || !suits[to].board_has_source[static_cast<size_t>(cross.range.board)] ||
            cross.range.w_s * cross.range.w_t < kLeastConfidence)
            return;
        const double emission_s = static_cast<double>(cross.range.pulse_sample) / from_suit->rate_hz;
        const double take_s = guesses[from].offset_s + guesses[from].rate * emission_s +
                              made_by_.flight_s(cross.from_suit, suits[to].id, cross.range);
        const double sigma_m = cross.range.sigma_m > 0 ? cross.range.sigma_m : kUnstatedFlight_m;
        flights.push_back({static_cast<int>(from), static_cast<int>(to), housing, cross.range.board,
                           emission_s, (take_s - guesses[to].offset_s) / guesses[to].rate,
                           sigma_m / kSoundOfFlights_m_per_s});
    }

    const Take& take_;
    CrossClocks made_by_;
};

SuitClock lineOf(const cooperative::ClockTrack& track) {
    std::vector<cooperative::ClockOffset> offsets;
    for (const cooperative::ClockPoint& point : track.points)
        offsets.push_back({point.suit_s, point.offset_s});
    const cooperative::ClockPoint& first = track.points.front();
    const auto line = cooperative::lineThrough(offsets).value_or(
        cooperative::OffsetLine{first.offset_s - (first.rate - 1) * first.suit_s, first.rate - 1});
    return {line.at_0_s * 1e9, 1 + line.slope};
}

}  // namespace

bool clocksAreShared(const Take& take) {
    const auto shared = take.meta().find("clock_shared");
    return shared != take.meta().end() && shared->second == "1";
}

Result<TakeClocks> joinClocks(const Take& take, const JobContext& job) {
    TakeClocks clocks;
    FlightsOfTake of(take);
    if (take.suitIds().size() < 2)
        return clocks;
    if (clocksAreShared(take)) {
        for (const int id : take.suitIds())
            clocks.lines[id] = SuitClock{};
        return clocks;
    }
    if (Status added = of.addSuits(); !added)
        return added.error();
    if (Status read = of.read(job); !read)
        return read.error();
    if (!of.heard)
        return clocks;
    if (of.flights.size() == kMostFlights)
        clocks.warnings.push_back(
            "The take has more ranges between suits than are used for its clocks: their last rates are "
            "carried on to the end.");
    const auto tracks = cooperative::estimateClocks(of.flights, of.guesses);
    for (size_t i = 1; i < tracks.size(); ++i) {
        const int id = of.suits[i].id;
        if (tracks[i].joined) {
            clocks.tracks[id] = tracks[i];
            clocks.lines[id] = lineOf(tracks[i]);
        } else {
            clocks.warnings.push_back(
                "The clock of suit " + std::to_string(id) + " cannot be joined to that of suit " +
                std::to_string(of.suits.front().id) +
                ": no transceivers of both hear each other well enough. It stands alone, at the "
                "recorder's guess, which may be 5 ms off.");
        }
    }
    return clocks;
}

std::vector<ClockRow> clockRows(const cooperative::ClockTrack& track) {
    std::vector<ClockRow> rows;
    for (const cooperative::ClockPoint& point : track.points)
        rows.push_back(
            {std::llround(point.suit_s * 1e9),
             (point.suit_s + point.offset_s) * 1e9 - static_cast<double>(std::llround(point.suit_s * 1e9)),
             point.rate, point.sigma_s * 1e9});
    return rows;
}

}  // namespace noctule
