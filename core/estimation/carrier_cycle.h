// SPDX-License-Identifier: Apache-2.0
// Which cycle of the carrier a distance lies in: the one that the pulse's envelope and the body's predicted
// pose agree on. Neither alone suffices: echoes pull the envelope by half a cycle (4.3 mm) and more, and a
// pose may be centimetres off.
#pragma once

#include <optional>

#include "core/acoustics/range.h"

namespace noctule {

/// The carrier's distance in metres; none while another cycle is nearly as likely. `variance_m2` is that of
/// the expectation, everything included that stands between pose and sound.
std::optional<double> carrierDistance(const CarrierRange& carrier, double expected_m, double variance_m2);

}  // namespace noctule
