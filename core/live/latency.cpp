// SPDX-License-Identifier: Apache-2.0
#include "core/live/latency.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

const double kLatencyBin = std::log(1.01);

}  // namespace

void LatencyHistogram::add(int64_t latency_ns) {
    const double ratio = static_cast<double>(std::max(latency_ns, kLowest_ns)) / kLowest_ns;
    const auto bin = static_cast<size_t>(std::log(ratio) / kLatencyBin);
    ++bins_[std::min(bin, kBins - 1)];
    ++count_;
    worst_ns_ = std::max(worst_ns_, latency_ns);
}

double LatencyHistogram::quantile_s(double share) const {
    const double wanted = share * static_cast<double>(count_);
    int64_t seen = 0;
    for (size_t bin = 0; bin < kBins && count_ > 0; ++bin) {
        seen += bins_[bin];
        if (static_cast<double>(seen) >= wanted)
            return std::min(static_cast<double>(worst_ns_),
                            kLowest_ns * std::exp(kLatencyBin * (static_cast<double>(bin) + 0.5))) *
                   1e-9;
    }
    return 0;
}

}  // namespace noctule
