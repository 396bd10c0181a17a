// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <set>

#include "ui/models/transitions.h"

namespace noctule::ui::test {

/// From `first` every phase can be reached, and each leads back to it; no step stands twice or leads nowhere.
template <class Phase>
void expectWhole(std::span<const PhaseTransition<Phase>> table, Phase first, int count) {
    const auto reached = [&](bool forwards) {
        std::set<Phase> found{first};
        for (size_t before = 0; before != found.size();) {
            before = found.size();
            for (const PhaseTransition<Phase>& step : table)
                if (found.contains(forwards ? step.from : step.to))
                    found.insert(forwards ? step.to : step.from);
        }
        return static_cast<int>(found.size());
    };
    EXPECT_EQ(reached(true), count);
    EXPECT_EQ(reached(false), count);
    for (const PhaseTransition<Phase>& step : table) {
        EXPECT_NE(step.from, step.to);
        EXPECT_EQ(std::ranges::count(table, step), 1)
            << static_cast<int>(step.from) << " to " << static_cast<int>(step.to);
    }
}

/// What leads to a phase.
template <class Phase>
std::set<Phase> before(std::span<const PhaseTransition<Phase>> table, Phase phase) {
    std::set<Phase> found;
    for (const PhaseTransition<Phase>& step : table)
        if (step.to == phase)
            found.insert(step.from);
    return found;
}

}  // namespace noctule::ui::test
