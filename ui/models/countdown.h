// SPDX-License-Identifier: Apache-2.0
// Seconds counted down aloud, by tones and the voice, for a performer whose back is to the
// screen. It has no timer: whoever shows it looks often.
#pragma once

#include <QString>
#include <functional>

namespace noctule::ui {

inline constexpr const char* kTonesSetting = "record/tones";

class Countdown {
public:
    using Clock = std::function<qint64()>;  ///< ms, never back
    static Clock steadyClock();

    explicit Countdown(int seconds, Clock now_ms = steadyClock());

    int seconds() const { return seconds_; }
    void setSeconds(int seconds) { seconds_ = seconds; }
    void start(bool tones);
    void end() { begun_ms_ = -1; }
    bool runs() const { return begun_ms_ >= 0; }
    /// 0 when it does not run.
    double left_s() const;
    /// Tells each second once. True: it is over, and does not run any more.
    bool look(bool tones);

    /// What the picture says as well.
    static void cue(const QString& words, bool tones);

private:
    int seconds_;
    Clock now_ms_;
    qint64 begun_ms_ = -1;
    int told_s_ = 0;
};

}  // namespace noctule::ui
