// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/range_rows.h"

namespace noctule::simulation {
namespace {

/// Across the chamber; beyond that nothing is heard.
constexpr double kFarthestInChamber_m = 8;

/// Sources of one suit and boards of another as one suit, and what a laboratory knows of them.
std::pair<Suit, Calibration> pairOf(const Stage& speaker, const Stage& listener) {
    Suit suit{speaker.suit.name, listener.suit.boards, speaker.suit.sources};
    Calibration calibration = speaker.calibration;
    calibration.boards = listener.calibration.boards;
    return {std::move(suit), std::move(calibration)};
}

/// The mean of what all boxes measured, row by row.
std::vector<TemperatureStatus> meanStatus(const std::vector<std::vector<TemperatureStatus>>& status,
                                          size_t suit) {
    std::vector<TemperatureStatus> mean = status[suit];
    for (size_t row = 0; row < mean.size(); ++row) {
        double temperature_c = 0, humidity_percent = 0, count = 0;
        for (const std::vector<TemperatureStatus>& one : status)
            if (row < one.size()) {
                temperature_c += *one[row].temperature_c;
                humidity_percent += *one[row].humidity_percent;
                ++count;
            }
        mean[row].temperature_c = temperature_c / count;
        mean[row].humidity_percent = humidity_percent / count;
    }
    return mean;
}

}  // namespace

Result<RangeRows> RangeRows::create(const std::vector<StagedSuit>& suits,
                                    const std::vector<std::vector<TemperatureStatus>>& status,
                                    const std::optional<Room>& chamber) {
    RangeRows rows(suits);
    for (size_t suit = 0; suit < suits.size(); ++suit)
        if (Status added = rows.addSpeaker(suit, status, chamber); !added)
            return added.error();
    return rows;
}

Status RangeRows::addSpeaker(size_t suit, const std::vector<std::vector<TemperatureStatus>>& status,
                             const std::optional<Room>& chamber) {
    std::vector<const World*> worlds;
    HiddenTruth truth = suits_[suit].stage->truth;
    truth.sound.boards.clear();
    for (const StagedSuit& one : suits_) {
        worlds.push_back(one.stage->world.get());
        const std::vector<BoardTruth>& boards = one.stage->truth.sound.boards;
        truth.sound.boards.insert(truth.sound.boards.end(), boards.begin(), boards.end());
    }
    const Scenario& scenario = suits_[suit].stage->scenario;
    auto speaker = std::make_unique<Speaker>(
        Speaker{CastWorld(worlds, suit), scenario.schedule(), suits_[suit].sampleCount()});
    speaker->readings = std::make_unique<PulseReadings>(speaker->world, scenario, truth, chamber);
    const PulseSchedule& schedule = speaker->schedule;
    const PulseTrain train{suits_[suit].rate_hz(), schedule.interval_samples, schedule.drive_hz,
                           schedule.cycles};
    for (size_t listener = 0; listener < suits_.size(); ++listener) {
        const auto [pair, calibration] = pairOf(*suits_[suit].stage, *suits_[listener].stage);
        RangeSettings settings;
        if (suits_.size() > 1)
            settings.max_distance_m = kFarthestInChamber_m;
        auto finder = RangeFinder::create(pair, calibration, train, Detector::kInflection, settings);
        if (!finder)
            return finder.error();
        for (const TemperatureStatus& row : meanStatus(status, suit))
            finder->soundSpeed().add(row);
        speaker->listeners.push_back(std::move(*finder));
    }
    speakers_.push_back(std::move(speaker));
    return Done{};
}

bool RangeRows::hasPulse(const Speaker& speaker) const {
    return !speaker.schedule.isSilent(speaker.world.sourceCount()) &&
           (speaker.next + 1) * speaker.schedule.interval_samples <= speaker.end_sample;
}

Result<bool> RangeRows::writeNext(TakeWriter& take, SimulationSummary& summary) {
    std::optional<size_t> first;
    for (size_t s = 0; s < speakers_.size(); ++s) {
        if (!hasPulse(*speakers_[s]))
            continue;
        const double drive_s = suits_[s].takeTimeOf_s(
            static_cast<double>(speakers_[s]->next * speakers_[s]->schedule.interval_samples));
        if (!first || drive_s < reached_s_) {
            first = s;
            reached_s_ = drive_s;
        }
    }
    if (!first)
        return false;
    Speaker& speaker = *speakers_[*first];
    Pulse pulse = speaker.schedule.pulse(speaker.next++, speaker.world.sourceCount());
    const Result<int64_t> id = take.addPulse(pulse.sample, pulse.source, suits_[*first].id);
    if (!id)
        return id.error();
    pulse.id = *id;
    ++summary.pulses;
    speaker.readings->hear(pulse, reached_s_, detections_);
    for (const PulseDetection& detection : detections_)
        if (const auto range = rangeOf(*first, detection, reached_s_)) {
            const size_t listener = speaker.world.ownerOf(detection.board).suit;
            if (Status done = take.addRange(kPrimaryRun, *range, detectorName(Detector::kInflection),
                                            suits_[listener].id);
                !done)
                return done.error();
            ++summary.range_rows;
        }
    return true;
}

std::optional<RangeMeasurement> RangeRows::rangeOf(size_t speaker, PulseDetection detection, double drive_s) {
    const CastWorld& world = speakers_[speaker]->world;
    const BoardOfCast owner = world.ownerOf(detection.board);
    if (world.sourceBoard(detection.pulse.source) == detection.board)
        return std::nullopt;  // a housing's own pulse
    detection.board = owner.board;
    RangeFinder& finder = speakers_[speaker]->listeners[owner.suit];
    auto range = finder.process(detection);
    const StagedSuit &from = suits_[speaker], &to = suits_[owner.suit];
    if (!range || (from.clock->isTakeTime() && to.clock->isTakeTime()))
        return range;
    const auto drive_sample = static_cast<double>(detection.pulse.sample);
    const double flight_s = (detection.arrival_sample - drive_sample) / from.rate_hz();
    range->arrival_sample = to.clock->suitTime_s(drive_s + flight_s) * to.rate_hz();
    if (range->arrival_sample < 0 ||
        range->arrival_sample >= static_cast<double>(speakers_[owner.suit]->end_sample))
        return std::nullopt;  // before the box was on, or after
    const double believed_s = to.first_guess.takeTime_s(range->arrival_sample / to.rate_hz()) -
                              from.first_guess.takeTime_s(drive_sample / from.rate_hz());
    range->distance_m += finder.soundSpeed().at(detection.pulse.sample) * (believed_s - flight_s);
    return range;
}

}  // namespace noctule::simulation
