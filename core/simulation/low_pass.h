// SPDX-License-Identifier: Apache-2.0
// Zero-phase low-pass of a recorded motion: a Butterworth of second order run forwards and backwards, its
// edge corrected so that the two runs together have their -3 dB point at the cutoff (Winter,
// section 3.4.4.2).
#pragma once

#include <vector>

namespace noctule::simulation {

/// Filters every column of rows that stand 1 / rate_hz apart; the ends are continued by point reflection.
/// A cutoff above 0.45 * rate_hz leaves the rows as they are.
void lowPassZeroPhase(std::vector<std::vector<double>>& rows, double rate_hz, double cutoff_hz);

}  // namespace noctule::simulation
