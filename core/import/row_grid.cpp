// SPDX-License-Identifier: Apache-2.0
#include "core/import/row_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace noctule {

namespace {

constexpr size_t kMostLostPerRow = 5;      ///< empty rows for each given one
constexpr size_t kAlwaysAllowed = 10'000;  ///< empty rows of even the shortest recording
constexpr double kLongerThanUsual = 1.5;

Error gridError(const std::string& where, const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUnreadable, where + ": " + what, remedy};
}

/// `place` gives each given row its grid row, rising; kNoRow: left out.
Result<RowGrid> filled(RowGrid grid, const std::vector<size_t>& place, const std::string& where) {
    size_t given = 0, last = 0;
    for (const size_t row : place)
        if (row != RowGrid::kNoRow) {
            ++given;
            last = std::max(last, row);
        }
    if (given < 2)
        return gridError(where, "holds fewer than two rows with an instant", "Export the recording again");
    grid.rows = last + 1;
    if (grid.rows - given > kMostLostPerRow * given + kAlwaysAllowed)
        return gridError(where,
                         "its clock jumps: " + std::to_string(given) + " rows would be spread over " +
                             std::to_string(grid.rows),
                         "Cut the recording at the jump and import the parts");
    grid.from.assign(grid.rows, RowGrid::kNoRow);
    for (size_t i = 0; i < place.size(); ++i)
        if (place[i] != RowGrid::kNoRow)
            grid.from[place[i]] = i;
    size_t run = 0, longest = 0;
    for (const size_t from : grid.from) {
        run = from == RowGrid::kNoRow ? run + 1 : 0;
        grid.lost += run > 0;
        grid.gaps += run == 1;
        longest = std::max(longest, run);
    }
    grid.longest_gap_s = double(longest) / grid.rate_hz;
    return grid;
}

}  // namespace

std::vector<std::string> RowGrid::findings(const std::string& who) const {
    std::vector<std::string> sentences;
    char text[160];
    if (lost > 0) {
        std::snprintf(text, sizeof text, ": %zu of %zu rows are lost in %zu gaps, the longest of %.2f s",
                      lost, rows, gaps, longest_gap_s);
        sentences.push_back(who + text);
    }
    if (backwards > 0)
        sentences.push_back(who + ": the clock stands still or jumps back at " + std::to_string(backwards) +
                            " rows, which were left out");
    return sentences;
}

Result<RowGrid> gridOfTimes(const std::vector<double>& time_s, const std::string& where) {
    RowGrid grid;
    std::vector<double> steps;
    std::vector<size_t> kept;
    for (size_t i = 0; i < time_s.size(); ++i) {
        if (!std::isfinite(time_s[i]))
            continue;
        if (!kept.empty() && !(time_s[i] > time_s[kept.back()])) {
            ++grid.backwards;
            continue;
        }
        if (!kept.empty())
            steps.push_back(time_s[i] - time_s[kept.back()]);
        kept.push_back(i);
    }
    if (steps.empty())
        return gridError(where, "holds fewer than two rows with rising instants",
                         "Export the recording again");
    std::vector<double> sorted = steps;
    std::nth_element(sorted.begin(), sorted.begin() + long(sorted.size() / 2), sorted.end());
    const double usual = sorted[sorted.size() / 2];
    double sum = 0;
    size_t count = 0;
    for (const double step : steps)
        if (step < kLongerThanUsual * usual) {
            sum += step;
            ++count;
        }
    const double period = sum / double(count);
    grid.rate_hz = 1 / period;
    if (!(grid.rate_hz >= 1 && grid.rate_hz <= 10'000))
        return gridError(where, "the usual step of its clock is " + std::to_string(period) + " s",
                         "A recording has 1 to 10000 rows a second; check the unit of the time");
    grid.start_s = time_s[kept.front()];
    std::vector<size_t> place(time_s.size(), RowGrid::kNoRow);
    double next = 0;
    for (const size_t i : kept) {
        const double at = std::max(next, std::round((time_s[i] - grid.start_s) / period));
        if (at > 1e9)
            return gridError(where, "its clock jumps by days", "Cut the recording at the jump");
        place[i] = static_cast<size_t>(at);
        next = at + 1;
    }
    return filled(std::move(grid), place, where);
}

Result<RowGrid> gridOfCounts(const std::vector<int64_t>& counts, double rate_hz, const std::string& where) {
    RowGrid grid;
    grid.rate_hz = rate_hz;
    std::vector<size_t> place(counts.size(), RowGrid::kNoRow);
    int64_t next = 0;
    for (size_t i = 0; i < counts.size(); ++i) {
        const int64_t at = counts[i] - counts.front();
        if (at < next || at > 1'000'000'000) {
            ++grid.backwards;
            continue;
        }
        place[i] = static_cast<size_t>(at);
        next = at + 1;
    }
    return filled(std::move(grid), place, where);
}

}  // namespace noctule
