// SPDX-License-Identifier: Apache-2.0
#include "core/processing/measure_sound.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <unordered_map>

#include "core/cooperative/coarse_clock.h"
#include "core/job/atomic_file.h"
#include "core/math/order_statistics.h"
#include "core/processing/pulse_shapes.h"
#include "core/processing/sound_clocks.h"
#include "core/recording/take_writer.h"
#include "core/suit/calibration_entries.h"

namespace noctule {
namespace {

constexpr double kLead_s = 0.0004;  ///< before a pulse's emission: clocks are known to less
/// A slot is 2.7 m of sound long. It lies about where a source's sound has been arriving, so that people may
/// stand further apart and anchors hang where they like.
constexpr double kFarthest_m = 8;
/// Weights of one arrival in the way of its source's sound, and beyond that in the way to its board.
constexpr double kSettles = 0.03, kSettlesAtBoard = 0.1;
constexpr ptrdiff_t kNeighbours = 3;  ///< pulses before and after, whose sound may be taken for a pulse's own
constexpr double kTrusted = 0.5;      ///< confidence from which an arrival counts there

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

class SoundMeasurement {
public:
    SoundMeasurement(Take& take, std::vector<SoundOfSuit> suits, std::vector<std::string>& warnings,
                     const JobContext& job)
        : take_(take), suits_(std::move(suits)), warnings_(warnings), job_(job) {}

    Status run(TakeWriter& writer) {
        for (SoundOfSuit& suit : suits_)
            if (Status read = addParty(suit); !read)
                return read;
        supposeShapes();
        if (Status copied = copyTables(writer); !copied)
            return copied;
        auto ways = findSoundClocks(take_, parties_, warnings_, job_);
        if (!ways)
            return ways.error();
        ways_ = std::move(*ways);
        for (size_t to = 0; to < parties_.size(); ++to)
            if (Status measured = measure(to, writer); !measured)
                return measured;
        return Done{};
    }

private:
    /// A pulse in the listener's samples.
    struct Sent {
        ptrdiff_t index = 0;        ///< in the sender's log
        int64_t sample = 0;         ///< by the clocks as they were found, rounded
        double guessed_sample = 0;  ///< by the recorder's guess
    };
    /// One suit's sources heard by another suit's boards, or anchors heard by each other.
    struct Ear {
        size_t from;
        PulseReceiver receiver;
        RangeFinder finder;
        std::unordered_map<int64_t, Sent> sent{};  ///< by pulse id
        Eigen::MatrixXd ways_s{};                  ///< of the sound, lately; source x board
        bool knows_ways = false;                   ///< else they began at 0
        size_t next_pulse = 0;                     ///< of the log, not yet awaited
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
        parties_.push_back({suit, take_.suitClock(suit.suit), std::move(*log), {}, false});
        return Done{};
    }

    /// Of anchors without microphones nobody can learn the pulses: they are taken as like those of the
    /// others.
    void supposeShapes() {
        std::vector<double> known;
        for (const SoundParty& party : parties_)
            for (const SourceCalibration& source : party.of.calibration.sources)
                if (source.q)
                    known.push_back(*source.q);
        for (SoundOfSuit& suit : suits_) {
            if (!suit.described.boards.empty() || known.empty())
                continue;
            for (const Source& source : suit.described.sources) {
                SourceCalibration& entry = entryOf(suit.calibration, source);
                if (entry.resonance_hz && entry.q)
                    continue;
                entry.resonance_hz = suit.decoder.train.drive_hz;
                entry.q = medianOf(known);
            }
        }
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
        for (const SoundParty& party : parties_) {
            if (const auto added = writer.addCalibration(party.of.calibration, party.of.suit); !added)
                return added.error();
            for (const Pulse& pulse : party.log.pulses)
                if (Status added = writer.addPulse(pulse, party.of.suit); !added)
                    return added;
        }
        return Done{};
    }

    Result<Ear> earOf(size_t from_index, size_t to_index) {
        const SoundParty &from = parties_[from_index], &to = parties_[to_index];
        auto receiver = receiverBetween(from, to);
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
        Ear ear{from_index, std::move(*receiver), std::move(*finder)};
        ear.ways_s =
            Eigen::MatrixXd::Zero(std::ssize(from.of.described.sources), std::ssize(to.of.described.boards));
        const auto ways = ways_.find({from_index, to_index});
        ear.knows_ways = from_index == to_index || ways != ways_.end();
        if (ear.knows_ways)
            ear.ways_s = from_index == to_index ? waysIn(to.of) : ways->second;
        for (const TemperatureStatus& status : to.log.statuses)
            ear.finder.soundSpeed().add(status);
        for (const GapRow& gap : to.log.gaps)
            ear.receiver.markMissing(gap.first_sample, gap.sample_count, gap.board);
        return ear;
    }

    /// Between the anchors of a room, by the places that its file states.
    static Eigen::MatrixXd waysIn(const SoundOfSuit& room) {
        Eigen::MatrixXd ways_s(std::ssize(room.source_places_m), std::ssize(room.board_places_m));
        for (Eigen::Index source = 0; source < ways_s.rows(); ++source)
            for (Eigen::Index board = 0; board < ways_s.cols(); ++board)
                ways_s(source, board) = (room.source_places_m[static_cast<size_t>(source)] -
                                         room.board_places_m[static_cast<size_t>(board)])
                                            .norm() /
                                        cooperative::kSupposedSound_m_per_s;
        return ways_s;
    }

