// SPDX-License-Identifier: Apache-2.0
#include "ui/models/tones.h"

#include <QApplication>
#include <QSettings>
#include <utility>

namespace noctule::ui {
namespace {

constexpr const char *kDeviceId = "sound/device", *kDeviceName = "sound/device_name";

}  // namespace

Tones& Tones::get() {
    static Tones tones;
    return tones;
}

std::vector<SoundDevice> Tones::devices() const {
    return player_.devices ? player_.devices() : std::vector<SoundDevice>{};
}

SoundDevice Tones::device() const {
    const QSettings settings;
    return {settings.value(kDeviceId).toString(), settings.value(kDeviceName).toString()};
}

void Tones::setDevice(const SoundDevice& device) {
    QSettings settings;
    settings.setValue(kDeviceId, device.id);
    settings.setValue(kDeviceName, device.name);
    has_told_ = false;
}

void Tones::play() {
    const QString id = device().id;
    if (id.isEmpty())
        QApplication::beep();
    else if (player_.play)
        player_.play(id, [this] { fallBack(); });
    else
        fallBack();
}

void Tones::fallBack() {
    QApplication::beep();
    if (!std::exchange(has_told_, true))
        emit fellBack(device().name);
}

}  // namespace noctule::ui
