// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/simulate.h"

#include <cmath>
#include <cstdio>

#include "core/acoustics/range_finder.h"
#include "core/math/rotation.h"
#include "core/recording/take_writer.h"
#include "core/simulation/pulse_readings.h"
#include "core/simulation/signal_sampler.h"

namespace noctule::simulation {
namespace {

constexpr int64_t kBlockSamples = 6000;  // 40 ms at 150 kHz
constexpr double kReferencePerSecond = 140;

/// Random version-4 form, but from the seed: the same request gives the same take.
std::string uuidOf(uint64_t seed) {
    Random random(seed, "uuid");
    const uint64_t a = (random.bits() & ~0xF000ULL) | 0x4000ULL,
                   b = (random.bits() >> 2) | 0x8000000000000000ULL;
    char text[40];
    std::snprintf(text, sizeof text, "%08x-%04x-%04x-%04x-%012llx", static_cast<unsigned>(a >> 32),
                  static_cast<unsigned>((a >> 16) & 0xFFFF), static_cast<unsigned>(a & 0xFFFF),
                  static_cast<unsigned>(b >> 48), static_cast<unsigned long long>(b & 0xFFFFFFFFFFFFULL));
    return text;
}

/// Writes one take; every step stops at the first error.
class TakeMaker {
public:
    TakeMaker(const Stage& stage, const TakeRequest& request, const JobContext& job, TakeWriter& take)
        : stage_(stage),
          request_(request),
          job_(job),
          take_(take),
          rate_hz_(stage.scenario.sample_rate_hz),
          samples_(stage.sampleCount()) {}

    Status make() {
        using Step = Status (TakeMaker::*)();
        const bool sound = request_.level == Level::kSignal;
        for (const Step step :
             {&TakeMaker::writeHeader, &TakeMaker::writeStatus, &TakeMaker::writeTruth,
              &TakeMaker::writeExternalRoot, sound ? &TakeMaker::writeSound : &TakeMaker::writeInertia,
              sound ? &TakeMaker::writePulses : &TakeMaker::writeRanges})
            if (Status done = (this->*step)(); !done)
                return done;
        return Done{};
    }

    const SimulationSummary& summary() const { return summary_; }

private:
    int64_t timeNs(double t_s) const { return std::llround(t_s * 1e9); }
    double duration() const { return stage_.world->duration_s(); }

    Status writeHeader() {
        summary_.duration_s = duration();
        summary_.samples = samples_;
        const std::pair<const char*, std::string> meta[] = {
            {"level", request_.level == Level::kSignal ? "signal" : "readings"},
            {"sample_count", std::to_string(samples_)},
            {"x_scenario", stage_.scenario.name},
            {"x_seed", std::to_string(stage_.truth.seed)}};
        for (const auto& [key, value] : meta)
            if (Status done = take_.setMeta(key, value); !done)
                return done;
        Calibration calibration = stage_.calibration;
        calibration.created_utc = request_.created_utc;
        if (auto done = take_.addSuit(stage_.suit); !done)
            return done.error();
        if (auto done = take_.addCalibration(calibration); !done)
            return done.error();
        return stage_.body ? writePerformer() : writeStations();
    }

    Status writePerformer() {
        const double rest_s = stage_.body->performance().rest_seconds();
        const std::pair<const char*, std::string> meta[] = {{"actor_name", stage_.actor.name},
                                                            {"reference_kind", "simulated"},
                                                            {"x_rest_seconds", std::to_string(rest_s)}};
        for (const auto& [key, value] : meta)
            if (Status done = take_.setMeta(key, value); !done)
                return done;
        if (stage_.scenario.bone_scale > 0 || stage_.scenario.unreduced_motion)
            if (Status done = take_.setMeta("reference_actor", noctule::toJson(stage_.mover).dump()); !done)
                return done;
        if (auto done = take_.addActor(stage_.actor, request_.created_utc); !done)
            return done.error();
        if (Status done = take_.addMarker({0, "rest", "begin"}); !done)
            return done;
        return take_.addMarker({sampleAt(std::min(rest_s, duration())), "rest", "end"});
    }

