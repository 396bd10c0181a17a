// SPDX-License-Identifier: Apache-2.0
#include "core/processing/measure_sound.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <unordered_map>

#include "core/cooperative/coarse_clock.h"
#include "core/job/atomic_file.h"
#include "core/processing/pulse_shapes.h"
#include "core/recording/take_writer.h"

namespace noctule {
namespace {

constexpr double kStretch_s = 1.5, kStretchesApart_s = 10;  ///< in which the clocks are sought
constexpr int kMostStretches = 60;
constexpr double kLead_s = 0.0004;  ///< before a pulse's emission: clocks are known to less
constexpr double kOutlier_s = 0.001;
/// A slot is 2.7 m of sound long. It lies about where sound has been arriving, so that people may stand
/// further apart.
constexpr double kFarthest_m = 8;
constexpr double kSettles = 0.01;  ///< share of one arrival in where the next are expected
constexpr double kTrusted = 0.5;   ///< of it

/// ahead of the true take time, as a line of take time.
struct ClockError {
    double at_0_s = 0, slope = 0;
    double at(double take_s) const { return at_0_s + slope * take_s; }
};

struct Point {
    double take_s, ahead_s;
};

/// The line through most of the points.
ClockError lineThrough(std::vector<Point> points) {
    ClockError line{points.front().ahead_s, 0};
    if (points.size() == 1)
        return line;
    size_t most = 0;
    for (size_t i = 0; i < points.size(); ++i)
        for (size_t k = i + 1; k < points.size(); ++k) {
            const double slope =
                (points[k].ahead_s - points[i].ahead_s) / (points[k].take_s - points[i].take_s);
            const ClockError candidate{points[i].ahead_s - slope * points[i].take_s, slope};
            const auto fits = static_cast<size_t>(std::ranges::count_if(points, [&](const Point& p) {
                return std::abs(p.ahead_s - candidate.at(p.take_s)) < kOutlier_s;
            }));
            if (fits > most)
                most = fits, line = candidate;
        }
    std::erase_if(points,
                  [&](const Point& p) { return std::abs(p.ahead_s - line.at(p.take_s)) > kOutlier_s; });
    double n = 0, t = 0, a = 0, tt = 0, ta = 0;
    for (const Point& p : points)
        n += 1, t += p.take_s, a += p.ahead_s, tt += p.take_s * p.take_s, ta += p.take_s * p.ahead_s;
    const double spread = n * tt - t * t;
    if (!(spread > 0))
        return line;
    const double slope = (n * ta - t * a) / spread;
    return {(a - slope * t) / n, slope};
}

/// Sources of one suit with the boards of another.
Suit joined(const Suit& sources, const Suit& boards) {
    Suit suit = boards;
    suit.sources = sources.sources;
    return suit;
}
Calibration joined(const Calibration& sources, const Calibration& boards) {
    Calibration calibration = boards;
    calibration.sources = sources.sources;
    return calibration;
}

/// By source: a board that is near it on the same suit.
std::vector<int> boardsNear(const Suit& suit) {
    std::vector<int> near;
    for (const Source& source : suit.sources) {
        int board = source.board.empty() ? -1 : suit.findBoard(source.board);
        for (size_t b = 0; b < suit.boards.size() && board < 0 && !source.segment.empty(); ++b)
            if (suit.boards[b].segment == source.segment)
                board = static_cast<int>(b);
        near.push_back(board);
    }
    return near;
}

class SoundMeasurement {
public:
    SoundMeasurement(Take& take, std::vector<SoundOfSuit> suits, std::vector<std::string>& warnings,
                     const JobContext& job)
        : take_(take), suits_(std::move(suits)), warnings_(warnings), job_(job) {}

    Status run(TakeWriter& writer) {
        for (SoundOfSuit& suit : suits_)
            if (Status read = addParty(suit); !read)
                return read;
        if (Status copied = copyTables(writer); !copied)
            return copied;
        if (Status found = findClocks(); !found)
            return found;
        for (size_t to = 0; to < parties_.size(); ++to)
            if (Status measured = measure(to, writer); !measured)
                return measured;
        return Done{};
    }

private:
    struct Party {
        const SoundOfSuit& of;
        SuitClock guess;
        SoundLog log;
        ClockError error{};
        bool is_joined = false;

        double rate_hz() const { return of.decoder.train.sample_rate_hz; }
        double guessedTake_s(double sample) const { return guess.takeTime_s(sample / rate_hz()); }
        double sampleAt(double guessed_take_s) const { return guess.suitTime_s(guessed_take_s) * rate_hz(); }
        bool hears() const { return !of.described.boards.empty(); }
        bool sounds() const { return !of.described.sources.empty() && !log.pulses.empty(); }
    };

