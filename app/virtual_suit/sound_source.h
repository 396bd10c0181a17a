// SPDX-License-Identifier: Apache-2.0
// Where a box's sound comes from: a simulation as it goes, or a take made before. All calls come from one
// thread.
#pragma once

#include <memory>
#include <optional>

#include "app/virtual_suit/control_command.h"
#include "app/virtual_suit/instruments.h"
#include "core/job/result.h"
#include "devices/driver_box/hello.h"
#include "devices/driver_box/messages.h"

namespace noctule::virtual_suit {

/// At most kUsualBlockSamples, and the pulses that are sent before its end and were not in the one before.
struct SoundBlock {
    link::SoundBlock adc;
    std::vector<link::EmittedPulse> pulses;

    int64_t end() const { return adc.first_sample + adc.sampleCount(); }
};

class SoundSource {
public:
    virtual ~SoundSource() = default;

    /// Begins at sample 0, which is taken at that instant (nowNs()).
    virtual Status restart(int64_t begin_ns) = 0;
    /// What it hears depends on that instant, for others hear it too: should its clock stand still, it no
    /// longer agrees with theirs.
    virtual bool isTimed() const { return false; }
    /// In rising order; a hole is a gap. Nothing: all has been played.
    virtual Result<std::optional<SoundBlock>> next() = 0;

    /// Whether set() and obey() do anything.
    virtual bool isSimulated() const = 0;
    /// Whether there is anything to obey this command: a strap to slip, a plate to turn. From any thread.
    virtual Status accepts(const ControlCommand& command) const = 0;
    /// What it accepts happens soon, and is still so after a restart.
    virtual void obey(const ControlCommand& /*command*/) {}
    /// From the next restart on: interval, cycles and sources of pulses.
    virtual void set(const link::Settings& /*settings*/) {}
};

/// A source and what the box around it says and measures. `hello` lacks what a box alone knows.
struct SoundOfSuit {
    std::unique_ptr<SoundSource> source;
    link::Hello hello;
    MeasurementsAt measurements;
};

}  // namespace noctule::virtual_suit
