// SPDX-License-Identifier: Apache-2.0
#include "devices/device/driver_box_device.h"

#include "core/job/contract.h"
#include "devices/machine/clock.h"

namespace noctule {

DriverBoxDevice::DriverBoxDevice(std::string address, std::unique_ptr<ByteLink> link)
    : address_(std::move(address)), link_(std::move(link)), conversation_(address_) {}

DriverBoxDevice::~DriverBoxDevice() {
    closing_ = true;
    thread_.reset();
}

void DriverBoxDevice::open(Listener listener) {
    require(!thread_ && listener, "DriverBoxDevice::open: once, and with a listener");
    listener_ = std::move(listener);
    thread_ = std::make_unique<LoopThread>("driver box", [this] { end(); });
    thread_->post([this] { begin(); });
}

void DriverBoxDevice::start() {
    post([](auto& conversation, int64_t now_ns) { conversation.start(now_ns); });
}

void DriverBoxDevice::stop() {
    post([](auto& conversation, int64_t now_ns) { conversation.stop(now_ns); });
}

void DriverBoxDevice::identify(const link::Identify& identify) {
    post([identify](auto& conversation, int64_t now_ns) { conversation.identify(identify, now_ns); });
}

void DriverBoxDevice::set(const link::Settings& settings) {
    post([settings](auto& conversation, int64_t now_ns) { conversation.set(settings, now_ns); });
}

link::LinkStatistics DriverBoxDevice::statistics() const {
    const std::lock_guard lock(statistics_mutex_);
    return statistics_;
}

void DriverBoxDevice::post(Wish wish) {
    require(thread_ != nullptr, "DriverBoxDevice: a wish before open()");
    thread_->post([this, wish = std::move(wish)] { tell(wish); });
}

void DriverBoxDevice::begin() {
    link_->listen({
        [this] { tell([](auto& conversation, int64_t now_ns) { conversation.opened(now_ns); }); },
        [this](link::ByteView bytes) {
            tell([bytes](auto& conversation, int64_t now_ns) { conversation.receive(bytes, now_ns); });
        },
        [this](const std::string& why, const std::string& remedy) { connectionEnded(why, remedy); },
    });
    ticks_ = std::make_unique<QTimer>();
    ticks_->setTimerType(Qt::PreciseTimer);
    QObject::connect(ticks_.get(), &QTimer::timeout, ticks_.get(),
                     [this] { tell([](auto& conversation, int64_t now_ns) { conversation.tick(now_ns); }); });
    ticks_->start(kTickEvery_ms);
    link_->open();
}

/// The box must not stream on for nobody; whether it hears this is its luck.
void DriverBoxDevice::end() {
    ticks_.reset();
    conversation_.stop(steadyNow_ns());
    link_->write(conversation_.takeBytes());
    link_.reset();
}

void DriverBoxDevice::connectionEnded(const std::string& why, const std::string& remedy) {
    if (conversation_.state() == link::StudioConversation::State::kClosed)
        handle(link::Refused{{ErrorKind::kDevice, address_ + ": " + why, remedy}}, steadyNow_ns());
    else
        tell([](auto& conversation, int64_t now_ns) { conversation.closed(now_ns); });
}

/// Then moves what comes of it. A link that opens or fails at once tells so from within; what comes of that
/// is moved by the outer call.
void DriverBoxDevice::tell(const Wish& what) {
    const int64_t now_ns = steadyNow_ns();
    what(conversation_, now_ns);
    if (std::exchange(telling_, true))
        return;
    while (true) {
        const link::Bytes bytes = conversation_.takeBytes();
        std::vector<link::StudioEvent> events = conversation_.takeEvents();
        if (bytes.empty() && events.empty())
            break;
        link_->write(bytes);
        for (link::StudioEvent& event : events)
            handle(std::move(event), now_ns);
    }
    telling_ = false;
    const std::lock_guard lock(statistics_mutex_);
    statistics_ = conversation_.statistics();
}

void DriverBoxDevice::handle(link::StudioEvent event, int64_t now_ns) {
    const bool wants_connection = std::holds_alternative<link::ConnectWanted>(event);
    if (std::holds_alternative<link::LinkLost>(event) || std::holds_alternative<link::Refused>(event))
        link_->close();
    if (!closing_)
        listener_({std::move(event), now_ns});
    if (wants_connection)
        link_->open();
}

}  // namespace noctule
