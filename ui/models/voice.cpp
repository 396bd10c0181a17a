// SPDX-License-Identifier: Apache-2.0
#include "ui/models/voice.h"

#include <QSettings>

namespace noctule::ui {
namespace {
constexpr const char* kVoice = "sound/voice";
}

Voice& Voice::get() {
    static Voice voice;
    return voice;
}

void Voice::setSpeaker(Speaker speaker) {
    speaker_ = std::move(speaker);
    emit changed();
}

bool Voice::isOn() const {
    return QSettings().value(kVoice, true).toBool();
}

void Voice::setOn(bool on) {
    QSettings().setValue(kVoice, on);
    emit changed();
}

void Voice::say(const QString& words) {
    if (speaker_ && isOn() && !words.isEmpty())
        speaker_(words);
}

}  // namespace noctule::ui