    /// A pulse in the listener's samples.
    struct Sent {
        int64_t sample = 0;         ///< by the clocks as they were found, rounded
        double guessed_sample = 0;  ///< by the recorder's guess
    };
    /// One suit's sources heard by another suit's boards.
    struct Ear {
        size_t from;
        PulseReceiver receiver;
        RangeFinder finder;
        std::unordered_map<int64_t, Sent> sent;  ///< by pulse id
        double way_s = 0;                        ///< of the sound, lately
        size_t next_pulse = 0;                   ///< of the log, not yet awaited
    };

    Status addParty(SoundOfSuit& suit) {
        take_.view(suit.suit);
        auto log = readSoundLog(take_);
        if (!log)
            return log.error();
        Ingredients in;  // what completeShapes() reads of it
        in.suit = suit.described;
        in.calibration = suit.calibration;
        in.decoder = suit.decoder;
        if (!suit.described.boards.empty())
            if (Status complete = completeShapes(take_, *log, in, warnings_, job_); !complete)
                return complete;
        suit.calibration = in.calibration;
        parties_.push_back({suit, take_.suitClock(suit.suit), std::move(*log)});
        return Done{};
    }

    Status copyTables(TakeWriter& writer) {
        for (const char* key : {"subjects", "clock_shared"})
            if (const auto found = take_.meta().find(key); found != take_.meta().end())
                if (Status set = writer.setMeta(key, found->second); !set)
                    return set;
        for (const int id : take_.suitIds()) {
            const auto suit = take_.suit(id);
            if (!suit)
                return suit.error();
            const auto added = writer.addSuit(*suit, take_.suitClock(id));
            if (!added)
                return added.error();
            if (*added != id)
                return Error{ErrorKind::kUnusable, take_.path() + ": its suits are not counted from 1",
                             "Record it again, or process each subject with --between off --room off"};
            const auto rows = take_.statusRows(id);
            if (!rows)
                return rows.error();
            for (const StatusRow& row : *rows)
                if (Status status = writer.addStatus(row, id); !status)
                    return status;
        }
        for (const Party& party : parties_) {
            if (const auto added = writer.addCalibration(party.of.calibration, party.of.suit); !added)
                return added.error();
            for (const Pulse& pulse : party.log.pulses)
                if (Status added = writer.addPulse(pulse, party.of.suit); !added)
                    return added;
        }
        return Done{};
    }

    // ---- clocks

    Status findClocks() {
        parties_.front().is_joined = true;
        if (const auto shared = take_.meta().find("clock_shared");
            shared != take_.meta().end() && shared->second == "1") {
            for (Party& party : parties_)
                party.is_joined = true;
            return Done{};
        }
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
                    const ClockError& known = parties_[a].error;
                    parties_[b].error = {(*found)->at_0_s + known.at_0_s, (*found)->slope + known.slope};
                    parties_[b].is_joined = any = true;
                }
        }
        for (const Party& party : parties_)
            if (!party.is_joined)
                warnings_.push_back(
                    "The clock of suit " + std::to_string(party.of.suit) +
                    " cannot be found from the sound: it and the others do not hear each other well "
                    "enough. Distances to it are not used.");
        return Done{};
    }

    Result<std::optional<ClockError>> clockBetween(size_t a, size_t b) {
        std::optional<ClockError> none;
        if (!parties_[a].sounds())
            return none;
        const Party& first = parties_[a];
        const double begin_s = first.guessedTake_s(static_cast<double>(first.log.pulses.front().sample));
        const double end_s = first.guessedTake_s(static_cast<double>(first.log.pulses.back().sample));
        const int stretches =
            std::clamp(static_cast<int>((end_s - begin_s) / kStretchesApart_s) + 1, 1, kMostStretches);
        std::vector<Point> points;
        std::optional<cooperative::CoarseClock> before;
        for (int i = 0; i < stretches; ++i) {  // the first lies where the standing pose is held
            const double from_s = begin_s + (end_s - begin_s - kStretch_s) * i / stretches;
            auto there = listen(a, b, from_s), back = listen(b, a, from_s);
            if (!there)
                return there.error();
            if (!back)
                return back.error();
            if (const auto found = cooperative::coarseClock(*there, *back, before)) {
                before = found;
                if (points.empty())
                    way_s_[{a, b}] = way_s_[{b, a}] = found->way_s;
                points.push_back({from_s + kStretch_s / 2, found->ahead_s});
            }
            job_.progress(0, "Finding the clocks");
            if (job_.cancelled())
                return JobContext::cancelledError();
        }
        if (points.empty())
            return none;
        return std::optional(lineThrough(std::move(points)));
    }

