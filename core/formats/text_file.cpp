// SPDX-License-Identifier: Apache-2.0
#include "core/formats/text_file.h"

#include <cstdint>

#include "core/job/atomic_file.h"

namespace noctule {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

enum class ByteOrder { kLittle, kBig };

/// Without a mark: the first eight bytes are four characters below U+0100, as every header's are.
std::optional<ByteOrder> byteOrderOf(std::string_view bytes) {
    constexpr size_t kLooked = 8;
    if (bytes.starts_with("\xFF\xFE"))
        return ByteOrder::kLittle;
    if (bytes.starts_with("\xFE\xFF"))
        return ByteOrder::kBig;
    if (bytes.size() < kLooked)
        return std::nullopt;
    bool little = true, big = true;
    for (size_t i = 0; i < kLooked; i += 2) {
        little = little && bytes[i] != 0 && bytes[i + 1] == 0;
        big = big && bytes[i] == 0 && bytes[i + 1] != 0;
    }
    if (little || big)
        return little ? ByteOrder::kLittle : ByteOrder::kBig;
    return std::nullopt;
}

void appendUtf8(std::string& text, char32_t code) {
    if (code < 0x80) {
        text += static_cast<char>(code);
        return;
    }
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    constexpr unsigned kLead[] = {0, 0xC0, 0xE0, 0xF0};
    text += static_cast<char>(kLead[more] | code >> (6 * more));
    for (int i = more - 1; i >= 0; --i)
        text += static_cast<char>(0x80 | (code >> (6 * i) & 0x3F));
}

}  // namespace

std::optional<std::string> fromUtf16(std::string_view bytes) {
    const std::optional<ByteOrder> order = byteOrderOf(bytes);
    if (!order)
        return std::nullopt;
    const size_t high = *order == ByteOrder::kBig ? 0 : 1;
    const auto unit = [&](size_t i) {
        return static_cast<char32_t>(static_cast<uint8_t>(bytes[i + high]) << 8 |
                                     static_cast<uint8_t>(bytes[i + 1 - high]));
    };
    std::string text;
    text.reserve(bytes.size() / 2);
    for (size_t i = 0; i + 2 <= bytes.size(); i += 2) {
        char32_t code = unit(i);
        if (i == 0 && code == 0xFEFF)
            continue;
        const bool leads = code >= 0xD800 && code < 0xDC00 && i + 4 <= bytes.size();
        if (const char32_t second = leads ? unit(i + 2) : 0; second >= 0xDC00 && second < 0xE000) {
            code = 0x10000 + ((code - 0xD800) << 10) + (second - 0xDC00);
            i += 2;
        } else if (code >= 0xD800 && code < 0xE000) {
            code = kReplacement;
        }
        appendUtf8(text, code);
    }
    return text;
}

std::string_view withoutByteOrderMark(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

Result<std::string> readTextFile(const std::string& path, const CancelFlag* cancel) {
    Result<std::string> bytes = readWholeFile(path, {kMostTextBytes, kMostStreamBytes, cancel});
    if (!bytes)
        return bytes;
    if (std::optional<std::string> text = fromUtf16(*bytes))
        return std::move(*text);
    const size_t mark = bytes->size() - withoutByteOrderMark(*bytes).size();
    bytes->erase(0, mark);
    return bytes;
}

}  // namespace noctule
