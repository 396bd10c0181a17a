// SPDX-License-Identifier: Apache-2.0
#include "ui/models/countdown_setting.h"

#include <QSettings>

namespace noctule::ui {
namespace {

constexpr const char* kCountdown = "record/countdown_s";
constexpr int kUsualCountdown_s = 3;

}  // namespace

CountdownSetting& CountdownSetting::get() {
    static CountdownSetting countdown;
    return countdown;
}

int CountdownSetting::seconds() const {
    return QSettings().value(kCountdown, kUsualCountdown_s).toInt();
}

void CountdownSetting::setSeconds(int seconds) {
    QSettings().setValue(kCountdown, seconds);
    emit changed();
}

}  // namespace noctule::ui
