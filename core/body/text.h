// SPDX-License-Identifier: Apache-2.0
// Numbers and names as people read them in reports and findings: independent of the locale, U+2212 for minus,
// a narrow no-break space in large counts, joints and boards by their everyday names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace noctule::text {

/// For HTML and SVG, in text and in double-quoted attributes. Control characters become spaces.
std::string escaped(const std::string& plain);

/// Fixed point; "unknown" as an en dash when the value is not finite.
std::string number(double value, int decimals);
std::string number(const std::optional<double>& value, int decimals);
/// With ASCII minus and without superfluous zeros: for coordinates.
std::string coordinate(double value);
std::string count(int64_t value);   ///< "12 345" with narrow no-break spaces
std::string percent(double share);  ///< "98 %" of 0..1; "99.9 %" near the ends, never rounded to 100 or 0
std::string clock(double seconds);  ///< "0:17" or "1:05:00"
std::string degrees(double value_deg, int decimals = 1);
std::string plural(int64_t value, const std::string& one, const std::string& many);  ///< "3 boards"

std::string capitalised(std::string words);  ///< first letter, when it is an ASCII one
std::string utc(
    const std::string& iso8601);  ///< "2026-11-21 09:58 UTC" of "2026-11-21T09:58:00Z"; else as it is

/// "LeftForeArm" -> "Left elbow"; names that are not canonical stay as they are, long ones are cut.
std::string jointLabel(const std::string& name);
/// "LeftForeArm" -> "left forearm".
std::string segmentLabel(const std::string& name);

}  // namespace noctule::text