    /// Makes the slots of all pulses that are sent before a sample of the listener.
    void await(int64_t until, Ear& ear, const SoundParty& to) const {
        const SoundParty& from = parties_[ear.from];
        const double interval_s = from.of.decoder.train.interval_samples / from.rate_hz();
        for (; ear.next_pulse < from.log.pulses.size(); ++ear.next_pulse) {
            const Pulse& pulse = from.log.pulses[ear.next_pulse];
            const double guessed_s = from.guessedTake_s(static_cast<double>(pulse.sample));
            const double shift_s = to.error.at(guessed_s) - from.error.at(guessed_s);
            const double emission = to.sampleAt(guessed_s + shift_s);
            if (emission >= static_cast<double>(until))
                return;
            const double late_s = std::max(-kLead_s, ear.ways_s.row(pulse.source).mean() - interval_s / 2);
            const auto begin = static_cast<int64_t>(emission + late_s * to.rate_hz());
            if (emission < 0 || !ear.receiver.pushPulse({pulse.id, begin, pulse.source}))
                continue;
            ear.sent[pulse.id] = {static_cast<ptrdiff_t>(ear.next_pulse), std::llround(emission),
                                  to.sampleAt(guessed_s)};
        }
    }

    /// It fits another pulse better than the one in whose slot it was heard.
    bool isOfNeighbour(const PulseDetection& detection, const Sent& sent, const Ear& ear,
                       const SoundParty& to) const {
        const auto& pulses = parties_[ear.from].log.pulses;
        const auto miss_s = [&](const Pulse& pulse, int64_t sample) {
            return std::abs((detection.arrival_sample - static_cast<double>(sample)) / to.rate_hz() -
                            ear.ways_s(pulse.source, detection.board));
        };
        if (!ear.knows_ways)
            return false;
        const double own_s = miss_s(detection.pulse, sent.sample);
        const ptrdiff_t end = std::min(std::ssize(pulses), sent.index + kNeighbours + 1);
        for (ptrdiff_t i = std::max(ptrdiff_t(0), sent.index - kNeighbours); i < end; ++i)
            if (const auto other = ear.sent.find(pulses[static_cast<size_t>(i)].id);
                i != sent.index && other != ear.sent.end() &&
                miss_s(pulses[static_cast<size_t>(i)], other->second.sample) < own_s)
                return true;
        return false;
    }

    /// As distances between suits stand in a take: by the recorder's guess of both clocks.
    std::optional<RangeMeasurement> rangeOf(PulseDetection detection, Ear& ear, const SoundParty& to) const {
        const Sent& sent = ear.sent.at(detection.pulse.id);
        if (to.isDeafAt(detection.board, detection.arrival_sample) || isOfNeighbour(detection, sent, ear, to))
            return std::nullopt;
        detection.pulse.sample = sent.sample;
        auto range = ear.finder.process(detection);
        if (!range)
            return range;
        if (range->confidence() >= kTrusted) {
            auto ways_s = ear.ways_s.row(detection.pulse.source);
            const double miss_s =
                range->distance_m / ear.finder.soundSpeed().at(sent.sample) - ways_s[detection.board];
            ways_s.array() += kSettles * miss_s;
            ways_s[detection.board] += kSettlesAtBoard * miss_s;
        }
        range->distance_m += ear.finder.soundSpeed().at(sent.sample) *
                             (static_cast<double>(sent.sample) - sent.guessed_sample) / to.rate_hz();
        return range;
    }

    Status measure(size_t index, TakeWriter& writer) {
        const SoundParty& to = parties_[index];
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
            if ((from != index || to.of.is_room) && parties_[from].sounds() && parties_[from].is_joined &&
                to.is_joined) {
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

    Status finish(SuitDecoder* decoder, std::vector<Ear>& ears, const SoundParty& to, TakeWriter& writer) {
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

    static Status write(SuitDecoder& decoder, const SoundParty& to, TakeWriter& writer) {
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
    Status write(const std::vector<PulseDetection>& heard, Ear& ear, const SoundParty& to,
                 TakeWriter& writer) {
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
    std::vector<SoundParty> parties_;
    FirstWays ways_;
};

}  // namespace

Result<Take> measureSound(Take& take, std::vector<SoundOfSuit> suits, const std::string& folder,
                          std::vector<std::string>& warnings, const JobContext& job) {
    TakeHeader header = take.header();
    const std::string path =
        asidePath((std::filesystem::path(folder) / (header.uuid + "_measured.noctule")).string());
    auto writer = TakeWriter::create(path, header);
    if (!writer)
        return namedAs(writer.error(), path, folder);
    SoundMeasurement measurement(take, std::move(suits), warnings, job);
    if (Status measured = measurement.run(*writer); !measured)
        return namedAs(measured.error(), path, folder);
    if (Status finished = writer->finish(); !finished)
        return namedAs(finished.error(), path, folder);
    auto measured = Take::open(path);
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    return measured;
}

}  // namespace noctule
