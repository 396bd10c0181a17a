// SPDX-License-Identifier: Apache-2.0
// Spoken cues beside the tones: what a performer hears who stands with the back to the screen. One for the
// whole program; silent until the program gives it a speaker.
#pragma once

#include <QObject>
#include <QString>
#include <functional>

namespace noctule::ui {

class Voice : public QObject {
    Q_OBJECT
public:
    using Speaker = std::function<void(const QString& words)>;

    static Voice& get();

    /// Empty: nothing here can speak.
    void setSpeaker(Speaker speaker);
    bool canSpeak() const { return static_cast<bool>(speaker_); }
    /// The operator's choice, kept in the settings; on by default.
    bool isOn() const;
    void setOn(bool on);
    /// The newest words silence older ones: a cue that comes late misleads.
    void say(const QString& words);

signals:
    void changed();

private:
    Voice() = default;

    Speaker speaker_;
};

}  // namespace noctule::ui
