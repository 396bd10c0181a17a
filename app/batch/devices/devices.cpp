// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <thread>

#include "app/batch/verb.h"
#include "core/job/outside_text.h"
#include "devices/discovery/discovery.h"

namespace noctule::batch {
namespace {

using Contact = FoundDevice::Contact;

constexpr auto kLookEvery = std::chrono::milliseconds(20);

/// Looks for as long as was asked, and until every probed port has answered or not.
Result<std::vector<FoundDevice>> lookAround(const VerbContext& context) {
    DiscoveryOptions options;
    options.udp_port = static_cast<uint16_t>(*context.arguments.whole("port"));
    options.probe_serial_ports = context.arguments.given("probe");
    Discovery discovery(options);
    const double wait_s = *context.arguments.number("wait");
    const auto begin = std::chrono::steady_clock::now();
    while (true) {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
        if (context.cancel.cancelled())
            return JobContext::cancelledError();
        if (passed.count() >= wait_s && discovery.isSettled())
            return discovery.found();
        context.job().progress(wait_s > 0 ? passed.count() / wait_s : 1, "looking for devices");
        std::this_thread::sleep_for(kLookEvery);
    }
}

const char* nameOf(Contact contact) {
    switch (contact) {
        case Contact::kAnswers:
            return "answers";
        case Contact::kNotAsked:
            return "not asked";
        case Contact::kAsking:
            return "asking";
        case Contact::kSilent:
            return "no answer";
    }
    return "";
}

nlohmann::json deviceJson(const FoundDevice& device) {
    nlohmann::json json = {{"address", device.address},
                           {"name", device.name},
                           {"model", device.model},
                           {"contact", nameOf(device.contact)}};
    if (device.contact != Contact::kAnswers)
        return json;
    json["serial"] = device.serial;
    json["boards"] = device.boards;
    json["sources"] = device.sources;
    json["sample_rate_hz"] = device.sample_rate_hz;
    json["busy"] = device.busy;
    return json;
}

std::string deviceText(const FoundDevice& device) {
    std::string text = visibleText(device.address) + "\n";
    const auto add = [&](const std::string& what) {
        if (!what.empty())
            text += (text.ends_with('\n') ? "  " : ", ") + visibleText(what);
    };
    add(device.name);
    add(device.model);
    if (device.contact == Contact::kAnswers) {
        add("serial number " + device.serial);
        add(std::to_string(device.boards) + " boards");
        add(std::to_string(device.sources) + " sources");
        add(std::to_string(device.sample_rate_hz) + " Hz");
        add(device.busy ? "busy: another studio has it" : "");
    } else if (device.contact == Contact::kNotAsked) {
        add("a serial port that was not asked (--probe asks it)");
    } else {
        add("a serial port where no box answers");
    }
    return text + "\n";
}

Result<Outcome> runDevices(const VerbContext& context) {
    const auto devices = lookAround(context);
    if (!devices)
        return devices.error();
    Outcome outcome{{{"devices", nlohmann::json::array()}}, "", std::nullopt};
    for (const FoundDevice& device : *devices) {
        outcome.json["devices"].push_back(deviceJson(device));
        outcome.text += deviceText(device);
    }
    if (devices->empty())
        outcome.text =
            "No device was found. Switch the driver box on, bring it into the same network or plug it in, "
            "and try again with a longer --wait; noctule-virtual-suit --announce is a box without "
            "hardware.\n";
    return outcome;
}

}  // namespace

Verb devicesVerb() {
    Verb verb;
    verb.name = "devices";
    verb.summary = kDevicesSummary;
    verb.example = "noctule --batch devices --wait 4";
    verb.options = {
        number("wait", "S", 0, 3600, "seconds to look around").orElse("2"),
        flag("probe", "also ask the serial ports of USB devices, which sends them a few bytes"),
        whole("port", "N", 1, 65535, "UDP port at which boxes listen")
            .orElse(std::to_string(link::kDiscoveryPort)),
    };
    verb.remarks = {"Finding nothing is no error: the exit code is 0 and the list is empty."};
    verb.run = runDevices;
    return verb;
}

}  // namespace noctule::batch
