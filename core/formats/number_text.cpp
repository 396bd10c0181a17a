// SPDX-License-Identifier: Apache-2.0
#include "core/formats/number_text.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace noctule {
namespace {

bool hasNegativeExponent(std::string_view number) {
    const size_t e = number.find_first_of("eE");
    return e != std::string_view::npos && e + 1 < number.size() && number[e + 1] == '-';
}

}  // namespace

const char* parseNumber(const char* begin, const char* end, double& value) {
    if (begin != end && *begin == '+' && (++begin == end || *begin == '-'))
        return nullptr;
    const auto [after, problem] = std::from_chars(begin, end, value);
    if (problem == std::errc::invalid_argument)
        return nullptr;
    if (problem == std::errc::result_out_of_range) {
        const bool tiny = hasNegativeExponent({begin, static_cast<size_t>(after - begin)});
        value = tiny ? 0 : std::numeric_limits<double>::infinity();
    }
    return after;
}

bool parseFiniteNumber(std::string_view text, double& value) {
    const char* end = text.data() + text.size();
    return parseNumber(text.data(), end, value) == end && std::isfinite(value);
}

void appendFixed(std::string& text, double value, int decimals) {
    char digits[400];  // the largest double has 309 digits before the point
    const auto [end, problem] =
        std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals);
    const std::string_view number(digits, static_cast<size_t>(end - digits));
    const bool negative_zero = number[0] == '-' && number.find_first_not_of("-0.") == std::string_view::npos;
    text += negative_zero ? number.substr(1) : number;
}

void appendExact(std::string& text, double value) {
    char digits[400];
    const auto [end, problem] =
        std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed);
    text.append(digits, end);
}

std::string inQuotes(std::string_view text) {
    constexpr size_t kLongest = 40;
    std::string result = "\"";
    for (const char c : text.substr(0, kLongest))
        result += c >= ' ' && c != 127 ? c : '?';
    return result + (text.size() > kLongest ? "...\"" : "\"");
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n\f\v";
    const size_t begin = text.find_first_not_of(kBlanks);
    return begin == std::string_view::npos ? std::string_view()
                                           : text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

}  // namespace noctule
