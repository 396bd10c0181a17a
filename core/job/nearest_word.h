// SPDX-License-Identifier: Apache-2.0
// The word that was probably meant.
#pragma once

#include <string>
#include <vector>

namespace noctule {

/// The word of `known` that needs the fewest edits (Levenshtein distance). Empty when each needs more than a
/// third of the word's letters, or than one, or leaves nothing of the word.
std::string nearestWord(const std::string& word, const std::vector<std::string>& known);

}  // namespace noctule
