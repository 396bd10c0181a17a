// SPDX-License-Identifier: Apache-2.0
// What is wrong with a take, as sentences: each once, in the order in which they were found.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/job/result.h"

namespace noctule {

class Problems {
public:
    /// The value, or nothing and a problem noted.
    template <class T>
    std::optional<T> keep(Result<T> result) {
        if (result)
            return std::move(*result);
        if (result.error().is_damage && !damage_)
            damage_ = result.error();
        add(result.error().text() + ".");
        return std::nullopt;
    }
    void add(const std::string& sentence) {
        if (std::ranges::find(sentences_, sentence) == sentences_.end())
            sentences_.push_back(sentence);
    }
    /// The first of them that is Error::is_damage.
    const std::optional<Error>& damage() const { return damage_; }
    std::vector<std::string> sentences() && { return std::move(sentences_); }

private:
    std::vector<std::string> sentences_;
    std::optional<Error> damage_;
};

}  // namespace noctule
