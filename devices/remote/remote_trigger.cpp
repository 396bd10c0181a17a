// SPDX-License-Identifier: Apache-2.0
#include "devices/remote/remote_trigger.h"

#include <QNetworkDatagram>
#include <algorithm>
#include <future>

#include "devices/machine/clock.h"

namespace noctule {
namespace {

constexpr size_t kMostHeard = 64;  ///< kept to know repetitions by

}  // namespace

Result<std::unique_ptr<RemoteTrigger>> RemoteTrigger::listen(const RemoteTriggerOptions& options,
                                                             Listener listener) {
    const QHostAddress only_from(QString::fromStdString(options.only_from));
    if (!options.only_from.empty() && only_from.isNull())
        return Error{ErrorKind::kUsage, options.only_from + ": is not the address of a computer",
                     "Give it in numbers, such as 10.0.0.5"};
    std::unique_ptr<RemoteTrigger> trigger(new RemoteTrigger(only_from, std::move(listener)));
    if (const Status opened = trigger->open(options.port); !opened)
        return opened.error();
    return trigger;
}

RemoteTrigger::RemoteTrigger(QHostAddress only_from, Listener listener)
    : only_from_(std::move(only_from)), listener_(std::move(listener)) {
    thread_ = std::make_unique<LoopThread>("remote trigger", [this] { socket_.reset(); });
}

Status RemoteTrigger::open(uint16_t port) {
    const auto outcome = std::make_shared<std::promise<QString>>();
    thread_->post([this, outcome, port] {
        socket_ = std::make_unique<QUdpSocket>();
        QObject::connect(socket_.get(), &QUdpSocket::readyRead, socket_.get(), [this] { read(); });
        const bool bound = socket_->bind(QHostAddress::AnyIPv4, port, QAbstractSocket::DontShareAddress);
        port_ = socket_->localPort();
        outcome->set_value(bound ? QString() : socket_->errorString());
    });
    const QString why = outcome->get_future().get();
    if (why.isEmpty())
        return Done{};
    return Error{ErrorKind::kDevice,
                 "UDP port " + std::to_string(port) + ": cannot be listened to: " + why.toStdString(),
                 "Choose another port; those below 1024 belong to the administrator"};
}

void RemoteTrigger::read() {
    while (socket_->hasPendingDatagrams()) {
        const QNetworkDatagram datagram = socket_->receiveDatagram(kMostMessageBytes + 1);
        if (only_from_.isNull() || datagram.senderAddress().isEqual(only_from_)) {
            handle(datagram.data());
        } else {
            const std::lock_guard lock(counts_mutex_);
            ++counts_.from_others;
        }
    }
}

void RemoteTrigger::handle(const QByteArray& datagram) {
    const auto message = readCaptureMessage(datagram);
    const bool repeated = message && isRepeated(*message);
    {
        const std::lock_guard lock(counts_mutex_);
        ++(!message ? counts_.malformed : repeated ? counts_.repeated : counts_.told);
    }
    if (message && !repeated)
        listener_(*message);
}

bool RemoteTrigger::isRepeated(const CaptureMessage& message) {
    const int64_t now_ns = steadyNow_ns();
    std::erase_if(heard_, [&](const Heard& heard) { return now_ns - heard.heard_ns > kRepeated_ns; });
    if (message.packet_id.empty())
        return false;
    const bool repeated = std::ranges::any_of(heard_, [&](const Heard& heard) {
        return heard.message.kind == message.kind && heard.message.packet_id == message.packet_id &&
               heard.message.name == message.name;
    });
    if (!repeated)
        heard_.push_back({message, now_ns});
    if (heard_.size() > kMostHeard)
        heard_.pop_front();
    return repeated;
}

RemoteTrigger::Counts RemoteTrigger::counts() const {
    const std::lock_guard lock(counts_mutex_);
    return counts_;
}

}  // namespace noctule