    Status writeStations() {
        const bool jig = stage_.rig->kind() == RigKind::kJig;
        if (stage_.rig->kind() == RigKind::kTurntable) {
            char rpm[32];
            std::snprintf(rpm, sizeof rpm, "%g", stage_.scenario.rigs.turntable_rpm);
            if (Status done = take_.setMeta("turntable_rpm", rpm); !done)
                return done;
        }
        for (const RigStation& station : stage_.stations)
            for (const bool begins : {true, false})
                if (Status done =
                        take_.addMarker({sampleAt(begins ? station.begin_s : station.end_s),
                                         jig ? "placement" : "position", begins ? station.label : ""});
                    !done)
                    return done;
        return Done{};
    }

    int64_t sampleAt(double t_s) const {
        return std::min(samples_ - 1, static_cast<int64_t>(t_s * static_cast<double>(rate_hz_)));
    }

    Status writeStatus() {
        AirInstruments instruments(stage_.truth.air, stage_.scenario, stage_.truth.seed);
        for (int64_t sample = 0; sample < samples_; sample += rate_hz_) {
            const AirInstruments::Values air = instruments.read();
            StatusRow row;
            row.sample = sample;
            row.temperature_c = air.temperature_c;
            row.humidity_percent = air.humidity_percent;
            status_.push_back({sample, air.temperature_c, air.humidity_percent});
            if (Status done = take_.addStatus(row); !done)
                return done;
        }
        return Done{};
    }

    Status writeTruth() {
        if (!stage_.body)
            return Done{};
        const int64_t frames = static_cast<int64_t>(duration() * kReferencePerSecond);
        for (int64_t f = 0; f <= frames; ++f) {
            const double t_s = static_cast<double>(f) / kReferencePerSecond;
            if (Status done = take_.addReference({timeNs(t_s), stage_.body->performance().pose(t_s), {}});
                !done)
                return done;
            if (f % 1400 == 0 && job_.cancelled())
                return JobContext::cancelledError();
        }
        return Done{};
    }

    Status writeExternalRoot() {
        const Scenario& s = stage_.scenario;
        if (!request_.external_root || !stage_.body)
            return Done{};
        Random random(stage_.truth.seed, "external root");
        const int64_t frames = static_cast<int64_t>(duration() * s.external_root_rate_hz);
        for (int64_t f = 0; f <= frames; ++f) {
            const double t_s = static_cast<double>(f) / s.external_root_rate_hz;
            const Pose pose = stage_.body->performance().pose(t_s);
            ExternalRootRow row;
            row.time_ns = timeNs(t_s);
            row.p_world_root = pose.p_world_root + random.gaussianVector(s.external_root_sigma_position_m);
            row.q_world_root = pose.q_parent_joint[0] *
                               expQuaternion(random.gaussianVector(s.external_root_sigma_rotation_rad));
            row.sigma_p_m = s.external_root_sigma_position_m;
            row.sigma_q_rad = s.external_root_sigma_rotation_rad;
            if (Status done = take_.addExternalRoot(row); !done)
                return done;
        }
        return Done{};
    }

    Status writeSound() {
        SignalSampler sampler(*stage_.world, stage_.scenario, stage_.truth);
        for (int64_t first = 0; first < samples_; first += kBlockSamples) {
            if (job_.cancelled())
                return JobContext::cancelledError();
            const AdcBlock block{first, sampler.next(std::min(kBlockSamples, samples_ - first))};
            if (Status done = take_.addBlock(block, stage_.world->boardCount(), 1, request_.compress); !done)
                return done;
            report(first, 0, 1);
        }
        return Done{};
    }

    Status writePulses() {
        const PulseSchedule schedule = stage_.scenario.schedule();
        if (schedule.isSilent(stage_.world->sourceCount()))
            return Done{};
        for (int64_t k = 0;; ++k) {
            const Pulse pulse = schedule.pulse(k, stage_.world->sourceCount());
            if (pulse.sample >= samples_)
                return Done{};
            if (auto id = take_.addPulse(pulse.sample, pulse.source); !id)
                return id.error();
            ++summary_.pulses;
        }
    }

