// SPDX-License-Identifier: Apache-2.0
// The one time that body, plots and timeline show, and its playback. Seconds of the take's clock.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace noctule::ui {

class TimeCursor : public QObject {
    Q_OBJECT
public:
    explicit TimeCursor(QObject* parent = nullptr);

    double time() const { return time_s_; }
    double duration() const { return duration_s_; }
    double in() const { return in_s_; }
    double out() const { return out_s_; }
    double speed() const { return speed_; }
    double frameStep() const { return frame_step_s_; }
    bool isPlaying() const { return timer_.isActive(); }
    bool loops() const { return loops_; }

    /// Of the take that is shown; puts the cursor at its start, in and out at the ends.
    void setExtent(double duration_s, double frame_step_s);
    /// The frames that stepFrames() stops at.
    void setFrames(double first_s, double frame_step_s);
    /// The nearest of them within the take.
    double frameAt(double t_s) const;

public slots:
    void setTime(double t_s);  ///< clamped
    void setRange(double in_s, double out_s);
    /// At once by a command, not bit by bit as by a drag.
    void chooseRange(double in_s, double out_s);
    void setSpeed(double speed);  ///< 0.1 .. 4, negative: backwards
    void setLoop(bool loops);
    void play();
    void pause();
    void toggle();
    void stepFrames(int frames);
    void stepSeconds(double seconds);

signals:
    void timeChanged(double t_s);  ///< at most 60 times a second while playing
    void rangeChanged(double in_s, double out_s);
    void choosingRange();  ///< comes before rangeChanged(): in and out are the old ones yet
    void rangeChosen();
    void extentChanged();
    void playingChanged(bool playing);
    void settingsChanged();  ///< speed, loop

private:
    void advance();

    double time_s_ = 0, duration_s_ = 0, in_s_ = 0, out_s_ = 0, speed_ = 1, frame_step_s_ = 1.0 / 120;
    double first_frame_s_ = 0;
    bool loops_ = false;
    QTimer timer_;
    QElapsedTimer clock_;
};

}  // namespace noctule::ui
