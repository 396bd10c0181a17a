// SPDX-License-Identifier: Apache-2.0
// What the inflection detector makes of a pulse when echoes overlap it, without any sound: the pulse as it
// leaves the detector's band-pass is a slowly varying complex envelope, echoes are the same envelope later
// and turned in phase, and the steepest rise of their sum's power lies elsewhere than that of the first
// alone. Echoes are therefore an error that stays while the body stands still, not noise.
#pragma once

#include <complex>
#include <vector>

namespace noctule::simulation {

/// One way of sound to a microphone.
struct SoundWay {
    double delay_s = 0;
    double gain = 0;  ///< amplitude
};

class PulseOverlap {
public:
    /// Of the pulse that receivedPulse() describes.
    PulseOverlap(double drive_hz, int cycles, double resonance_hz, double q);

    struct Rise {
        double shift_s = 0;    ///< of the steepest rise, against `first` alone
        double peak_gain = 0;  ///< amplitude of the peak that follows it, behind the band-pass
    };
    /// `first`: the way the detector takes for the pulse, one of `ways`; `loudest`: gain that the detector's
    /// threshold refers to.
    Rise rise(const std::vector<SoundWay>& ways, const SoundWay& first, double loudest) const;

private:
    std::complex<double> envelope(double u_s) const;

    double drive_rad_per_s_;
    std::vector<std::complex<double>> envelope_;  ///< peak 1, in steps of kFineStep_s from -kLead_s on
    double in_band_ = 1;                          ///< its peak as it comes out of the band-pass
    double rise_s_ = 0;                           ///< steepest rise of its power
};

}  // namespace noctule::simulation
