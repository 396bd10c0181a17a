// SPDX-License-Identifier: Apache-2.0
#include "app/batch/devices/record_together.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include "app/batch/devices/record_report.h"
#include "app/batch/files.h"
#include "core/recording/take.h"

namespace noctule::batch {
namespace {

constexpr const char* kNone = "none";

Error usage(const std::string& message, const std::string& remedy) {
    return {ErrorKind::kUsage, message, remedy};
}

/// Of several suits: one box per device, no results, no trigger.
Status checkOptions(const Arguments& arguments) {
    for (const char* option : {"trigger", "keep-results"})
        if (arguments.given(option))
            return usage(std::string("--") + option + " works with one --device only",
                         option == std::string("trigger") ? "Leave it out, or record one suit"
                                                          : "Leave it out, and process the take afterwards");
    std::set<std::string> seen;
    for (const std::string& device : arguments.texts("device"))
        if (!seen.insert(device).second)
            return usage("--device " + device + " is given twice", "Give each suit a driver box of its own");
    seen.clear();
    for (const std::string& subject : arguments.texts("subject"))
        if (subject != kNone && !seen.insert(subject).second)
            return usage("two subjects are called \"" + subject + "\"", "Give each performer a name");
    return checkPerDevice(arguments);
}

/// What an option names for each device, read; nothing where it names none.
template <class Value>
Status readEach(const Arguments& arguments, const char* option, Result<Value> (*read)(const std::string&),
                std::vector<GroupSuit>& suits, std::optional<Value> GroupSuit::*into) {
    const std::vector<std::string> paths = arguments.texts(option);
    for (size_t i = 0; i < paths.size(); ++i) {
        if (paths[i] == kNone)
            continue;
        Result<Value> value = read(paths[i]);
        if (!value)
            return value.error();
        suits[i].*into = std::move(*value);
    }
    return Done{};
}

Result<GroupRequest> groupRequestOf(const Arguments& arguments, const StreamRequest& all) {
    GroupRequest request{all, std::vector<GroupSuit>(arguments.texts("device").size())};
    if (const Status read = readEach(arguments, "suit", readSuit, request.suits, &GroupSuit::suit); !read)
        return read.error();
    if (const Status read =
            readEach(arguments, "calibration", readCalibration, request.suits, &GroupSuit::calibration);
        !read)
        return read.error();
    if (const Status read = readEach(arguments, "actor", readActor, request.suits, &GroupSuit::actor); !read)
        return read.error();
    const std::vector<std::string> subjects = arguments.texts("subject");
    for (size_t i = 0; i < request.suits.size(); ++i) {
        GroupSuit& suit = request.suits[i];
        if (i < subjects.size() && subjects[i] != kNone)
            suit.subject = subjects[i];
        // Without a calibration nothing is known of distances, and poses would mislead.
        suit.process = suit.calibration.has_value();
    }
    return request;
}

/// The recorder's first guesses, as they stand in the take; empty when it cannot be read.
std::vector<SuitClock> clocksIn(const std::string& path, size_t suits) {
    std::vector<SuitClock> clocks;
    if (const auto take = Take::open(path))
        for (size_t i = 0; i < suits; ++i)
            clocks.push_back(take->suitClock(static_cast<int>(i + 1)));
    return clocks;
}

nlohmann::json groupJson(const GroupReport& report, const std::vector<std::string>& subjects) {
    const std::string& path = report.suits.front().stream.recording->path;
    const std::vector<SuitClock> clocks = clocksIn(path, report.suits.size());
    nlohmann::json suits = nlohmann::json::array();
    double seconds = 0;
    int64_t lost_samples = 0, gaps = 0;
    for (size_t i = 0; i < report.suits.size(); ++i) {
        const SuitReport& suit = report.suits[i];
        nlohmann::json json = recordingJson(suit);
        for (const char* of_all : {"take", "interrupted"})
            json.erase(of_all);
        json["suit"] = i + 1;
        json["device"] = suit.address;
        json["serial"] = suit.serial;
        json["room"] = suit.is_room;
        if (i < subjects.size() && !suit.is_room)
            json["subject"] = subjects[i];
        if (i < clocks.size())
            json["clock_offset_ms"] = 1e-6 * clocks[i].offset_ns;
        if (suit.stream.trouble)
            json["error"] = errorJson(*suit.stream.trouble);
        seconds = std::max(seconds, json["seconds"].get<double>());
        lost_samples += json["lost_samples"].get<int64_t>();
        gaps += json["gaps"].get<int64_t>();
        suits.push_back(std::move(json));
    }
    return {{"take", path},
            {"seconds", seconds},
            {"lost_samples", lost_samples},
            {"gaps", gaps},
            {"interrupted", report.interrupted},
            {"warnings", report.warnings},
            {"suits", std::move(suits)}};
}

std::string groupText(const GroupReport& report) {
    std::string all;
    for (size_t i = 0; i < report.suits.size(); ++i)
        all += "suit " + std::to_string(i + 1) + " of " + recordingText(report.suits[i]);
    return all;
}

/// What ended the file has ended it for all suits, and is told once; then what happened to each box.
std::vector<Error> troublesOf(const GroupReport& report) {
    std::vector<Error> troubles;
    for (const SuitReport& suit : report.suits)
        if (suit.stream.recording->trouble && troubles.empty())
            troubles.push_back(*suit.stream.recording->trouble);
    for (const SuitReport& suit : report.suits)
        if (suit.stream.trouble)
            troubles.push_back(*suit.stream.trouble);
    return troubles;
}

}  // namespace

Status checkPerDevice(const Arguments& arguments) {
    const size_t devices = arguments.texts("device").size();
    for (const char* option : {"suit", "calibration", "actor", "subject"})
        if (const size_t given = arguments.texts(option).size(); given > 0 && given != devices)
            return usage(std::string("--") + option + " is given " + std::to_string(given) + " times for " +
                             std::to_string(devices) + (devices == 1 ? " device" : " devices"),
                         devices == 1
                             ? "Give it once"
                             : "Give one per device in the order of the devices, `none` for a device "
                               "without");
    return Done{};
}

Result<Outcome> recordSeveral(const VerbContext& context, const StreamRequest& all) {
    const Arguments& arguments = context.arguments;
    if (const Status checked = checkOptions(arguments); !checked)
        return checked.error();
    const auto request = groupRequestOf(arguments, all);
    if (!request)
        return request.error();
    std::vector<std::unique_ptr<Device>> devices;
    for (const std::string& address : arguments.texts("device")) {
        auto device = makeDevice(address);
        if (!device)
            return device.error();
        devices.push_back(std::move(*device));
    }
    const auto report =
        recordTogether(std::move(devices), *request, arguments.number("seconds"), context.job());
    if (!report)
        return report.error();
    for (const std::string& warning : report->warnings)
        context.console.warn(warning);
    for (const SuitReport& suit : report->suits)
        for (const std::string& warning : suit.stream.warnings)
            context.console.warn(warning);
    Outcome outcome{groupJson(*report, arguments.texts("subject")), groupText(*report), std::nullopt};
    for (const Error& trouble : troublesOf(*report)) {
        context.console.error(trouble);
        if (outcome.failure)
            continue;
        outcome.json["error"] = errorJson(trouble);
        outcome.failure = trouble;
    }
    return outcome;
}

}  // namespace noctule::batch
