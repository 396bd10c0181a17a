// SPDX-License-Identifier: Apache-2.0
// Fits one or more arrivals of the same pulse, each with its own delay and complex gain, to a stretch of a
// board's baseband: least squares with the gains eliminated (variable projection, Golub and Pereyra 1973, in
// Kaufman's approximation). All arrivals share one stretch of time, the Doppler effect of source and board.
#pragma once

#include <array>
#include <complex>
#include <span>

#include "core/acoustics/pulse_template.h"

namespace noctule {

/// Outputs of the baseband filter, at the instants first, first + step, ... in samples since the emission.
struct Baseband {
    std::span<const std::complex<float>> values;
    double first = 0, step = 1;
    double noise_power = 0;  ///< counts^2, complex: of real and imaginary part together
};

struct PathFit {
    static constexpr int kMaxPaths = 2;
    int paths = 0;
    std::array<double, kMaxPaths> onset{};               ///< samples since emission: the first motion
    std::array<std::complex<double>, kMaxPaths> gain{};  ///< counts; the phase is -drive * onset
    double stretch = 0;                                  ///< approach speed / speed of sound
    double misfit = 0;                                   ///< residual power over the noise's: 1 is perfect
    double sigma_onset = 0, sigma_carrier = 0;           ///< of the first: by envelope; by phase; samples
};

/// What is known of the stretch beforehand.
struct StretchPrior {
    double mean = 0, sigma = 0.01;
};

class PathFitter {
public:
    PathFitter(const PulseTemplate& pulse, double drive_rad_per_sample)
        : pulse_(pulse), drive_(drive_rad_per_sample) {}

    /// The first arrival, about at `near_onset`; with a second path where that explains much. Of 32 values of
    /// sound at most.
    PathFit fit(const Baseband& sound, double near_onset, const StretchPrior& prior) const;
    /// One path only, looked for within 30 samples.
    PathFit fitAlone(const Baseband& sound, double near_onset, const StretchPrior& prior) const;

private:
    PathFit refine(const Baseband& sound, const PathFit& start, const StretchPrior& prior,
                   int iterations) const;

    const PulseTemplate& pulse_;
    double drive_;
};

}  // namespace noctule
