// SPDX-License-Identifier: Apache-2.0
// A source's pulse as the baseband filter leaves it, tabulated so finely that it can be had at any instant.
#pragma once

#include <complex>
#include <vector>

#include "core/acoustics/baseband_filter.h"

namespace noctule {

class PulseTemplate {
public:
    PulseTemplate(const BasebandFilter& filter, const PulseTrain& train, const PulseShape& shape);

    struct Value {
        std::complex<float> value, slope;  ///< slope per sample
    };
    /// `u` samples after the first motion; before the filter feels it and long after the pulse: zero.
    Value at(double u) const;
    double peak() const { return peak_; }  ///< largest amplitude

private:
    static constexpr int kPerSample = 4;  // table entries
    double first_, peak_ = 0;             // of the table, in samples; of the amplitude
    std::vector<Value> table_;
};

}  // namespace noctule
