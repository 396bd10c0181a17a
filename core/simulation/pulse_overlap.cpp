// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/pulse_overlap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/butterworth.h"
#include "core/simulation/sound_tone.h"

namespace noctule::simulation {
namespace {

using Complex = std::complex<double>;

constexpr double kFineStep_s = 1e-6;
constexpr double kLead_s = 4e-4, kLength_s = 2e-3;  // the zero-phase band-pass rings to both sides
constexpr double kStep_s = 6.7e-6;                  // of the search; the envelope's rise takes 100 us
constexpr double kThresholdOfPower = 0.3;           // the inflection detector's

void filter(const std::vector<Biquad>& sections, std::vector<Complex>& values) {
    for (const Biquad& c : sections) {
        Complex s1 = 0, s2 = 0;
        for (Complex& value : values) {
            const Complex y = c.b0 * value + s1;
            s1 = c.b1 * value - c.a1 * y + s2;
            s2 = c.b2 * value - c.a2 * y;
            value = y;
        }
    }
}

/// The tones with complex values instead of their imaginary part.
Complex analyticValue(const ToneSum& tones, double u_s) {
    Complex sum = 0;
    for (const DampedTone& tone : tones)
        if (u_s >= tone.begin_s && u_s < tone.end_s)
            sum += tone.amplitude * std::exp(tone.rate_per_s * (u_s - tone.begin_s));
    return sum;
}

/// Step by step uphill to the steepest rise from the first power above the threshold, as the detector goes;
/// `power` takes a time. Returns the time of the rise and moves `peak` to the power's next maximum.
template <class Power>
double steepestRise(const Power& power, double begin_s, double end_s, double threshold, double& peak) {
    const auto slope = [&](double t) { return power(t + kStep_s) - power(t - kStep_s); };
    double t = begin_s;
    while (t < end_s && power(t) <= threshold)
        t += kStep_s;
    while (t < end_s && slope(t + kStep_s) > slope(t))
        t += kStep_s;
    while (t > begin_s && slope(t - kStep_s) > slope(t))
        t -= kStep_s;
    const double before = slope(t - kStep_s), top = slope(t), after = slope(t + kStep_s);
    const double curvature = before - 2 * top + after;
    const double vertex = curvature < 0 ? 0.5 * (before - after) / curvature : 0;
    const double rise_s = t + std::clamp(vertex, -0.5, 0.5) * kStep_s;
    while (t < end_s && power(t + kStep_s) > power(t))
        t += kStep_s;
    peak = power(t);
    return rise_s;
}

}  // namespace

PulseOverlap::PulseOverlap(double drive_hz, int cycles, double resonance_hz, double q)
    : drive_rad_per_s_(2 * std::numbers::pi * drive_hz) {
    const ToneSum tones = receivedPulse(drive_hz, cycles, resonance_hz, q);
    const auto count = static_cast<size_t>((kLead_s + kLength_s) / kFineStep_s);
    for (size_t i = 0; i < count; ++i)
        envelope_.push_back(analyticValue(tones, static_cast<double>(i) * kFineStep_s - kLead_s));
    const std::vector<Biquad> band_pass =
        butterworthBandPass(2, drive_hz - 2500, drive_hz + 2500, 1 / kFineStep_s);
    for (int way = 0; way < 2; ++way) {
        filter(band_pass, envelope_);
        std::reverse(envelope_.begin(), envelope_.end());
    }
    double peak = 0;
    for (size_t i = 0; i < count; ++i) {
        envelope_[i] *= std::polar(1.0, -drive_rad_per_s_ * (static_cast<double>(i) * kFineStep_s - kLead_s));
        peak = std::max(peak, std::abs(envelope_[i]));
    }
    in_band_ = peak;
    for (Complex& value : envelope_)
        value /= peak;
    const auto power = [this](double u_s) { return std::norm(envelope(u_s)); };
    rise_s_ = steepestRise(power, -kLead_s / 2, kLength_s / 2, kThresholdOfPower, peak);
}

Complex PulseOverlap::envelope(double u_s) const {
    const double at = (u_s + kLead_s) / kFineStep_s;
    if (!(at >= 0 && at < static_cast<double>(envelope_.size() - 1)))
        return 0;
    const auto i = static_cast<size_t>(at);
    const double fraction = at - static_cast<double>(i);
    return (1 - fraction) * envelope_[i] + fraction * envelope_[i + 1];
}

PulseOverlap::Rise PulseOverlap::rise(const std::vector<SoundWay>& ways, const SoundWay& first,
                                      double loudest) const {
    // Relative to the first way; what arrives after its peak no longer matters to its rise.
    struct Echo {
        double delay_s;
        Complex gain;
    };
    std::vector<Echo> near;
    const double end_s = rise_s_ + 2.5e-4, begin_s = rise_s_ - 2.5e-4;
    for (const SoundWay& way : ways) {
        const double delay_s = way.delay_s - first.delay_s;
        if (delay_s < end_s + kLead_s && delay_s > begin_s - kLength_s)
            near.push_back({delay_s, std::polar(way.gain, -drive_rad_per_s_ * delay_s)});
    }
    if (near.size() < 2)
        return {0, in_band_ * first.gain};
    const auto power = [&](double t_s) {
        Complex sum = 0;
        for (const Echo& echo : near)
            sum += echo.gain * envelope(t_s - echo.delay_s);
        return std::norm(sum);
    };
    double peak = 0;
    const double rise_s = steepestRise(power, begin_s, end_s, kThresholdOfPower * loudest * loudest, peak);
    return {rise_s - rise_s_, in_band_ * std::sqrt(peak)};
}

}  // namespace noctule::simulation
