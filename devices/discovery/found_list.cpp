// SPDX-License-Identifier: Apache-2.0
#include "devices/discovery/found_list.h"

#include <algorithm>
#include <tuple>

#include "core/job/limits.h"

namespace noctule {

namespace {

bool isLoopback(const std::string& host) {
    return host.starts_with("127.") || host == "::1";
}

bool isSerial(const std::string& address) {
    return address.starts_with("serial:");
}

}  // namespace

std::string FoundList::addressOf(const Box& box) {
    const auto local = std::ranges::find_if(box.hosts, isLoopback, &Heard::host);
    const std::string& host = (local == box.hosts.end() ? box.hosts.front() : *local).host;
    return "tcp://" + host + ":" + std::to_string(box.announcement.tcp_port);
}

FoundDevice FoundList::deviceOf(const Box& box) {
    const link::Announcement& said = box.announcement;
    return {addressOf(box),      said.serial, said.name,
            said.model,          said.boards, said.sources,
            said.sample_rate_hz, said.busy,   FoundDevice::Contact::kAnswers};
}

bool FoundList::announced(const link::Announcement& announcement, const std::string& host, int64_t now_ns) {
    const auto known_box = boxes_.find({announcement.serial, announcement.tcp_port});
    if (known_box == boxes_.end() && boxes_.size() >= limits::kAnnouncedBoxes)
        return false;
    // Only of this box: with every answer of a flood the whole list would be compared.
    const auto before = known_box == boxes_.end() ? std::nullopt : std::optional(deviceOf(known_box->second));
    Box& box = boxes_[{announcement.serial, announcement.tcp_port}];
    box.announcement = announcement;
    const auto known = std::ranges::find(box.hosts, host, &Heard::host);
    if (known == box.hosts.end())
        box.hosts.push_back({host, now_ns});
    else
        known->when_ns = now_ns;
    return deviceOf(box) != before;
}

bool FoundList::forgetSilent(int64_t now_ns) {
    const auto before = devices();
    for (auto& [key, box] : boxes_)
        std::erase_if(box.hosts,
                      [&](const Heard& heard) { return now_ns - heard.when_ns >= kForgetAfter_ns; });
    std::erase_if(boxes_, [](const auto& entry) { return entry.second.hosts.empty(); });
    return devices() != before;
}

bool FoundList::setPorts(const std::vector<FoundDevice>& ports) {
    const auto before = devices();
    std::erase_if(ports_, [&](const auto& entry) {
        return isSerial(entry.first) &&
               std::ranges::find(ports, entry.first, &FoundDevice::address) == ports.end();
    });
    for (const FoundDevice& port : ports)
        ports_.try_emplace(port.address, port);
    return devices() != before;
}

bool FoundList::probing(const std::string& address) {
    const auto before = devices();
    FoundDevice& device = ports_[address];
    device.address = address;
    device.contact = FoundDevice::Contact::kAsking;
    return devices() != before;
}

bool FoundList::probed(const std::string& address, const std::optional<link::Hello>& hello) {
    const auto before = devices();
    const auto entry = ports_.find(address);
    if (entry == ports_.end())
        return false;
    FoundDevice& device = entry->second;
    device.contact = hello ? FoundDevice::Contact::kAnswers : FoundDevice::Contact::kSilent;
    if (hello) {
        device.serial = hello->serial;
        device.name = hello->name;
        device.model = hello->model;
        device.boards = hello->boardCount();
        device.sources = static_cast<int>(hello->suit.sources.size());
        device.sample_rate_hz = hello->sample_rate_hz;
        device.busy = false;
    }
    return devices() != before;
}

std::vector<FoundDevice> FoundList::devices() const {
    std::vector<FoundDevice> devices;
    for (const auto& [key, box] : boxes_)
        devices.push_back(deviceOf(box));
    std::ranges::sort(devices, {}, [](const FoundDevice& device) {
        return std::tie(device.name, device.serial, device.address);
    });
    for (const auto& [address, device] : ports_)
        devices.push_back(device);
    return devices;
}

}  // namespace noctule
