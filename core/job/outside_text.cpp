// SPDX-License-Identifier: Apache-2.0
#include "core/job/outside_text.h"

#include <cstdint>
#include <cstdio>

namespace noctule {
namespace {

constexpr std::string_view kEllipsis = "…";

struct Character {
    uint32_t code = 0;
    size_t bytes = 0;  ///< 0: no UTF-8
};

/// The character that begins there, in its shortest form only and no surrogate.
Character characterAt(std::string_view text, size_t at) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[at + i]); };
    const unsigned char first = byte(0);
    if (first < 0x80)
        return {first, 1};
    const size_t bytes = first >= 0xf0 && first < 0xf5   ? 4
                         : first >= 0xe0 && first < 0xf0 ? 3
                         : first >= 0xc2 && first < 0xe0 ? 2
                                                         : 0;
    if (bytes == 0 || at + bytes > text.size())
        return {};
    uint32_t code = first & (0x7fU >> bytes);
    for (size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80)
            return {};
        code = code << 6 | (byte(i) & 0x3fU);
    }
    constexpr uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    return code < kSmallest[bytes] || surrogate || code > 0x10ffff ? Character{} : Character{code, bytes};
}

/// C0, DEL and C1 are obeyed by terminals.
bool isControl(uint32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0);
}

/// Line and paragraph separators, and marks and overrides of the direction (UAX 9).
bool turnsText(uint32_t code) {
    return code == 0x61c || code == 0x200e || code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069);
}

std::string written(const char* format, uint32_t code) {
    char text[16];
    std::snprintf(text, sizeof text, format, static_cast<unsigned>(code));
    return text;
}

std::string controlText(uint32_t code, Lines lines) {
    switch (code) {
        case '\n':
            return lines == Lines::kMany ? "\n" : "\\n";
        case '\r':
            return "\\r";
        case '\t':
            return "\\t";
        default:
            return written(code < 0x100 ? "\\x%02x" : "\\u%04x", code);
    }
}

}  // namespace

std::string visibleText(std::string_view text, Lines lines) {
    std::string shown;
    shown.reserve(text.size());
    for (size_t at = 0; at < text.size();) {
        const Character character = characterAt(text, at);
        if (character.bytes == 0)
            shown += written("\\x%02x", static_cast<unsigned char>(text[at]));
        else if (isControl(character.code) || turnsText(character.code))
            shown += controlText(character.code, lines);
        else
            shown += text.substr(at, character.bytes);
        at += character.bytes == 0 ? 1 : character.bytes;
    }
    return shown;
}

std::string validUtf8(std::string_view text) {
    std::string valid;
    valid.reserve(text.size());
    for (size_t at = 0; at < text.size();) {
        const size_t bytes = characterAt(text, at).bytes;
        valid += bytes == 0 ? std::string_view("\xef\xbf\xbd") : text.substr(at, bytes);
        at += bytes == 0 ? 1 : bytes;
    }
    return valid;
}

std::string shortText(std::string_view text, size_t most) {
    if (text.size() <= most)
        return std::string(text);
    size_t end = most < kEllipsis.size() ? 0 : most - kEllipsis.size();
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
        --end;
    return std::string(text.substr(0, end)) + std::string(kEllipsis);
}

std::string visibleJson(std::string_view json) {
    std::string shown;
    shown.reserve(json.size());
    for (size_t at = 0; at < json.size();) {
        const Character character = characterAt(json, at);
        const bool layout = character.code == '\n';
        if (character.bytes > 0 && !layout && (isControl(character.code) || turnsText(character.code)))
            shown += written("\\u%04x", character.code);
        else
            shown += json.substr(at, character.bytes == 0 ? 1 : character.bytes);
        at += character.bytes == 0 ? 1 : character.bytes;
    }
    return shown;
}

}  // namespace noctule
