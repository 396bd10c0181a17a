// SPDX-License-Identifier: Apache-2.0
#include "core/math/butterworth.h"

#include <cmath>
#include <complex>
#include <numbers>

#include "core/job/contract.h"

namespace noctule {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr int kMaxOrder = 20;

/// Frequency of the analogue filter that the bilinear transformation s = (1 - 1/z) / (1 + 1/z) puts at f.
double prewarp(double frequency_hz, double sample_rate_hz) {
    return std::tan(pi * frequency_hz / sample_rate_hz);
}

Complex toDigital(Complex s) {
    return (1.0 + s) / (1.0 - s);
}

/// Pole k of the prototype with cut-off 1 rad/s; k < order / 2 are the ones above the real axis, and the
/// middle one of an odd order is -1.
Complex prototypePole(int k, int order) {
    return std::polar(1.0, pi * (0.5 + (2.0 * k + 1) / (2.0 * order)));
}

/// A section with the zeros that `shape` has and the conjugate pair of digital poles z, z*.
Biquad section(Biquad shape, Complex z) {
    shape.a1 = -2 * z.real();
    shape.a2 = std::norm(z);
    return shape;
}

Biquad withUnitGainAt(Biquad b, double omega) {
    const Complex d = std::polar(1.0, -omega);
    const double gain = std::abs((b.b0 + d * (b.b1 + d * b.b2)) / (1.0 + d * (b.a1 + d * b.a2)));
    b.b0 /= gain;
    b.b1 /= gain;
    b.b2 /= gain;
    return b;
}

}  // namespace

std::vector<Biquad> butterworthLowPass(int order, double cutoff_hz, double sample_rate_hz) {
    require(order >= 1 && order <= kMaxOrder, "Butterworth order outside 1..20");
    require(cutoff_hz > 0 && cutoff_hz < sample_rate_hz / 2, "low-pass cut-off outside (0, fs/2)");
    const double cutoff = prewarp(cutoff_hz, sample_rate_hz);
    std::vector<Biquad> sections;
    for (int k = 0; k < order / 2; ++k)
        sections.push_back(
            withUnitGainAt(section({1, 2, 1, 0, 0}, toDigital(cutoff * prototypePole(k, order))), 0));
    if (order % 2)
        sections.push_back(withUnitGainAt({1, 1, 0, -toDigital(-cutoff).real(), 0}, 0));
    return sections;
}

std::vector<Biquad> butterworthBandPass(int order, double low_hz, double high_hz, double sample_rate_hz) {
    require(order >= 1 && order <= kMaxOrder, "Butterworth order outside 1..20");
    require(low_hz > 0 && low_hz < high_hz && high_hz < sample_rate_hz / 2,
            "band-pass edges outside (0, fs/2)");
    const double low = prewarp(low_hz, sample_rate_hz), high = prewarp(high_hz, sample_rate_hz);
    const double centre = std::sqrt(low * high), omega_centre = 2 * std::atan(centre);
    const Biquad shape{1, 0, -1, 0, 0};
    std::vector<Biquad> sections;
    // Each prototype pole p becomes the two roots of s^2 - p (high - low) s + low high = 0.
    for (int k = 0; k < (order + 1) / 2; ++k) {
        const Complex half = prototypePole(k, order) * (high - low) / 2.0;
        const Complex root = std::sqrt(half * half - low * high);
        const bool middle =
            2 * k + 1 == order;  // real pole: its two roots are one conjugate pair, or both real
        if (middle && half.real() * half.real() > low * high) {
            const double z1 = toDigital(half + root).real(), z2 = toDigital(half - root).real();
            sections.push_back(withUnitGainAt({1, 0, -1, -(z1 + z2), z1 * z2}, omega_centre));
            continue;
        }
        sections.push_back(withUnitGainAt(section(shape, toDigital(half + root)), omega_centre));
        if (!middle)
            sections.push_back(withUnitGainAt(section(shape, toDigital(half - root)), omega_centre));
    }
    return sections;
}

}  // namespace noctule