    Result<PulseReceiver> receiverOf(const Party& from, const Party& to) const {
        PulseTrain train = from.of.decoder.train;
        train.sample_rate_hz = to.rate_hz();
        return PulseReceiver::create(from.of.decoder.detector, train,
                                     static_cast<int>(to.of.described.boards.size()),
                                     shapesOf(from.of.described, from.of.calibration));
    }

    /// Everything that the boards of one suit hear on the carrier of another for a while.
    Result<cooperative::Direction> listen(size_t a, size_t b, double from_s) {
        const Party &from = parties_[a], &to = parties_[b];
        cooperative::Direction direction;
        direction.interval_s = from.of.decoder.train.interval_samples / from.rate_hz();
        direction.board_near = boardsNear(from.of.described);
        direction.places_m = from.of.source_places_m;
        direction.boards_m = to.of.board_places_m;
        direction.from_room = from.of.is_room;
        auto receiver = receiverOf(from, to);
        if (!receiver)
            return receiver.error();
        const auto first = static_cast<int64_t>(to.sampleAt(from_s));
        const auto end = static_cast<int64_t>(to.sampleAt(from_s + kStretch_s));
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
            if (!one.gap && !one.clipped && one.snr() >= RangeSettings{}.min_snr) {
                const double delay_s =
                    (one.arrival_sample - emissions[static_cast<size_t>(one.pulse.id)]) / to.rate_hz();
                direction.arrivals.push_back({static_cast<int>(one.pulse.id), one.board,
                                              std::clamp(delay_s, 0.0, direction.interval_s)});
            }
        return direction;
    }

    // ---- ranges

    Result<Ear> earOf(size_t from_index, size_t to_index) {
        const Party &from = parties_[from_index], &to = parties_[to_index];
        auto receiver = receiverOf(from, to);
        if (!receiver)
            return receiver.error();
        PulseTrain train = from.of.decoder.train;
        train.sample_rate_hz = to.rate_hz();
        RangeSettings settings;
        settings.max_distance_m = kFarthest_m;
        auto finder = RangeFinder::create(joined(from.of.described, to.of.described),
                                          joined(from.of.calibration, to.of.calibration), train,
                                          from.of.decoder.detector, settings);
        if (!finder)
            return finder.error();
        Ear ear{from_index, std::move(*receiver), std::move(*finder), {}, way_s_[{from_index, to_index}]};
        for (const TemperatureStatus& status : to.log.statuses)
            ear.finder.soundSpeed().add(status);
        for (const GapRow& gap : to.log.gaps)
            ear.receiver.markMissing(gap.first_sample, gap.sample_count, gap.board);
        return ear;
    }

    /// Makes the slots of all pulses that are sent before a sample of the listener.
    void await(int64_t until, Ear& ear, const Party& to) const {
        const Party& from = parties_[ear.from];
        const double interval_s = from.of.decoder.train.interval_samples / from.rate_hz();
        for (; ear.next_pulse < from.log.pulses.size(); ++ear.next_pulse) {
            const Pulse& pulse = from.log.pulses[ear.next_pulse];
            const double guessed_s = from.guessedTake_s(static_cast<double>(pulse.sample));
            const double shift_s = to.error.at(guessed_s) - from.error.at(guessed_s);
            const double emission = to.sampleAt(guessed_s + shift_s);
            if (emission >= static_cast<double>(until))
                return;
            const double late_s = std::max(-kLead_s, ear.way_s - interval_s / 2);
            const auto begin = static_cast<int64_t>(emission + late_s * to.rate_hz());
            if (emission < 0 || !ear.receiver.pushPulse({pulse.id, begin, pulse.source}))
                continue;
            ear.sent[pulse.id] = {std::llround(emission), to.sampleAt(guessed_s)};
        }
    }

    /// As distances between suits stand in a take: by the recorder's guess of both clocks.
    static std::optional<RangeMeasurement> rangeOf(PulseDetection detection, Ear& ear, const Party& to) {
        const Sent& sent = ear.sent.at(detection.pulse.id);
        detection.pulse.sample = sent.sample;
        auto range = ear.finder.process(detection);
        if (!range)
            return range;
        if (range->confidence() >= kTrusted)
            ear.way_s += kSettles * (range->distance_m / ear.finder.soundSpeed().at(sent.sample) - ear.way_s);
        range->distance_m += ear.finder.soundSpeed().at(sent.sample) *
                             (static_cast<double>(sent.sample) - sent.guessed_sample) / to.rate_hz();
        return range;
    }

