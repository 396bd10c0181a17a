// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/pulse_template.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

constexpr double kTemplate_s = 1.5e-3;  // a resonance with Q 35 has fallen to 1/500

}  // namespace

PulseTemplate::PulseTemplate(const BasebandFilter& filter, const PulseTrain& train, const PulseShape& shape)
    : first_(-filter.delay() - 1) {
    const PulseModel pulse(train, shape.resonance_hz, shape.q);
    const std::vector<double>& weights = filter.weights();
    const double rate_hz = train.sample_rate_hz;
    const auto entries = static_cast<size_t>((kTemplate_s * rate_hz - first_) * kPerSample);
    std::vector<std::complex<double>> sound, slope;
    for (size_t i = 0; i < entries + kPerSample * weights.size(); ++i) {
        const double u_s = (first_ - filter.delay() + static_cast<double>(i) / kPerSample) / rate_hz;
        sound.push_back(pulse.envelope(u_s));
        slope.push_back(pulse.envelopeSlope(u_s) / rate_hz);
    }
    table_.resize(entries + 1);
    for (size_t i = 0; i < entries; ++i) {
        std::complex<double> value = 0, change = 0;
        for (size_t k = 0; k < weights.size(); ++k) {
            value += weights[k] * sound[i + kPerSample * k];
            change += weights[k] * slope[i + kPerSample * k];
        }
        table_[i] = {static_cast<float>(value.real()), static_cast<float>(value.imag()),
                     static_cast<float>(change.real()), static_cast<float>(change.imag())};
        peak_ = std::max(peak_, std::abs(value));
    }
}

}  // namespace noctule
