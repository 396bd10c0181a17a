// SPDX-License-Identifier: Apache-2.0
#include "ui/models/time_cursor.h"

#include <algorithm>
#include <cmath>

namespace noctule::ui {
namespace {

constexpr int kTick_ms = 16;
constexpr double kSlowest = 0.1, kFastest = 4;
/// A step of the frame grid that is nearer than this counts as reached.
constexpr double kOnFrame = 1e-3;

}  // namespace

TimeCursor::TimeCursor(QObject* parent) : QObject(parent) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kTick_ms);
    connect(&timer_, &QTimer::timeout, this, &TimeCursor::advance);
}

void TimeCursor::setExtent(double duration_s, double frame_step_s) {
    pause();
    duration_s_ = std::isfinite(duration_s) ? std::max(0.0, duration_s) : 0;
    setFrames(0, frame_step_s);
    in_s_ = 0, out_s_ = duration_s_;
    time_s_ = 0;
    emit extentChanged();
    emit rangeChanged(in_s_, out_s_);
    emit timeChanged(time_s_);
}

void TimeCursor::setFrames(double first_s, double frame_step_s) {
    if (std::isfinite(first_s) && frame_step_s > 0 && std::isfinite(frame_step_s))
        first_frame_s_ = first_s, frame_step_s_ = frame_step_s;
}

void TimeCursor::setTime(double t_s) {
    if (std::isnan(t_s))
        return;
    const double time_s = std::clamp(t_s, 0.0, duration_s_);
    if (time_s == time_s_)
        return;
    time_s_ = time_s;
    emit timeChanged(time_s_);
}

void TimeCursor::setRange(double in_s, double out_s) {
    if (std::isnan(in_s) || std::isnan(out_s))
        return;
    in_s = std::clamp(in_s, 0.0, duration_s_);
    out_s = std::clamp(out_s, 0.0, duration_s_);
    if (in_s > out_s)
        std::swap(in_s, out_s);
    if (in_s == in_s_ && out_s == out_s_)
        return;
    in_s_ = in_s, out_s_ = out_s;
    emit rangeChanged(in_s_, out_s_);
}

void TimeCursor::chooseRange(double in_s, double out_s) {
    emit choosingRange();
    setRange(in_s, out_s);
    emit rangeChosen();
}

void TimeCursor::setSpeed(double speed) {
    if (std::isnan(speed))
        return;
    const double limited = std::copysign(std::clamp(std::abs(speed), kSlowest, kFastest), speed);
    if (limited == speed_)
        return;
    advance();  // the time so far passed at the old speed
    speed_ = limited;
    emit settingsChanged();
}

void TimeCursor::setLoop(bool loops) {
    if (loops == loops_)
        return;
    loops_ = loops;
    emit settingsChanged();
}

void TimeCursor::play() {
    if (isPlaying() || duration_s_ <= 0)
        return;
    const bool backwards = speed_ < 0;
    const bool inside = time_s_ >= in_s_ && time_s_ <= out_s_;
    const bool at_end = backwards ? time_s_ <= in_s_ : time_s_ >= out_s_;
    if (!inside || at_end)
        setTime(backwards ? out_s_ : in_s_);
    clock_.start();
    timer_.start();
    emit playingChanged(true);
}

void TimeCursor::pause() {
    if (!isPlaying())
        return;
    timer_.stop();
    emit playingChanged(false);
}

void TimeCursor::toggle() {
    isPlaying() ? pause() : play();
}

void TimeCursor::stepFrames(int frames) {
    pause();
    const double place = (time_s_ - first_frame_s_) / frame_step_s_;
    const double nearest = std::round(place);
    const bool on_frame = std::abs(place - nearest) < kOnFrame;
    double target = nearest + frames;
    if (!on_frame)  // the first step goes to the next frame in its direction
        target = frames >= 0 ? std::floor(place) + frames : std::ceil(place) + frames;
    setTime(first_frame_s_ + target * frame_step_s_);
}

double TimeCursor::frameAt(double t_s) const {
    const double first = std::ceil(-first_frame_s_ / frame_step_s_ - kOnFrame);
    const double last = std::floor((duration_s_ - first_frame_s_) / frame_step_s_ + kOnFrame);
    const double frame =
        std::clamp(std::round((t_s - first_frame_s_) / frame_step_s_), first, std::max(first, last));
    return std::clamp(first_frame_s_ + frame * frame_step_s_, 0.0, duration_s_);
}

void TimeCursor::stepSeconds(double seconds) {
    pause();
    setTime(time_s_ + seconds);
}

void TimeCursor::advance() {
    if (!isPlaying())
        return;
    const double elapsed_s = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
    clock_.start();
    const double length_s = out_s_ - in_s_;
    double time_s = time_s_ + speed_ * elapsed_s;
    const bool beyond = speed_ < 0 ? time_s < in_s_ : time_s > out_s_;
    if (beyond && loops_ && length_s > 0) {
        const double place = std::fmod(time_s - in_s_, length_s);
        time_s = in_s_ + (place < 0 ? place + length_s : place);
    } else if (beyond) {
        setTime(speed_ < 0 ? in_s_ : out_s_);
        pause();
        return;
    }
    setTime(time_s);
}

}  // namespace noctule::ui
