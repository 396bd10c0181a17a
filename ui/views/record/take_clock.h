// SPDX-License-Identifier: Apache-2.0
// On the picture while a take is recorded: its name and shot, how long it runs, and up to where it is safe on
// the disk. Lets the mouse through.
#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "devices/live/recorder.h"
#include "ui/style/ink.h"

namespace noctule::ui {

class IconLabel;
class Label;

class TakeClock : public QWidget {
    Q_OBJECT
public:
    explicit TakeClock(QWidget* parent = nullptr);

    void setTake(const QString& name, const QString& shot, bool runs);
    void setSeconds(double seconds);
    /// Nothing to tell without one.
    void setRecorder(const std::optional<RecorderState>& recorder, int sample_rate_hz);
    /// "On disk up to 0:17.2"
    QString safety() const;
    Tone safetyTone() const { return tone_; }

private:
    class Digits;
    class Dot;

    Dot* dot_;
    Label* name_;
    Label* shot_;
    Digits* digits_;
    QWidget* safety_row_;
    IconLabel* safety_icon_;
    Label* safety_;
    Tone tone_ = Tone::kOk;
    int64_t commits_ = -1;
    QElapsedTimer since_commit_;
};

}  // namespace noctule::ui
