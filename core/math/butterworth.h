// SPDX-License-Identifier: Apache-2.0
// Digital Butterworth filters as second-order sections: analogue prototype, frequency transformation with
// prewarped edges, bilinear transformation (Oppenheim & Schafer, Discrete-Time Signal Processing,
// section 7.1). The response equals scipy.signal.butter(order, edges, fs=...); the sections differ in that
// each has unit gain in the pass band (at 0 Hz or at the band's centre), which keeps intermediate values in
// range in single precision.
#pragma once

#include <vector>

namespace noctule {

/// y[n] = b0 x[n] + b1 x[n-1] + b2 x[n-2] - a1 y[n-1] - a2 y[n-2]
struct Biquad {
    double b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0;
};

/// -3 dB at cutoff_hz, which lies in (0, fs/2); order 1..20. An odd order ends in a first-order section.
std::vector<Biquad> butterworthLowPass(int order, double cutoff_hz, double sample_rate_hz);

/// -3 dB at both edges, 0 < low < high < fs/2. `order` is that of the low-pass prototype, as in scipy: the
/// filter has 2 * order poles.
std::vector<Biquad> butterworthBandPass(int order, double low_hz, double high_hz, double sample_rate_hz);

}  // namespace noctule
