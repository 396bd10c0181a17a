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
    std::string best;
    size_t fewest = std::min(std::max<size_t>(1, word.size() / 3) + 1, word.size());
    for (const std::string& one : known)
        if (const size_t edits = editsBetween(word, one); edits < fewest) {
            fewest = edits;
            best = one;
        }
    return best;
}

}  // namespace noctule