    Status writeInertia() {
        std::vector<BoardReadings> boards;
        for (int b = 0; b < stage_.world->boardCount(); ++b)
            boards.emplace_back(*stage_.world, b, stage_.truth.inertia[b], stage_.scenario,
                                stage_.truth.seed);
        const auto framesAt = [&](double rate_hz) {
            return static_cast<int64_t>(static_cast<double>(samples_) * rate_hz /
                                        static_cast<double>(rate_hz_)) -
                   1;
        };
        double fastest_hz = 0;
        for (const Board& board : stage_.suit.boards)
            fastest_hz = std::max(fastest_hz, board.rate_hz);
        const int64_t frames = framesAt(fastest_hz);
        for (int64_t frame = 0; frame < frames; ++frame) {
            for (size_t b = 0; b < boards.size(); ++b) {
                if (frame >= framesAt(stage_.suit.boards[b].rate_hz))
                    continue;
                if (Status done = take_.addInertial(kPrimaryRun, boards[b].next(frame)); !done)
                    return done;
                ++summary_.inertial_rows;
            }
            if (job_.cancelled())
                return JobContext::cancelledError();
            report(frame * samples_ / frames, 0, 0.5);
        }
        return Done{};
    }

    Status writeRanges() {
        const PulseSchedule schedule = stage_.scenario.schedule();
        Result<RangeFinder> finder = RangeFinder::create(
            stage_.suit, stage_.calibration,
            {static_cast<double>(rate_hz_), schedule.interval_samples, schedule.drive_hz, schedule.cycles},
            Detector::kInflection);
        if (!finder)
            return finder.error();
        for (const TemperatureStatus& row : status_)
            finder->soundSpeed().add(row);
        PulseReadings readings(*stage_.world, stage_.scenario, stage_.truth);
        std::vector<PulseDetection> detections;
        for (int64_t k = 0; !schedule.isSilent(stage_.world->sourceCount()); ++k) {
            Pulse pulse = schedule.pulse(k, stage_.world->sourceCount());
            if (pulse.sample + schedule.interval_samples > samples_)
                break;
            const Result<int64_t> id = take_.addPulse(pulse.sample, pulse.source);
            if (!id)
                return id.error();
            pulse.id = *id;
            ++summary_.pulses;
            readings.hear(pulse, detections);
            for (const PulseDetection& detection : detections)
                if (const auto range = finder->process(detection)) {
                    if (Status done =
                            take_.addRange(kPrimaryRun, *range, detectorName(Detector::kInflection));
                        !done)
                        return done;
                    ++summary_.range_rows;
                }
            if (job_.cancelled())
                return JobContext::cancelledError();
            report(pulse.sample, 0.5, 1);
        }
        return Done{};
    }

    void report(int64_t sample, double from, double to) const {
        job_.progress(from + (to - from) * static_cast<double>(sample) / static_cast<double>(samples_),
                      "Sampling");
    }

    const Stage& stage_;
    const TakeRequest& request_;
    const JobContext& job_;
    TakeWriter& take_;
    int64_t rate_hz_, samples_;
    std::vector<TemperatureStatus> status_;
    SimulationSummary summary_;
};

}  // namespace

Result<SimulationSummary> writeTake(const Stage& stage, const TakeRequest& request, const JobContext& job) {
    for (const Board& board : stage.suit.boards)
        if (request.level == Level::kSignal && board.rate_hz != kUsualBoardRate_hz)
            return Error{ErrorKind::kUsage,
                         "board " + board.id + " reads " + std::to_string(board.rate_hz) +
                             " times a second, but sound carries 140 readings a second",
                         "Add --level readings"};
    TakeHeader header;
    header.uuid = uuidOf(stage.truth.seed);
    header.name = request.name;
    header.created_utc = request.created_utc;
    header.software = request.software;
    header.sample_rate_hz = stage.scenario.sample_rate_hz;
    header.board_count = stage.world->boardCount();
    header.source_count = stage.world->sourceCount();
    header.pulse_interval_samples = stage.scenario.schedule().interval_samples;
    header.pulse_cycles = stage.scenario.pulse_cycles;
    header.drive_hz = stage.scenario.drive_hz;
    if (stage.rig)
        header.take_kind = nameOf(stage.rig->kind());
    TakeWriter::Options options;
    options.overwrite = request.overwrite;
    Result<TakeWriter> take = TakeWriter::create(request.out_path, header, options);
    if (!take)
        return take.error();
    TakeMaker maker(stage, request, job, *take);
    if (Status made = maker.make(); !made)
        return made.error();
    if (Status finished = take->finish(); !finished)
        return finished.error();
    job.progress(1, "Done");
    return maker.summary();
}

}  // namespace noctule::simulation
