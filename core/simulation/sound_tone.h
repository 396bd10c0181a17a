// SPDX-License-Identifier: Apache-2.0
// Short sounds as sums of damped tones, and their sampling. A received pulse is three of them: the drive, the
// resonator's answer to its beginning, and its ringing after the end (core/recording/README.md, section 5).
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

namespace noctule::simulation {

/// Im[amplitude * exp(rate * (u - begin))] for begin <= u < end, u seconds since the sound began.
struct DampedTone {
    double begin_s = 0, end_s = 0;
    std::complex<double> amplitude;
    std::complex<double> rate_per_s;  ///< real part 0 or negative
};
using ToneSum = std::vector<DampedTone>;

/// Its value at one instant, straight from the definition.
double toneValue(const ToneSum& tones, double u_s);

/// `cycles` periods of sin(2 pi drive_hz u) through a resonator: p(u) of the take format. Peak 1.
ToneSum receivedPulse(double drive_hz, int cycles, double resonance_hz, double q);

/// How a sound lies on the samples of one microphone.
struct Placement {
    double begin_sample = 0;        ///< where u = 0 arrives
    double samples_per_second = 0;  ///< of u: the sample rate, stretched by Doppler
    double gain = 1;                ///< counts per unit
};

/// Adds the sampled sound to `samples`, whose first value is sample 0; grows it as needed, ignores what lies
/// before it, and ends a tone where it has decayed to 0.05 counts.
void addTones(const ToneSum& tones, const Placement& placement, std::vector<float>& samples);

}  // namespace noctule::simulation
