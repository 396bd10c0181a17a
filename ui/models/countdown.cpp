// SPDX-License-Identifier: Apache-2.0
#include "ui/models/countdown.h"

#include <QElapsedTimer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/models/tones.h"
#include "ui/models/voice.h"

namespace noctule::ui {

Countdown::Clock Countdown::steadyClock() {
    QElapsedTimer clock;
    clock.start();
    return [clock] { return clock.elapsed(); };
}

Countdown::Countdown(int seconds, Clock now_ms) : seconds_(seconds), now_ms_(std::move(now_ms)) {}

void Countdown::start(bool tones) {
    begun_ms_ = now_ms_();
    told_s_ = seconds_;
    cue(QString::number(told_s_), tones);
}

double Countdown::left_s() const {
    return runs() ? std::max(0.0, seconds_ - static_cast<double>(now_ms_() - begun_ms_) * 1e-3) : 0;
}

bool Countdown::look(bool tones) {
    if (!runs())
        return false;
    const double left_s = this->left_s();
    if (left_s <= 0) {
        end();
        return true;
    }
    const int second = static_cast<int>(std::ceil(left_s));
    if (std::exchange(told_s_, second) != second)
        cue(QString::number(second), tones);
    return false;
}

void Countdown::cue(const QString& words, bool tones) {
    if (tones)
        Tones::get().play();
    Voice::get().say(words);
}

}  // namespace noctule::ui
