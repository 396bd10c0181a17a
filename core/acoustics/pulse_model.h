// SPDX-License-Identifier: Apache-2.0
// The pulse as a wide-band microphone receives it: a burst of sine driven into a resonator
// (core/recording/README.md, section 5).
#pragma once

#include <complex>
#include <optional>
#include <vector>

namespace noctule {

/// How the box drives its sources: what the take's meta keys of the same names say.
struct PulseTrain {
    double sample_rate_hz = 150000;
    int interval_samples = 1200;  ///< from one source's pulse to the next source's
    double drive_hz = 40000;
    int cycles = 10;
};

/// The resonator a source's pulse rings in.
struct PulseShape {
    double resonance_hz = 0, q = 0;
};
using PulseShapes = std::vector<std::optional<PulseShape>>;  ///< per source; none: not known

class PulseModel {
public:
    /// A source with resonance f and quality q, both positive.
    PulseModel(const PulseTrain& train, double resonance_hz, double q);

    /// Received pulse at distance 0, u seconds after its first motion; 0 before. The drive has amplitude 1.
    double at(double u_s) const;
    /// The same as a slowly varying complex amplitude of the drive: at(u) = Im[envelope(u) exp(i drive u)].
    std::complex<double> envelope(double u_s) const;
    /// Its rate of change, 1/s.
    std::complex<double> envelopeSlope(double u_s) const;

private:
    double drive_rad_per_s_, drive_end_s_, damping_per_s_;
    std::complex<double> L_;  // 1/s, decay and beat against the drive
    std::complex<double> E_end_;
};

}  // namespace noctule
