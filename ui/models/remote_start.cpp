// SPDX-License-Identifier: Apache-2.0
#include "ui/models/remote_start.h"

#include "ui/language/core_words.h"

namespace noctule::ui {
namespace {

constexpr const char *kAllowed = "remote/allowed", *kPort = "remote/port";

}  // namespace

RemoteStart::RemoteStart(QSettings& settings, QObject* parent) : QObject(parent), settings_(settings) {}

bool RemoteStart::isAllowed() const {
    return settings_.value(kAllowed, false).toBool();
}

int RemoteStart::port() const {
    return settings_.value(kPort, kUsualPort).toInt();
}

void RemoteStart::setAllowed(bool allowed) {
    settings_.setValue(kAllowed, allowed);
    begin();
}

void RemoteStart::setPort(int port) {
    settings_.setValue(kPort, port);
    begin();
}

void RemoteStart::begin() {
    trigger_.reset();
    problem_.clear();
    if (isAllowed()) {
        // Messages come on the trigger's thread.
        const auto listener = [this](const CaptureMessage& message) {
            QMetaObject::invokeMethod(
                this, [this, message] { hear(message); }, Qt::QueuedConnection);
        };
        auto trigger = RemoteTrigger::listen({static_cast<uint16_t>(port()), {}}, listener);
        if (trigger)
            trigger_ = std::move(*trigger);
        else
            problem_ = coreWords(trigger.error());
    }
    emit changed();
}

void RemoteStart::hear(const CaptureMessage& message) {
    if (!trigger_)
        return;  // not any more
    if (message.kind == CaptureMessage::Kind::kStop)
        emit stopWanted();
    else
        emit startWanted(QString::fromStdString(message.name), QString::fromStdString(message.notes));
}

}  // namespace noctule::ui
