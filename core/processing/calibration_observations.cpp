// SPDX-License-Identifier: Apache-2.0
#include "core/processing/calibration_observations.h"

#include <algorithm>
#include <filesystem>

#include "core/import/column_text.h"
#include "core/live/suit_decoder.h"
#include "core/processing/pulse_shapes.h"
#include "core/processing/sound_log.h"

namespace noctule {
namespace {

/// Arrivals as detected: no offset and no delay is taken off.
Calibration bareCalibration(const Suit& suit, const Calibration& known, Detector detector) {
    Calibration bare = nominalCalibration(suit);
    for (const Source& source : suit.sources) {
        const SourceCalibration* shaped = known.findSource(source.id);
        SourceCalibration offset;
        if (shaped) {
            offset.resonance_hz = shaped->resonance_hz;
            offset.q = shaped->q;
        }
        offset.id = source.id;
        offset.offsets_s[detectorName(detector)] = 0;
        bare.sources.push_back(offset);
    }
    return bare;
}

class Collector {
public:
    Collector(Observations& into, double sample_rate_hz, const std::vector<TemperatureStatus>& statuses)
        : into_(into), sample_rate_hz_(sample_rate_hz), sound_speed_(into.calibration.sound, statuses) {
        into_.boards.resize(into_.suit.boards.size());
        for (const Board& board : into_.suit.boards) {
            const BoardCalibration* known = into_.calibration.findBoard(board.id);
            of_counts_.push_back({!known || known->gyro.isOfCounts(), !known || known->accel.isOfCounts()});
        }
    }

