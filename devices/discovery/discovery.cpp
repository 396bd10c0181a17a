// SPDX-License-Identifier: Apache-2.0
#include "devices/discovery/discovery.h"

#include <QSerialPortInfo>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <set>
#include <utility>

#include "devices/device/address.h"
#include "devices/device/device.h"
#include "devices/device/loop_thread.h"
#include "devices/discovery/found_list.h"
#include "devices/discovery/lan_search.h"
#include "devices/machine/clock.h"

namespace noctule {

namespace {

constexpr int kLookEvery_ms = 500, kTellAfter_ms = 20;
constexpr int kProbe_ms = link::kSerialProbes * link::kSerialProbe_ms;

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

/// All but found(), isSettled() and probe() run on the thread.
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
    bool isSettled() const { return unsettled_ == 0; }
    void probe(const DeviceAddress& address) {
        ++unsettled_;
        thread_.post([this, address] {
            beginProbe(address);
            --unsettled_;
        });
    }

private:
    /// A device that was opened to hear who is there.
    struct Probe {
        int number = 0;  ///< what an earlier one of the same address does too late is void
        std::unique_ptr<Device> device;
    };

    void begin() {
        lan_ = std::make_unique<LanSearch>(
            options_.udp_port, [this](const link::Announcement& announcement, const std::string& host) {
                tellSoon(list_.announced(announcement, host, steadyNow_ns()));
            });
        look_ = std::make_unique<QTimer>();
        QObject::connect(look_.get(), &QTimer::timeout, look_.get(), [this] { look(); });
        look_->start(kLookEvery_ms);
        look();
        --unsettled_;
    }
    void end() {
        probes_.clear();
        lan_.reset();
        look_.reset();
    }

    void look() {
        tell(list_.forgetSilent(steadyNow_ns()));
        std::vector<FoundDevice> ports = options_.serial_ports ? usbPorts() : std::vector<FoundDevice>();
        const std::vector<FoundDevice> seen = ports;
        std::error_code ignored;
        for (const std::string& path : probed_paths_)
            if (std::filesystem::exists(path, ignored))
                ports.push_back(serialPort(path));
        tell(list_.setPorts(ports));
        if (!options_.probe_serial_ports)
            return;
        for (const FoundDevice& port : seen)
            if (const auto address = readDeviceAddress(port.address);
                address && !probed_paths_.contains(address->path))
                beginProbe(*address);
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
        ++unsettled_;
        const int number = ++probe_number_;
        Probe& probe = probes_[text] = {number, std::move(*device)};
        probe.device->open([this, text, number](const DeviceEvent& event) {
            if (const auto* greeted = std::get_if<link::Greeted>(&event.event))
                thread_.post([this, text, number, hello = greeted->hello] { endProbe(text, number, hello); });
            else if (std::holds_alternative<link::Refused>(event.event))
                thread_.post([this, text, number] { endProbe(text, number, std::nullopt); });
        });
        QTimer::singleShot(kProbe_ms, look_.get(),
                           [this, text, number] { endProbe(text, number, std::nullopt); });
    }

    void endProbe(const std::string& address, int number, const std::optional<link::Hello>& hello) {
        const auto probe = probes_.find(address);
        if (probe == probes_.end() || probe->second.number != number)
            return;
        probes_.erase(probe);
        tell(list_.probed(address, hello));
        --unsettled_;
    }

    /// Answers may come by the thousand: the list is handed out once for all of a moment.
    void tellSoon(bool changed) {
        if (!changed || closing_ || std::exchange(tells_soon_, true))
            return;
        QTimer::singleShot(kTellAfter_ms, look_.get(), [this] {
            tells_soon_ = false;
            tell(true);
        });
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
    bool tells_soon_ = false;
    FoundList list_;
    std::set<std::string> probed_paths_;
    std::unique_ptr<LanSearch> lan_;
    std::unique_ptr<QTimer> look_;
    std::map<std::string, Probe> probes_;  ///< by address
    int probe_number_ = 0;
    std::atomic<int> unsettled_ = 1;  ///< the first look, and probes under way

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

bool Discovery::isSettled() const {
    return search_->isSettled();
}

Status Discovery::probe(const std::string& address) {
    const auto read = readDeviceAddress(address);
    if (!read)
        return read.error();
    search_->probe(*read);
    return Done{};
}

}  // namespace noctule
