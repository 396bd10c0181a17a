// SPDX-License-Identifier: Apache-2.0
#include "core/job/nearest_word.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace noctule {
namespace {

/// Levenshtein distance.
size_t editsBetween(const std::string& a, const std::string& b) {
    std::vector<size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (size_t i = 1; i <= a.size(); ++i) {
        size_t diagonal = std::exchange(row[0], i);
        for (size_t j = 1; j <= b.size(); ++j)
            diagonal = std::exchange(
                row[j], std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)}));
    }
    return row[b.size()];
}

}  // namespace

std::string nearestWord(const std::string& word, const std::vector<std::string>& known) {
    const auto best = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
        return editsBetween(word, a) < editsBetween(word, b);
    });
    return best == known.end() ? "" : *best;
}

}  // namespace noctule