    Status measure(size_t index, TakeWriter& writer) {
        const Party& to = parties_[index];
        if (!to.hears())
            return Done{};
        std::unique_ptr<SuitDecoder> decoder;
        if (!to.of.is_room) {
            auto made = SuitDecoder::create(to.of.described, to.of.calibration, to.of.decoder);
            if (!made)
                return made.error();
            decoder = std::move(*made);
            feed(*decoder, to.log);
        }
        std::vector<Ear> ears;
        for (size_t from = 0; from < parties_.size(); ++from)
            if (from != index && parties_[from].sounds() && parties_[from].is_joined && to.is_joined) {
                auto ear = earOf(from, index);
                if (!ear)
                    return ear.error();
                ears.push_back(std::move(*ear));
            }
        Status state = Done{};
        const Status read = take_.forEachBlock(to.of.suit, [&](const AdcBlock& block) {
            if (decoder) {
                decoder->pushBlock(block.first_sample, block.values);
                state = write(*decoder, to, writer);
            }
            for (Ear& ear : ears) {
                await(block.first_sample +
                          static_cast<int64_t>(block.values.size() / to.of.described.boards.size()),
                      ear, to);
                ear.receiver.pushBlock(block.first_sample, block.values);
                std::vector<PulseDetection> heard;
                ear.receiver.advance(ear.receiver.samplesEnd(), heard);
                if (state)
                    state = write(heard, ear, to, writer);
            }
            job_.progress(0, "Measuring the sound");
            if (job_.cancelled())
                state = JobContext::cancelledError();
            return state.ok();
        });
        if (!state || !read)
            return state ? read : state;
        return finish(decoder.get(), ears, to, writer);
    }

    Status finish(SuitDecoder* decoder, std::vector<Ear>& ears, const Party& to, TakeWriter& writer) {
        if (decoder) {
            decoder->finish();
            for (const SourceProblem& problem : decoder->sourceProblems())
                warnings_.push_back("No distances from a source: " + problem.reason + ".");
            if (Status written = write(*decoder, to, writer); !written)
                return written;
        }
        for (Ear& ear : ears) {
            std::vector<PulseDetection> heard;
            ear.receiver.finish(heard);
            if (Status written = write(heard, ear, to, writer); !written)
                return written;
        }
        return Done{};
    }

    static void feed(SuitDecoder& decoder, const SoundLog& log) {
        for (const Pulse& pulse : log.pulses)
            decoder.pushPulse(pulse);
        for (const TemperatureStatus& status : log.statuses)
            decoder.pushStatus(status);
        for (const GapRow& gap : log.gaps)
            decoder.markMissing(gap.first_sample, gap.sample_count, gap.board);
    }

    static Status write(SuitDecoder& decoder, const Party& to, TakeWriter& writer) {
        for (const InertialReading& reading : decoder.takeReadings())
            if (Status added = writer.addInertial(kPrimaryRun, reading, to.of.suit); !added)
                return added;
        for (const RangeMeasurement& range : decoder.takeRanges())
            if (Status added =
                    writer.addRange(kPrimaryRun, range, detectorName(to.of.decoder.detector), to.of.suit);
                !added)
                return added;
        return Done{};
    }
    Status write(const std::vector<PulseDetection>& heard, Ear& ear, const Party& to, TakeWriter& writer) {
        for (const PulseDetection& detection : heard)
            if (const auto range = rangeOf(detection, ear, to))
                if (Status added =
                        writer.addRange(kPrimaryRun, *range,
                                        detectorName(parties_[ear.from].of.decoder.detector), to.of.suit);
                    !added)
                    return added;
        return Done{};
    }

    Take& take_;
    std::vector<SoundOfSuit> suits_;
    std::vector<std::string>& warnings_;
    const JobContext& job_;
    std::vector<Party> parties_;
    std::map<std::pair<size_t, size_t>, double> way_s_;  ///< of the sound between two at first
};

}  // namespace

Result<Take> measureSound(Take& take, std::vector<SoundOfSuit> suits, const std::string& folder,
                          std::vector<std::string>& warnings, const JobContext& job) {
    TakeHeader header = take.header();
    const std::string path =
        asidePath((std::filesystem::path(folder) / (header.uuid + "_measured.noctule")).string());
    auto writer = TakeWriter::create(path, header);
    if (!writer)
        return writer.error();
    SoundMeasurement measurement(take, std::move(suits), warnings, job);
    if (Status measured = measurement.run(*writer); !measured)
        return measured.error();
    if (Status finished = writer->finish(); !finished)
        return finished.error();
    auto measured = Take::open(path);
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    return measured;
}

}  // namespace noctule
