// SPDX-License-Identifier: Apache-2.0
#include "core/body/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "core/job/limits.h"
#include "core/job/outside_text.h"

namespace noctule::text {
namespace {

constexpr const char* kUnknown = "–";
constexpr const char* kMinus = "−";
constexpr const char* kNarrowSpace = "\u202F";

/// std::to_chars knows no locale, unlike printf.
std::string fixedPoint(double value, int decimals) {
    std::array<char, 400> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::fixed, decimals);
    std::string digits(buffer.data(), end.ptr);
    if (digits.find_first_not_of("-0.") == std::string::npos && digits[0] == '-')
        digits.erase(0, 1);  // no negative zero
    return digits;
}

/// Parts of canonical names: the joint above a segment, and the segment; the studio's names in English.
const std::map<std::string, std::pair<std::string, std::string>>& partNames() {
    static const std::map<std::string, std::pair<std::string, std::string>> names = {
        {"Hips", {"pelvis", "pelvis"}},     {"Spine", {"lower back", "abdomen"}},
        {"Chest", {"upper back", "chest"}}, {"Neck", {"base of the neck", "neck"}},
        {"Head", {"neck", "head"}},         {"Shoulder", {"clavicle", "clavicle"}},
        {"Arm", {"shoulder", "upper arm"}}, {"ForeArm", {"elbow", "forearm"}},
        {"Hand", {"wrist", "hand"}},        {"UpLeg", {"hip", "thigh"}},
        {"Leg", {"knee", "shin"}},          {"Foot", {"ankle", "foot"}},
        {"ToeBase", {"toes", "toes"}},
    };
    return names;
}

/// side, then the part; empty when not canonical.
std::pair<std::string, const std::pair<std::string, std::string>*> partOf(const std::string& name) {
    const auto known = [](const std::string& part) {
        const auto found = partNames().find(part);
        return found == partNames().end() ? nullptr : &found->second;
    };
    if (name.starts_with("Left"))
        return {"left ", known(name.substr(4))};
    if (name.starts_with("Right"))
        return {"right ", known(name.substr(5))};
    return {"", known(name)};
}

}  // namespace

std::string escaped(const std::string& plain) {
    std::string safe;
    safe.reserve(plain.size());
    for (const char c : plain) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else if (c == '"')
            safe += "&quot;";
        else
            safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return safe;
}

std::string number(double value, int decimals) {
    if (!std::isfinite(value))
        return kUnknown;
    std::string digits = fixedPoint(value, decimals);
    return digits[0] == '-' ? kMinus + digits.substr(1) : digits;
}

std::string number(const std::optional<double>& value, int decimals) {
    return value ? number(*value, decimals) : kUnknown;
}

std::string coordinate(double value) {
    std::string digits = fixedPoint(std::isfinite(value) ? value : 0, 1);
    return digits.ends_with(".0") ? digits.substr(0, digits.size() - 2) : digits;
}

std::string count(int64_t value) {
    std::string digits = std::to_string(value < 0 ? -value : value);
    for (size_t at = digits.size(); at > 3; at -= 3)
        digits.insert(at - 3, kNarrowSpace);
    return (value < 0 ? kMinus : "") + digits;
}

std::string percent(double share) {
    const double value = 100 * share;
    if (!std::isfinite(value))
        return kUnknown;
    if (value > 99.5 && value < 100)
        return number(std::min(value, 99.9), 1) + " %";
    if (value > 0 && value < 0.5)
        return number(std::max(value, 0.1), 1) + " %";
    return number(value, 0) + " %";
}

std::string clock(double seconds) {
    if (!std::isfinite(seconds))
        return kUnknown;
    const int64_t whole = std::llround(std::abs(seconds));
    const auto two = [](int64_t n) { return (n < 10 ? "0" : "") + std::to_string(n); };
    const std::string minutes = whole >= 3600 ? two(whole / 60 % 60) : std::to_string(whole / 60);
    return (seconds < -0.5 ? kMinus : "") + (whole >= 3600 ? std::to_string(whole / 3600) + ":" : "") +
           minutes + ":" + two(whole % 60);
}

std::string degrees(double value_deg, int decimals) {
    return number(value_deg, decimals) + (std::isfinite(value_deg) ? "°" : "");
}

std::string plural(int64_t value, const std::string& one, const std::string& many) {
    return count(value) + " " + (value == 1 ? one : many);
}

std::string capitalised(std::string words) {
    if (!words.empty() && words[0] >= 'a' && words[0] <= 'z')
        words[0] = static_cast<char>(words[0] - 'a' + 'A');
    return words;
}

std::string utc(const std::string& iso8601) {
    const bool is_known = iso8601.size() >= 20 && iso8601[10] == 'T' && iso8601.back() == 'Z';
    return is_known ? iso8601.substr(0, 10) + " " + iso8601.substr(11, 5) + " UTC" : iso8601;
}

std::string jointLabel(const std::string& name) {
    const auto [side, part] = partOf(name);
    if (!part)
        return shortText(name, limits::kShownName);
    return capitalised(side + part->first);
}

std::string segmentLabel(const std::string& name) {
    const auto [side, part] = partOf(name);
    return part ? side + part->second : shortText(name, limits::kShownName);
}

}  // namespace noctule::text
