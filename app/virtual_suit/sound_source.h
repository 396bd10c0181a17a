// SPDX-License-Identifier: Apache-2.0
// Where a box's sound comes from: a simulation as it goes, or a take made before. All calls come from one
// thread.
#pragma once

#include <memory>
#include <optional>

#include "app/virtual_suit/instruments.h"
#include "core/job/result.h"
#include "devices/driver_box/hello.h"
#include "devices/driver_box/messages.h"

namespace noctule::virtual_suit {

/// At most kUsualBlockSamples, and the pulses that are sent before its end and were not in the one before.
struct SoundBlock {
    link::AdcBlock adc;
    std::vector<link::Pulse> pulses;

    int64_t end() const { return adc.first_sample + adc.sampleCount(); }
};

class SoundSource {
public:
    virtual ~SoundSource() = default;

    /// Begins at sample 0.
    virtual Status restart() = 0;
    /// In rising order; a hole is a gap. Nothing: all has been played.
    virtual Result<std::optional<SoundBlock>> next() = 0;

    /// Whether slip() and set() do anything.
    virtual bool isSimulated() const = 0;
    /// The board turns on its limb, soon.
    virtual void slip(int /*board*/, double /*angle_rad*/) {}
    /// From the next restart on: interval and cycles of pulses.
    virtual void set(const link::Settings& /*settings*/) {}
};

/// A source and what the box around it says and measures. `hello` lacks what a box alone knows.
struct SoundOfSuit {
    std::unique_ptr<SoundSource> source;
    link::Hello hello;
    MeasurementsAt measurements;
};

}  // namespace noctule::virtual_suit
