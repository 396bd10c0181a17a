// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sound_tone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace noctule::simulation {
namespace {

using Complex = std::complex<double>;
constexpr double kInaudible_counts = 0.05;
constexpr double kForever_s = std::numeric_limits<double>::infinity();

/// End of the tone in seconds since its beginning: its own, or where it has faded.
double audibleLength(const DampedTone& tone, double gain) {
    const double level = std::abs(tone.amplitude) * std::abs(gain) / kInaudible_counts;
    if (level <= 1)
        return 0;
    const double length_s = tone.end_s - tone.begin_s;
    return tone.rate_per_s.real() < 0 ? std::min(length_s, std::log(level) / -tone.rate_per_s.real())
                                      : length_s;
}

/// out[i] += Im[value * step^i]. Four interleaved recursions: a single one would wait for each product.
void addExponential(Complex value, Complex step, float* out, int64_t count) {
    constexpr int kLanes = 4;
    std::array<double, kLanes> re{}, im{};
    for (size_t lane = 0; lane < kLanes; ++lane) {
        re[lane] = value.real();
        im[lane] = value.imag();
        value *= step;
    }
    const Complex step_4 = step * step * (step * step);
    const double step_re = step_4.real(), step_im = step_4.imag();
    int64_t i = 0;
    for (; i + kLanes <= count; i += kLanes) {
        for (size_t lane = 0; lane < kLanes; ++lane) {
            out[i + static_cast<int64_t>(lane)] += static_cast<float>(im[lane]);
            const double real = re[lane] * step_re - im[lane] * step_im;
            im[lane] = re[lane] * step_im + im[lane] * step_re;
            re[lane] = real;
        }
    }
    for (size_t lane = 0; i < count; ++i, ++lane)
        out[i] += static_cast<float>(im[lane]);
}

}  // namespace

double toneValue(const ToneSum& tones, double u_s) {
    double sum = 0;
    for (const DampedTone& tone : tones) {
        if (u_s >= tone.begin_s && u_s < tone.end_s)
            sum += (tone.amplitude * std::exp(tone.rate_per_s * (u_s - tone.begin_s))).imag();
    }
    return sum;
}

ToneSum receivedPulse(double drive_hz, int cycles, double resonance_hz, double q) {
    // In the take format's words: E(u) exp(i w u) = a/-L (exp(i w u) - exp((L + i w) u)) during the drive.
    const double damping = std::numbers::pi * resonance_hz / q;
    const double end_s = cycles / drive_hz;
    const Complex drive_rate(0, 2 * std::numbers::pi * drive_hz);
    const Complex ringing_rate(-damping, 2 * std::numbers::pi * resonance_hz);
    const Complex steady = damping / (drive_rate - ringing_rate);
    const Complex at_end = steady * (std::exp(drive_rate * end_s) - std::exp(ringing_rate * end_s));
    ToneSum tones{{0, end_s, steady, drive_rate},
                  {0, end_s, -steady, ringing_rate},
                  {end_s, kForever_s, at_end, ringing_rate}};
    constexpr int kStepsPerCycle = 256;
    double peak = 0;
    for (int i = 0; i < (cycles + 4) * kStepsPerCycle; ++i)
        peak = std::max(peak, std::abs(toneValue(tones, i / (drive_hz * kStepsPerCycle))));
    for (DampedTone& tone : tones)
        tone.amplitude /= peak;
    return tones;
}

void addTones(const ToneSum& tones, const Placement& placement, std::vector<float>& samples) {
    for (const DampedTone& tone : tones) {
        const double length_s = audibleLength(tone, placement.gain);
        if (length_s <= 0)
            continue;
        const double begin = placement.begin_sample + tone.begin_s * placement.samples_per_second;
        const auto first = static_cast<int64_t>(std::max(0.0, std::ceil(begin)));
        const auto last = static_cast<int64_t>(std::ceil(begin + length_s * placement.samples_per_second));
        if (last <= first)
            continue;
        if (static_cast<int64_t>(samples.size()) < last)
            samples.resize(static_cast<size_t>(last), 0.0f);
        const double u_s = (static_cast<double>(first) - begin) / placement.samples_per_second;
        addExponential(placement.gain * tone.amplitude * std::exp(tone.rate_per_s * u_s),
                       std::exp(tone.rate_per_s / placement.samples_per_second), samples.data() + first,
                       last - first);
    }
}

}  // namespace noctule::simulation