    void add(const InertialReading& reading) {
        CountReading counts;
        counts.time_s = reading.sample / sample_rate_hz_;
        for (size_t axis = 0; axis < reading.counts.size(); ++axis) {
            const auto& count = reading.counts[axis];
            if (!count)
                return;
            (axis < 3 ? counts.gyro_counts : counts.accel_counts)[static_cast<Eigen::Index>(axis % 3)] =
                *count;
            counts.clipped |= of_counts_[static_cast<size_t>(reading.board)][axis / 3] &&
                              (*count <= kCountsMin || *count >= kCountsMax);
        }
        into_.boards[static_cast<size_t>(reading.board)].push_back(counts);
    }
    void add(const RangeMeasurement& range) {
        FlightTime flight;
        flight.time_s = static_cast<double>(range.pulse_sample) / sample_rate_hz_;
        flight.source = range.source;
        flight.board = range.board;
        flight.flight_s = (range.arrival_sample - static_cast<double>(range.pulse_sample)) / sample_rate_hz_;
        flight.confidence = range.w_s * range.w_t;
        flight.c_m_per_s = sound_speed_.at(range.pulse_sample);
        into_.flights.push_back(flight);
    }

private:
    Observations& into_;
    double sample_rate_hz_;
    SpeedOfSound sound_speed_;
    std::vector<std::array<bool, 2>> of_counts_;  ///< per board: gyroscope, accelerometer
};

Status decode(const Take& take, const Ingredients& in, const SoundLog& log, Collector& collector,
              const JobContext& job) {
    auto created = SuitDecoder::create(in.suit, bareCalibration(in.suit, in.calibration, in.decoder.detector),
                                       in.decoder);
    if (!created)
        return created.error();
    SuitDecoder& decoder = **created;
    const auto collect = [&] {
        for (const InertialReading& reading : decoder.takeReadings())
            collector.add(reading);
        for (const RangeMeasurement& range : decoder.takeRanges())
            collector.add(range);
    };
    auto pulse = log.pulses.begin();
    auto gap = log.gaps.begin();
    const auto boards = static_cast<int64_t>(in.suit.boards.size());
    const Status read = take.forEachBlock(1, [&](const AdcBlock& block) {
        const int64_t end = block.first_sample + static_cast<int64_t>(block.values.size()) / boards;
        for (; pulse != log.pulses.end() && pulse->sample < end; ++pulse)
            decoder.pushPulse(*pulse);
        for (; gap != log.gaps.end() && gap->first_sample < end; ++gap)
            decoder.markMissing(gap->first_sample, gap->sample_count, gap->board);
        decoder.pushBlock(block.first_sample, block.values);
        collect();
        job.progress(static_cast<double>(end) / static_cast<double>(std::max<int64_t>(1, in.sample_count)),
                     "Reading sound");
        return !job.cancelled();
    });
    if (job.cancelled())
        return JobContext::cancelledError();
    if (!read)
        return read;
    decoder.finish();
    collect();
    return Done{};
}

Status copyReadings(const Take& take, Collector& collector, const std::string& detector) {
    auto readings = take.readings(kPrimaryRun);
    if (!readings)
        return readings.error();
    for (auto next = readings->next(); !next || *next; next = readings->next()) {
        if (!next)
            return next.error();
        collector.add(**next);
    }
    auto ranges = take.ranges(kPrimaryRun);
    if (!ranges)
        return ranges.error();
    for (auto next = ranges->next(); !next || *next; next = ranges->next()) {
        if (!next)
            return next.error();
        if (ranges->detector() == detector)
            collector.add(**next);
    }
    return Done{};
}

/// A marker with a label begins a stretch, the next of its kind ends it.
std::vector<Stretch> stretchesOf(const std::vector<MarkerRow>& markers, const std::string& kind,
                                 double sample_rate_hz, double end_s) {
    std::vector<Stretch> stretches;
    bool open = false;
    for (const MarkerRow& marker : markers) {
        if (marker.kind != kind)
            continue;
        const double time_s = static_cast<double>(marker.sample) / sample_rate_hz;
        if (open)
            stretches.back().end_s = time_s;
        open = !marker.label.empty();
        if (open)
            stretches.push_back({time_s, end_s, marker.label});
    }
    return stretches;
}

}  // namespace

Result<Observations> readObservations(const Take& take, Detector detector, const JobContext& job,
                                      const std::optional<Calibration>& calibration,
                                      const std::optional<Actor>& actor) {
    ProcessRequest request;
    request.calibration = calibration;
    request.actor = actor;
    request.detector = detector;
    std::vector<std::string> warnings;
    auto in = gatherIngredients(take, request, warnings);
    if (!in)
        return in.error();
    const auto markers = take.markers();
    if (!markers)
        return markers.error();
    const auto log = readSoundLog(take);
    if (!log)
        return log.error();
    if (take.level() == TakeLevel::kSignal)
        if (Status done = completeShapes(take, *log, *in, warnings, job); !done)
            return done.error();
    const double rate_hz = in->decoder.train.sample_rate_hz;
    Observations all;
    all.take = std::filesystem::path(take.path()).filename().string();
    all.box_serial = take.boxSerial();
    all.kind = take.header().take_kind;
    all.duration_s = static_cast<double>(in->sample_count) / rate_hz;
    all.began_s = readDateAndTime(take.header().created_utc);
    all.g_m_per_s2 = take.header().g_m_per_s2;
    all.turntable_rpm = take.header().turntable_rpm;
    all.suit = in->suit;
    all.calibration = in->calibration;
    all.actor = in->actor;
    all.detector = detectorName(detector);
    all.placements = stretchesOf(*markers, "placement", rate_hz, all.duration_s);
    if (in->rest)
        all.rest = {static_cast<double>(in->rest->first) / rate_hz,
                    static_cast<double>(in->rest->second) / rate_hz, "rest"};
    Collector collector(all, rate_hz, log->statuses);
    const Status read = take.level() == TakeLevel::kSignal ? decode(take, *in, *log, collector, job)
                                                           : copyReadings(take, collector, all.detector);
    if (!read)
        return read.error();
    std::ranges::stable_sort(all.flights, {}, &FlightTime::time_s);
    return all;
}

}  // namespace noctule
