// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace noctule::test {

/// Of the boards' converters in tests that are not about other rates.
inline constexpr double kRate_hz = 150000;

}  // namespace noctule::test
