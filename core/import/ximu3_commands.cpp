// SPDX-License-Identifier: Apache-2.0
#include "core/import/ximu3_commands.h"

#include <cctype>

#include "core/job/outside_text.h"
#include "core/math/json.h"

namespace noctule {

namespace {

/// "AHRS axes convention", "ahrs_axes_convention" -> ahrsaxesconvention: programs spell keys as they like.
std::string plainKey(const std::string& key) {
    std::string plain;
    for (const char c : key)
        if (std::isalnum(static_cast<unsigned char>(c)))
            plain += char(std::tolower(static_cast<unsigned char>(c)));
    return plain;
}

std::string shortValue(const json::Json& value) {
    return value.is_string() ? shortText(value.get_ref<const std::string&>(), limits::kName) : "";
}

std::optional<int> wholeNumber(const json::Json& value) {
    const auto number = json::number(value);
    constexpr double kMost = 1e6;
    return number && *number >= 0 && *number < kMost ? std::optional(static_cast<int>(*number))
                                                     : std::nullopt;
}

std::optional<WorldFrame> frameOf(const json::Json& value) {
    constexpr WorldFrame kFrames[] = {WorldFrame::kNorthWestUp, WorldFrame::kEastNorthUp,
                                      WorldFrame::kNorthEastDown};
    const auto number = wholeNumber(value);
    return number && *number < 3 ? std::optional(kFrames[*number]) : std::nullopt;
}

void addAnswer(const std::string& key, const json::Json& value, Ximu3Settings& settings) {
    if (key == "ping" && value.is_object()) {
        for (const auto& [member, of] : value.items())
            if (member == "name" || member == "deviceName")
                settings.name = shortValue(of);
            else if (member == "sn" || member == "serialNumber")
                settings.serial_number = shortValue(of);
    } else if (key == "devicename") {
        settings.name = shortValue(value);
    } else if (key == "serialnumber") {
        settings.serial_number = shortValue(value);
    } else if (key == "time") {
        settings.time = shortValue(value);
    } else if (key == "calibrationdate") {
        settings.calibration_date = shortValue(value);
    } else if (key == "ahrsaxesconvention") {
        settings.world = frameOf(value);
    } else if (key == "axesalignment") {
        settings.axes_alignment = wholeNumber(value);
    } else if (key == "inertialmessageratedivisor") {
        settings.inertial_divisor = wholeNumber(value);
    }
}

}  // namespace

void addXimu3Commands(std::string_view text, Ximu3Settings& settings) {
    const json::Json read = json::parse(text);
    settings.is_damaged |= !read.is_array() && !read.is_object();
    const json::Json list = read.is_array() ? read : json::Json::array({read});
    for (const json::Json& answer : list)
        if (answer.is_object())
            for (const auto& [key, value] : answer.items())
                addAnswer(plainKey(key), value, settings);
}

std::vector<std::string> ximu3Notes(const std::string& id, const Ximu3Settings& settings) {
    std::vector<std::string> notes;
    if (!settings.name.empty() || !settings.serial_number.empty())
        notes.push_back(id + " is '" + settings.name + "', serial number " +
                        (settings.serial_number.empty() ? "unknown" : settings.serial_number) +
                        (settings.time.empty() ? "" : ", by its clock at " + settings.time));
    if (!settings.calibration_date.empty())
        notes.push_back(id + " states a calibration of " + settings.calibration_date +
                        ": its readings contain it, nothing was applied again");
    if (settings.axes_alignment.value_or(0) > 0)
        notes.push_back(id + " turns its axes itself (axes alignment " +
                        std::to_string(*settings.axes_alignment) + "): its readings were taken as they are");
    if (settings.inertial_divisor)
        notes.push_back(id + " states an inertial message rate divisor of " +
                        std::to_string(*settings.inertial_divisor) +
                        "; the rate was taken from its time stamps");
    return notes;
}

}  // namespace noctule
