// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/simulated_source.h"

#include <algorithm>
#include <cstdio>

#include "core/simulation/signal_sampler.h"

namespace noctule::virtual_suit {
namespace {

using namespace simulation;

/// Later than anything that has been asked about: echoes and readings of the present block.
constexpr double kSlipAfter_s = 0.1;

class SimulatedSource : public SoundSource {
public:
    explicit SimulatedSource(Stage stage) : stage_(std::move(stage)) {}

    Status restart() override {
        stage_.world->keepSlips();
        sampler_ = std::make_unique<SignalSampler>(*stage_.world, stage_.scenario, stage_.truth, room_);
        room_ = sampler_->room();
        next_sample_ = next_pulse_ = 0;
        return Done{};
    }

    Result<std::optional<SoundBlock>> next() override {
        const int64_t count =
            std::min<int64_t>(link::kUsualBlockSamples, stage_.sampleCount() - next_sample_);
        if (count <= 0)
            return std::optional<SoundBlock>();
        const auto values = sampler_->next(count);
        SoundBlock block{{next_sample_, stage_.world->boardCount(), {values.begin(), values.end()}}, {}};
        next_sample_ += count;
        addPulses(block);
        return std::optional(std::move(block));
    }

    bool isSimulated() const override { return true; }
    void slip(int board, double angle_rad) override {
        const double now_s = static_cast<double>(next_sample_) / stage_.scenario.sample_rate_hz;
        stage_.world->slip(board, angle_rad, now_s + kSlipAfter_s);
    }
    void set(const link::Settings& settings) override {
        Scenario& scenario = stage_.scenario;
        if (settings.pulse_interval_samples)
            scenario.pulse_interval_s =
                static_cast<double>(*settings.pulse_interval_samples) / scenario.sample_rate_hz;
        scenario.pulse_cycles = settings.pulse_cycles.value_or(scenario.pulse_cycles);
    }

private:
    void addPulses(SoundBlock& block) {
        if (stage_.world->sourceCount() == 0)
            return;
        const PulseSchedule schedule = stage_.scenario.schedule();
        for (;; ++next_pulse_) {
            const Pulse pulse = schedule.pulse(next_pulse_, stage_.world->sourceCount());
            if (pulse.sample >= block.end())
                return;
            block.pulses.push_back({pulse.sample, pulse.source});
        }
    }

    Stage stage_;
    std::optional<Room> room_;  ///< takes seconds to find in a long performance
    std::unique_ptr<SignalSampler> sampler_;
    int64_t next_sample_ = 0, next_pulse_ = 0;
};

/// Six digits, another suit for another seed.
std::string serialOf(uint64_t seed) {
    char text[24];
    std::snprintf(text, sizeof text, "NB-9%05d", static_cast<int>(seed % 100'000));
    return text;
}

}  // namespace

SoundOfSuit makeSimulatedSource(Stage stage) {
    const Scenario& scenario = stage.scenario;
    const PulseSchedule schedule = scenario.schedule();
    link::Hello hello;
    hello.serial = serialOf(stage.truth.seed);
    hello.sample_rate_hz = scenario.sample_rate_hz;
    hello.pulse_interval_samples = schedule.interval_samples;
    hello.pulse_cycles = schedule.cycles;
    hello.drive_hz = schedule.drive_hz;
    hello.suit = stage.suit;
    auto air = std::make_shared<AirInstruments>(stage.truth.air, scenario, stage.truth.seed);
    const auto measurements = [air](int64_t) {
        const AirInstruments::Values values = air->read();
        return Measurements{values.temperature_c, values.humidity_percent, {}, {}};
    };
    return {std::make_unique<SimulatedSource>(std::move(stage)), std::move(hello), measurements};
}

}  // namespace noctule::virtual_suit
