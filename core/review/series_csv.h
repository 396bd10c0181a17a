// SPDX-License-Identifier: Apache-2.0
// Curves as a table for other programs: one row per instant at which any of them has a value, a column each.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/review/series.h"

namespace noctule {

struct NamedSeries {
    std::string name;  ///< with unit: "Left knee, flexion (deg)"
    std::shared_ptr<const SeriesPyramid> series;
};

/// RFC 4180 with a header row and LF line ends; times in seconds with six decimals, values with the digits
/// of a float; empty where a curve has no value. From and to included.
std::string seriesCsv(const std::vector<NamedSeries>& curves, double from_s, double to_s);

}  // namespace noctule
