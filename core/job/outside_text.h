// SPDX-License-Identifier: Apache-2.0
// Text that somebody else wrote, made safe to show: names in takes, what a driver box says, paths.
#pragma once

#include <string>
#include <string_view>

namespace noctule {

enum class Lines { kOne, kMany };

/// Control characters, bytes that are no UTF-8 and marks that turn the direction of writing become visible:
/// "\x1b", "\u202e". Line feeds stay with kMany, else they become "\n".
std::string visibleText(std::string_view text, Lines lines = Lines::kOne);

/// Every byte that is no UTF-8 becomes U+FFFD; all else stays.
std::string validUtf8(std::string_view text);

/// At most `most` bytes, whole characters, with "…" in place of the rest.
std::string shortText(std::string_view text, size_t most);

/// Of finished JSON: what it may hold raw and a terminal would obey becomes "\u009b".
std::string visibleJson(std::string_view json);

}  // namespace noctule
