// SPDX-License-Identifier: Apache-2.0
#include "core/cooperative/offset_line.h"

#include <algorithm>
#include <cmath>

#include "core/job/contract.h"

namespace noctule::cooperative {
namespace {

constexpr double kMostRate = 60e-6;  ///< two crystals, 20 parts per million off each, and half as much again
constexpr size_t kMostEnds = 100;    ///< of candidate lines, spread over all offsets

}  // namespace

std::optional<OffsetLine> lineThrough(const std::vector<ClockOffset>& offsets) {
    double n = 0, t = 0, o = 0, tt = 0, to = 0;
    for (const ClockOffset& one : offsets)
        n += 1, t += one.time_s, o += one.offset_s, tt += one.time_s * one.time_s,
            to += one.time_s * one.offset_s;
    const double spread = n * tt - t * t;
    if (!(spread > 0))
        return std::nullopt;
    const double slope = (n * to - t * o) / spread;
    return OffsetLine{(o - slope * t) / n, slope};
}

OffsetLine lineThroughMost(std::vector<ClockOffset> offsets, double outlier_s) {
    require(!offsets.empty(), "lineThroughMost: no offset");
    const auto fits = [outlier_s](const OffsetLine& line, const ClockOffset& one) {
        return std::abs(one.offset_s - line.at(one.time_s)) < outlier_s;
    };
    OffsetLine best{offsets.front().offset_s, 0};
    const size_t step = 1 + (offsets.size() - 1) / kMostEnds;
    std::ptrdiff_t most = 0;
    for (size_t i = 0; i < offsets.size(); i += step)
        for (size_t k = i + step; k < offsets.size(); k += step) {
            const double slope =
                (offsets[k].offset_s - offsets[i].offset_s) / (offsets[k].time_s - offsets[i].time_s);
            if (!(std::abs(slope) <= kMostRate))
                continue;
            const OffsetLine candidate{offsets[i].offset_s - slope * offsets[i].time_s, slope};
            const auto count =
                std::ranges::count_if(offsets, [&](const ClockOffset& one) { return fits(candidate, one); });
            if (count > most)
                most = count, best = candidate;
        }
    std::erase_if(offsets, [&](const ClockOffset& one) { return !fits(best, one); });
    const auto line = lineThrough(offsets);
    return line && std::abs(line->slope) <= kMostRate ? *line : best;
}

}  // namespace noctule::cooperative
