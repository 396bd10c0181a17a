// SPDX-License-Identifier: Apache-2.0
// Numbers in text files: the decimal point is a point in every locale, reading is exact, and nothing
// allocates.
#pragma once

#include <string>
#include <string_view>

namespace noctule {

/// Reads a number at `begin` (a leading + is fine; too small becomes 0, too large infinite) and returns where
/// it ends; nullptr when there is none. The caller judges what follows and whether the value is finite.
const char* parseNumber(const char* begin, const char* end, double& value);

/// The whole of `text`, a finite number; otherwise false.
bool parseFiniteNumber(std::string_view text, double& value);

/// With that many decimals; never "-0.000".
void appendFixed(std::string& text, double value, int decimals);

/// The shortest decimal that reads back as the same double, never in exponent notation.
void appendExact(std::string& text, double value);

/// For error messages: quoted, at most 40 characters, unprintable ones as '?'.
std::string inQuotes(std::string_view text);

/// Cuts blanks (also tabs and carriage returns) off both ends.
std::string_view trimmed(std::string_view text);

}  // namespace noctule
