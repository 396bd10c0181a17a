// SPDX-License-Identifier: Apache-2.0
// Which of many ranges are worth using. Greedy choices come within a constant factor of the best set and are
// far ahead of Welch's ratio, which looks at each range alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/cooperative/free_points.h"

namespace noctule::cooperative {

enum class SelectionRule {
    kRatio,   ///< Welch 2018, equations 17 to 24: the largest S_ii / R_ii
    kTrace,   ///< greedy: each range lowers the trace of the places' covariance most
    kLogDet,  ///< greedy: each range lowers the determinant most; lazily evaluated
};
std::optional<SelectionRule> selectionRuleFromText(const std::string& text);

/// Indices of `most` rows, in the order chosen. The covariance is that before the update.
/// kRatio: the paper speaks of eigenvalues of S divided by R, which belong to no single measurement; what can
/// be meant is the diagonal, S_ii / R_ii with S = H P H^T.
std::vector<int> selectRows(const FreePoints& points, const std::vector<RangeRow>& rows, size_t most,
                            SelectionRule rule);

/// How many of `count` a share of 0 to 1 is, rounded; at least one if there is any.
size_t shareOf(size_t count, double share);

}  // namespace noctule::cooperative
