// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/take_maker.h"

#include <cstdio>

#include "core/simulation/cast_sampler.h"

namespace noctule::simulation {
namespace {

constexpr int64_t kBlockSamples = 6000;  // 40 ms at 150 kHz

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

class TakeMaker {
public:
    TakeMaker(const TakeContent& content, const TakeRequest& request, const JobContext& job, TakeWriter& take)
        : content_(content), request_(request), job_(job), take_(take) {
        for (const StagedSuit& suit : content.suits)
            rows_.emplace_back(suit, request, job, take);
        status_.resize(rows_.size());
    }

    Status make() {
        using Step = Status (TakeMaker::*)();
        const bool sound = request_.level == Level::kSignal;
        for (const Step step : {&TakeMaker::writeHeader, &TakeMaker::writeStatus, &TakeMaker::writeTruth,
                                sound ? &TakeMaker::writeSound : &TakeMaker::writeInertia,
                                sound ? &TakeMaker::writePulses : &TakeMaker::writeRanges})
            if (Status done = (this->*step)(); !done)
                return done;
        return Done{};
    }

    const SimulationSummary& summary() const { return summary_; }

private:
    const Stage& first() const { return *content_.suits.front().stage; }

    Status writeHeader() {
        summary_.duration_s = first().world->duration_s();
        summary_.samples = first().sampleCount();
        std::vector<std::pair<std::string, std::string>> meta = {
            {"level", request_.level == Level::kSignal ? "signal" : "readings"},
            {"sample_count", std::to_string(summary_.samples)},
            {"x_scenario", first().scenario.name},
            {"x_seed", std::to_string(first().truth.seed)}};
        meta.insert(meta.end(), content_.meta.begin(), content_.meta.end());
        for (const auto& [key, value] : meta)
            if (Status done = take_.setMeta(key, value); !done)
                return done;
        for (SuitRows& suit : rows_)
            if (Status done = suit.writeDocuments(); !done)
                return done;
        return Done{};
    }

    Status writeStatus() {
        for (size_t suit = 0; suit < rows_.size(); ++suit)
            if (Status done = rows_[suit].writeStatus(status_[suit]); !done)
                return done;
        return Done{};
    }

    Status writeTruth() {
        for (SuitRows& suit : rows_) {
            if (Status done = suit.writeTruth(); !done)
                return done;
            if (Status done = suit.writeExternalRoot(); !done)
                return done;
        }
        return Done{};
    }

    Status writeSound() {
        for (size_t suit = 0; suit < content_.suits.size(); ++suit)
            if (Status done = writeSoundOf(suit); !done)
                return done;
        return Done{};
    }

    Status writeSoundOf(size_t suit) {
        const StagedSuit& staged = content_.suits[suit];
        if (staged.stage->suit.boards.empty())
            return Done{};
        if (content_.chamber) {
            CastSampler sampler(content_.suits, suit, *content_.chamber);
            return writeBlocks(sampler, suit);
        }
        SignalSampler sampler(*staged.stage->world, staged.stage->scenario, staged.stage->truth);
        return writeBlocks(sampler, suit);
    }

    template <class Sampler>
    Status writeBlocks(Sampler& sampler, size_t suit) {
        const StagedSuit& staged = content_.suits[suit];
        const int64_t samples = staged.sampleCount();
        for (int64_t sample = 0; sample < samples; sample += kBlockSamples) {
            if (job_.cancelled())
                return JobContext::cancelledError();
            const AdcBlock block{sample, sampler.next(std::min(kBlockSamples, samples - sample))};
            if (Status done =
                    take_.addBlock(block, staged.stage->world->boardCount(), staged.id, request_.compress);
                !done)
                return done;
            const double part = static_cast<double>(sample) / static_cast<double>(samples);
            job_.progress((static_cast<double>(suit) + part) / static_cast<double>(content_.suits.size()),
                          "Sampling");
        }
        return Done{};
    }

