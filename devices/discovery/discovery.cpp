// SPDX-License-Identifier: Apache-2.0
#include "devices/discovery/discovery.h"

#include <QSerialPortInfo>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <set>

#include "devices/device/address.h"
#include "devices/device/clock.h"
#include "devices/device/device.h"
#include "devices/device/loop_thread.h"
#include "devices/discovery/found_list.h"
#include "devices/discovery/lan_search.h"

namespace noctule {

namespace {

constexpr int kLookEvery_ms = 500;
constexpr int kProbeTime_ms = 1400;

FoundDevice serialPort(const std::string& path) {
    FoundDevice port;
    port.address = "serial://" + path;
    port.contact = FoundDevice::Contact::kNotAsked;
    return port;
}

/// USB alone: the fixed ports of a computer are always there and seldom lead anywhere.
std::vector<FoundDevice> usbPorts() {
    std::vector<FoundDevice> ports;
    for (const QSerialPortInfo& info : QSerialPortInfo::availablePorts()) {
        if (!info.hasVendorIdentifier())
            continue;
        FoundDevice port = serialPort(info.systemLocation().toStdString());
        port.name = info.description().toStdString();
        port.model = info.manufacturer().toStdString();
        ports.push_back(port);
    }
    return ports;
}

}  // namespace

/// All but found() and probe() run on the thread.
class Discovery::Search {
public:
    Search(const DiscoveryOptions& options, Listener listener)
        : options_(options), listener_(std::move(listener)), thread_("discovery", [this] { end(); }) {
        thread_.post([this] { begin(); });
    }
    ~Search() {
        closing_ = true;
        thread_.stop();
    }

    std::vector<FoundDevice> found() const {
        const std::lock_guard lock(mutex_);
        return found_;
    }
    void probe(const DeviceAddress& address) {
        thread_.post([this, address] { beginProbe(address); });
    }

private:
    void begin() {
        lan_ = std::make_unique<LanSearch>(
            options_.udp_port, [this](const link::Announcement& announcement, const std::string& host) {
                tell(list_.announced(announcement, host, steadyNow_ns()));
            });
        look_ = std::make_unique<QTimer>();
        QObject::connect(look_.get(), &QTimer::timeout, look_.get(), [this] { look(); });
        look_->start(kLookEvery_ms);
        look();
    }
    void end() {
        probes_.clear();
        lan_.reset();
        look_.reset();
    }

    void look() {
        tell(list_.forgetSilent(steadyNow_ns()));
        std::vector<FoundDevice> ports = options_.serial_ports ? usbPorts() : std::vector<FoundDevice>();
        std::error_code ignored;
        for (const std::string& path : probed_paths_)
            if (std::filesystem::exists(path, ignored))
                ports.push_back(serialPort(path));
        tell(list_.setPorts(ports));
    }

    void beginProbe(const DeviceAddress& address) {
        const std::string text = address.text();
        if (probes_.contains(text))
            return;
        auto device = makeDevice(text);
        if (!device)
            return;
        if (address.kind == DeviceAddress::Kind::kSerial)
            probed_paths_.insert(address.path);
        tell(list_.probing(text));
        Device& probe = *(probes_[text] = std::move(*device));
        probe.open([this, text](const DeviceEvent& event) {
            if (const auto* greeted = std::get_if<link::Greeted>(&event.event))
                thread_.post([this, text, hello = greeted->hello] { endProbe(text, hello); });
            else if (std::holds_alternative<link::Refused>(event.event))
                thread_.post([this, text] { endProbe(text, std::nullopt); });
        });
        QTimer::singleShot(kProbeTime_ms, look_.get(), [this, text, number = ++probe_number_] {
            if (numbers_[text] == number)
                endProbe(text, std::nullopt);
        });
        numbers_[text] = probe_number_;
    }

    void endProbe(const std::string& address, const std::optional<link::Hello>& hello) {
        if (probes_.erase(address) > 0)
            tell(list_.probed(address, hello));
    }

    void tell(bool changed) {
        if (!changed || closing_)
            return;
        const auto devices = list_.devices();
        {
            const std::lock_guard lock(mutex_);
            found_ = devices;
        }
        if (listener_)
            listener_(devices);
    }

    const DiscoveryOptions options_;
    const Listener listener_;
    std::atomic<bool> closing_ = false;
    FoundList list_;
    std::set<std::string> probed_paths_;
    std::unique_ptr<LanSearch> lan_;
    std::unique_ptr<QTimer> look_;
    std::map<std::string, std::unique_ptr<Device>> probes_;
    std::map<std::string, int> numbers_;  ///< of the last probe of an address: an older one's timer is void
    int probe_number_ = 0;

    mutable std::mutex mutex_;
    std::vector<FoundDevice> found_;

    LoopThread thread_;  ///< last: it uses the others
};

Discovery::Discovery(const DiscoveryOptions& options, Listener listener)
    : search_(std::make_unique<Search>(options, std::move(listener))) {}

Discovery::~Discovery() = default;

std::vector<FoundDevice> Discovery::found() const {
    return search_->found();
}

Status Discovery::probe(const std::string& address) {
    const auto read = readDeviceAddress(address);
    if (!read)
        return read.error();
    search_->probe(*read);
    return Done{};
}

}  // namespace noctule
