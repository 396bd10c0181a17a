// SPDX-License-Identifier: Apache-2.0
#include "ui/models/countdown.h"

#include <QSettings>

namespace noctule::ui {
namespace {

constexpr const char* kCountdown = "record/countdown_s";
constexpr int kUsualCountdown_s = 3;

}  // namespace

Countdown& Countdown::get() {
    static Countdown countdown;
    return countdown;
}

int Countdown::seconds() const {
    return QSettings().value(kCountdown, kUsualCountdown_s).toInt();
}

void Countdown::setSeconds(int seconds) {
    QSettings().setValue(kCountdown, seconds);
    emit changed();
}

}  // namespace noctule::ui
