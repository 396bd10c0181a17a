// SPDX-License-Identifier: Apache-2.0
#include "core/processing/cross_clocks.h"

#include <algorithm>
#include <cmath>

#include "core/math/order_statistics.h"

namespace noctule {
namespace {

constexpr size_t kEnough = 20'000;  ///< ranges that a suit heard of others, from the take's beginning
/// While clocks are not known: their correction shows beyond it; below it stand wrong offsets of sources (25
/// samples are 57 mm).
constexpr double kByOtherClocks_m = 0.1;

/// The detector of the take's ranges; the first one stands for all.
std::string detectorOf(const Take& take) {
    for (const int suit : take.suitIds())
        if (auto ranges = take.ranges(kPrimaryRun, suit))
            if (const auto first = ranges->next(); first && *first && !ranges->detector().empty())
                return ranges->detector();
    return "inflection";
}

Calibration calibrationOf(const Take& take, int suit) {
    if (auto stored = take.calibrationInForce(suit))
        return std::move(stored->value);
    const auto described = take.suit(suit);
    return described ? nominalCalibration(*described) : Calibration{};
}

}  // namespace

double sampleRateOf(const Take& take, int suit) {
    if (const auto described = take.suit(suit); described && described->sample_rate_hz)
        return static_cast<double>(*described->sample_rate_hz);
    const auto stated = take.meta().find("sample_rate_hz");
    const double rate_hz = stated == take.meta().end() ? 0 : std::strtod(stated->second.c_str(), nullptr);
    return rate_hz > 0 ? rate_hz : static_cast<double>(take.header().sample_rate_hz);
}

SpeedOfSound soundOf(const Take& take, const Calibration& calibration) {
    double temperature_c = 0, humidity_percent = 0, temperatures = 0, humidities = 0;
    for (const int suit : take.suitIds())
        if (const auto rows = take.statusRows(suit))
            for (const StatusRow& row : *rows) {
                temperature_c += row.temperature_c.value_or(0);
                temperatures += row.temperature_c.has_value();
                humidity_percent += row.humidity_percent.value_or(0);
                humidities += row.humidity_percent.has_value();
            }
    TemperatureStatus mean{0, std::nullopt, std::nullopt};
    if (temperatures > 0)
        mean.temperature_c = temperature_c / temperatures;
    if (humidities > 0)
        mean.humidity_percent = humidity_percent / humidities;
    return SpeedOfSound(calibration.sound, std::span(&mean, 1));
}

Result<CrossClocks> CrossClocks::of(const Take& take, const TakeClocks& known) {
    CrossClocks clocks;
    if (Status added = clocks.addSuits(take, known); !added)
        return added.error();
    if (Status found = clocks.findOtherClocks(take, known); !found)
        return found.error();
    return clocks;
}

Status CrossClocks::addSuits(const Take& take, const TakeClocks& known) {
    const std::string detector = detectorOf(take);
    for (const int id : take.suitIds()) {
        const auto suit = take.suit(id);
        if (!suit)
            return suit.error();
        const Calibration calibration = calibrationOf(take, id);
        const SuitClock guess = take.suitClock(id);
        SuitDelays delays{sampleRateOf(take, id), soundOf(take, calibration).at(0), guess,
                          known.best(id, guess)};
        for (const Source& source : suit->sources) {
            const SourceCalibration* of = calibration.findSource(source.id);
            const auto offset = of ? of->offsets_s.find(detector) : decltype(of->offsets_s.end()){};
            delays.source_s.push_back(of && offset != of->offsets_s.end() ? offset->second : 0);
        }
        for (const Board& board : suit->boards) {
            const BoardCalibration* of = calibration.findBoard(board.id);
            delays.board_s.push_back(of ? of->mic_delay_s : 0);
        }
        suits_[id] = std::move(delays);
    }
    return Done{};
}

/// Distances by other clocks than the guess differ from their samples' flights by it.
Status CrossClocks::findOtherClocks(const Take& take, const TakeClocks& known) {
    struct Differences {
        std::vector<double> by_guess_m, by_best_m;  ///< of stated distances from flights by these clocks
    };
    std::map<std::pair<int, int>, Differences> differences;
    for (const int to : take.suitIds()) {
        size_t seen = 0;
        const Status walked = take.forEachCrossRange(kPrimaryRun, to, [&](const Take::CrossRange& cross) {
            if (std::isnan(cross.range.distance_m))
                return true;
            const SuitDelays& from = suits_[cross.from_suit];
            const auto difference_m = [&](SuitClock SuitDelays::*clock) {
                return cross.range.distance_m -
                       from.c_m_per_s * flight_s(from, suits_[to], cross.range, clock);
            };
            Differences& of = differences[{cross.from_suit, to}];
            of.by_guess_m.push_back(difference_m(&SuitDelays::guess));
            of.by_best_m.push_back(difference_m(&SuitDelays::best));
            return ++seen < kEnough;
        });
        if (!walked)
            return walked;
    }
    for (auto& [pair, of] : differences) {
        const double guess_m = std::abs(middleValue(std::move(of.by_guess_m)));
        by_other_clocks_[pair] = known.knows(pair.first) && known.knows(pair.second)
                                     ? std::abs(middleValue(std::move(of.by_best_m))) < guess_m
                                     : guess_m > kByOtherClocks_m;
    }
    return Done{};
}

double CrossClocks::flight_s(const SuitDelays& from, const SuitDelays& to, const RangeMeasurement& range,
                             SuitClock SuitDelays::*clock) {
    return (to.*clock).takeTime_s(range.arrival_sample / to.rate_hz) -
           (from.*clock).takeTime_s(static_cast<double>(range.pulse_sample) / from.rate_hz) -
           from.source_s[static_cast<size_t>(range.source)] - to.board_s[static_cast<size_t>(range.board)];
}

double CrossClocks::byGuess_m(int from_suit, int to_suit, const RangeMeasurement& range,
                              double c_m_per_s) const {
    const auto other = by_other_clocks_.find({from_suit, to_suit});
    const bool is_by_other_clocks = other != by_other_clocks_.end() && other->second;
    return is_by_other_clocks || std::isnan(range.distance_m)
               ? c_m_per_s * flight_s(from_suit, to_suit, range)
               : range.distance_m;
}

}  // namespace noctule
