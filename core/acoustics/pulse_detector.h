// SPDX-License-Identifier: Apache-2.0
// Finds the arrival of a pulse in the sound of one pulse interval. Which detector is used is a choice of the
// user; each has its own offset, the time it reports for a source at distance 0.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/acoustics/pulse_model.h"
#include "core/acoustics/range.h"
#include "core/job/result.h"

namespace noctule {

enum class Detector {
    kInflection,  ///< steepest rise of the power envelope, zero-phase filters: the paper's (section 4.1)
    kMatched,     ///< the source's known pulse fitted to the sound: its first motion, and the carrier's phase
};

/// As in calibrations, takes and on the command line: "inflection", "matched".
const char* detectorName(Detector detector);
std::optional<Detector> detectorFromName(const std::string& name);

/// An arrival by the phase of its carrier, far finer than by its envelope but only up to whole cycles.
struct CarrierArrival {
    double sample = 0;         ///< like PulseArrival::sample: of the cycles the one nearest to the envelope's
    double sigma_samples = 0;  ///< once the cycle is right
    double cycle_samples = 0;
    double envelope_sigma_samples = 0;  ///< of PulseArrival::sample
};

/// What one board heard in one window.
struct PulseArrival {
    double sample = 0;      ///< fractional, from the pulse's emission: still includes the source's offset
    double peak_power = 0;  ///< counts^2: half the squared amplitude, at the peak of the rise that was found
    double noise_power =
        0;                 ///< counts^2: of the window's quietest quarter, taken as zero-mean Gaussian noise
    bool clipped = false;  ///< the window holds full-scale samples
    std::optional<CarrierArrival> carrier{};  ///< of detectors that see it
};

/// kUnusable when the detector cannot be made for such pulses.
Status checkTrain(const PulseTrain& train, Detector detector);

class PulseDetector {
public:
    virtual ~PulseDetector() = default;

    /// Samples needed before the pulse's emission; as many are needed after the interval.
    virtual int marginSamples() const = 0;
    /// Samples of a whole window: margin, interval, margin.
    virtual int windowSamples() const = 0;

    /// `window` is sample-interleaved, windowSamples() * boards.size() values; one arrival per board comes
    /// out. `pulse`: whose window it is; windows come in the order of their pulses.
    virtual void detect(std::span<const int16_t> window, std::span<PulseArrival> boards,
                        const Pulse& pulse = {}) = 0;
};

/// Fails (kUnusable) when the pulses of `train` cannot be received at its sample rate and interval. A matched
/// detector hears nothing of sources whose shape is not known.
Result<std::unique_ptr<PulseDetector>> makeDetector(Detector detector, const PulseTrain& train,
                                                    const PulseShapes& shapes = {});

/// What a detector makes of a known pulse at distance 0, over all positions between two samples.
struct DetectorResponse {
    double delay_s = 0;    ///< mean of what it reports, from the pulse's first motion
    double scatter_s = 0;  ///< standard deviation: sampling alone, without any noise
};

DetectorResponse detectorResponse(PulseDetector& detector, const PulseTrain& train, double resonance_hz,
                                  double q);

}  // namespace noctule
