// SPDX-License-Identifier: Apache-2.0
// A source's pulse as the baseband filter leaves it, tabulated so finely that it can be had at any instant.
#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <vector>

#include "core/acoustics/baseband_filter.h"

namespace noctule {

class PulseTemplate {
public:
    PulseTemplate(const BasebandFilter& filter, const PulseTrain& train, const PulseShape& shape);

    /// Calls take(i, re, im, slope_re, slope_im) with the value and its change per sample at the instants
    /// begin + i * step, in samples after the first motion; i in 0..count. Zero before the filter feels the
    /// pulse and long after it.
    template <class Take>
    void sample(double begin, int step, int count, Take&& take) const {
        const double place = (begin - first_) * kPerSample;
        const auto whole = static_cast<int64_t>(std::floor(place));
        const auto part = static_cast<float>(place - static_cast<double>(whole));
        const float h = part / kPerSample;
        for (int i = 0; i < count; ++i) {
            const int64_t at = whole + int64_t(i) * step * kPerSample;
            if (at < 0 || at + 1 >= std::ssize(table_)) {
                take(i, 0.0F, 0.0F, 0.0F, 0.0F);
                continue;
            }
            // The slope is linear in between, the value its integral.
            const Entry &a = table_[static_cast<size_t>(at)], &b = table_[static_cast<size_t>(at + 1)];
            const float bend_re = part * (b.slope_re - a.slope_re),
                        bend_im = part * (b.slope_im - a.slope_im);
            take(i, a.re + h * (a.slope_re + 0.5F * bend_re), a.im + h * (a.slope_im + 0.5F * bend_im),
                 a.slope_re + bend_re, a.slope_im + bend_im);
        }
    }
    double peak() const { return peak_; }  ///< largest amplitude

private:
    static constexpr int kPerSample = 4;  // table entries
    double first_, peak_ = 0;             // of the table, in samples; of the amplitude
    struct Entry {
        float re = 0, im = 0, slope_re = 0, slope_im = 0;  // slope per sample
    };
    std::vector<Entry> table_;
};

}  // namespace noctule