    /// Of all suits, in the order of time.
    Status writePulses() {
        std::vector<int64_t> next(content_.suits.size(), 0);
        while (true) {
            std::optional<size_t> first;
            double first_s = 0;
            for (size_t s = 0; s < next.size(); ++s) {
                const StagedSuit& suit = content_.suits[s];
                const PulseSchedule schedule = suit.stage->scenario.schedule();
                const int64_t sample = next[s] * schedule.interval_samples;
                if (schedule.isSilent(suit.stage->world->sourceCount()) || sample >= suit.sampleCount())
                    continue;
                const double drive_s = suit.takeTimeOf_s(static_cast<double>(sample));
                if (!first || drive_s < first_s) {
                    first = s;
                    first_s = drive_s;
                }
            }
            if (!first)
                return Done{};
            const StagedSuit& suit = content_.suits[*first];
            const Pulse pulse =
                suit.stage->scenario.schedule().pulse(next[*first]++, suit.stage->world->sourceCount());
            if (auto id = take_.addPulse(pulse.sample, pulse.source, suit.id); !id)
                return id.error();
            ++summary_.pulses;
        }
    }

    Status writeInertia() {
        const double each = 0.5 / static_cast<double>(rows_.size());
        for (size_t suit = 0; suit < rows_.size(); ++suit) {
            const double from = each * static_cast<double>(suit);
            if (Status done = rows_[suit].writeInertia({from, from + each}, summary_.inertial_rows); !done)
                return done;
        }
        return Done{};
    }

    Status writeRanges() {
        auto ranges = RangeRows::create(content_.suits, status_, content_.chamber);
        if (!ranges)
            return ranges.error();
        while (true) {
            const Result<bool> more = ranges->writeNext(take_, summary_);
            if (!more)
                return more.error();
            if (!*more)
                return Done{};
            if (job_.cancelled())
                return JobContext::cancelledError();
            job_.progress(0.5 + 0.5 * std::clamp(ranges->reached_s() / summary_.duration_s, 0.0, 1.0),
                          "Sampling");
        }
    }

    const TakeContent& content_;
    const TakeRequest& request_;
    const JobContext& job_;
    TakeWriter& take_;
    std::vector<SuitRows> rows_;                          ///< per suit
    std::vector<std::vector<TemperatureStatus>> status_;  ///< per suit
    SimulationSummary summary_;
};

/// What sound cannot carry.
Status checkBoards(const TakeContent& content, const TakeRequest& request) {
    if (request.level == Level::kReadings)
        return Done{};
    for (const StagedSuit& suit : content.suits)
        for (const Board& board : suit.stage->suit.boards)
            if (board.rate_hz != kUsualBoardRate_hz)
                return Error{ErrorKind::kUsage,
                             "board " + board.id + " reads " + std::to_string(board.rate_hz) +
                                 " times a second, but sound carries 140 readings a second",
                             "Add --level readings"};
    return Done{};
}

TakeHeader headerOf(const Stage& stage, const TakeRequest& request) {
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
    if (stage.rig && stage.rig->kind() != RigKind::kBag)  // that is a motion like any other
        header.take_kind = nameOf(stage.rig->kind());
    return header;
}

}  // namespace

Result<SimulationSummary> makeTake(const TakeContent& content, const TakeRequest& request,
                                   const JobContext& job) {
    if (Status fit = checkBoards(content, request); !fit)
        return fit.error();
    TakeWriter::Options options;
    options.overwrite = request.overwrite;
    Result<TakeWriter> take =
        TakeWriter::create(request.out_path, headerOf(*content.suits.front().stage, request), options);
    if (!take)
        return take.error();
    TakeMaker maker(content, request, job, *take);
    if (Status made = maker.make(); !made)
        return made.error();
    if (Status finished = take->finish(); !finished)
        return finished.error();
    job.progress(1, "Done");
    return maker.summary();
}

Result<SimulationSummary> writeTake(const Stage& stage, const TakeRequest& request, const JobContext& job) {
    const BoxClock take_time;
    TakeContent content;
    content.suits.push_back({.stage = &stage, .clock = &take_time});
    return makeTake(content, request, job);
}

}  // namespace noctule::simulation
