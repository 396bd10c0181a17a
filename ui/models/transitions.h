// SPDX-License-Identifier: Apache-2.0
// Which phase may follow which: each state machine of the studio has one table, which says all of it at a
// glance and which tests walk through.
#pragma once

#include <QLoggingCategory>
#include <algorithm>
#include <span>

namespace noctule::ui {

template <class Phase>
struct PhaseTransition {
    Phase from, to;
    friend bool operator==(const PhaseTransition&, const PhaseTransition&) = default;
};

Q_DECLARE_LOGGING_CATEGORY(phases)

/// A step that the table does not hold is our fault. It stands in the log and fails a test; the operator goes
/// on.
template <class Phase>
void expectTransition(std::span<const PhaseTransition<Phase>> table, Phase from, Phase to, const char* of) {
    if (std::ranges::find(table, PhaseTransition<Phase>{from, to}) == table.end())
        qCCritical(phases, "%s: phase %d does not lead to phase %d", of, static_cast<int>(from),
                   static_cast<int>(to));
}

}  // namespace noctule::ui
