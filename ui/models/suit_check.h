// SPDX-License-Identifier: Apache-2.0
// Whether the connected suit is ready, kept up to date: what the suit tells is judged several times a second
// (core/live/readiness.h) together with what the operator has accepted and what the disk holds.
#pragma once

#include <QDateTime>
#include <QElapsedTimer>
#include <QObject>
#include <QTime>
#include <QTimer>
#include <functional>
#include <memory>
#include <set>

#include "core/live/battery_forecast.h"
#include "core/live/readiness.h"
#include "ui/models/live_suit.h"

namespace noctule::ui {

/// Of the oldest of its parts; invalid: not known.
QDateTime madeAt(const CalibrationStepState& state);
/// With its age.
CalibrationStepState agedStep(CalibrationStep step, const Suit& suit, const Calibration& calibration,
                              const QDateTime& now);

class SuitCheck : public QObject {
    Q_OBJECT
public:
    /// `storage_left_s`: how long can be recorded; absent: not known.
    SuitCheck(LiveSuit& suit, std::function<std::optional<double>()> storage_left_s,
              QObject* parent = nullptr);

    /// Of no suit: waiting, without boards.
    const Readiness& readiness() const { return readiness_; }
    const LiveSuit& suit() const { return suit_; }
    /// When a board fell silent; invalid when it is not, or was never heard.
    QTime silentSince(int board) const;
    /// When the link broke; invalid while it holds.
    QTime lostSince() const { return is_lost_ ? nothing_since_ : QTime(); }
    /// Since when no sound arrives, broken link or not; invalid while it does.
    QTime nothingSince() const { return nothing_since_; }
    std::optional<double> batteryLeft_s() const { return battery_.left_s(); }
    /// Of sound that arrives now; absent until it was measured, and while nothing arrives.
    std::optional<double> bytesPerSecond() const { return bytes_per_s_; }

    /// Whether the last check of this wearing was good; absent: none was made.
    void setChecked(std::optional<bool> is_good);
    /// When the rest pose in force was made; invalid: there is none, or its time is not known.
    QDateTime restPoseMade() const;
    /// Until it is heard again.
    void goOnWithout(const ReadinessProblem& problem);

signals:
    void changed();

private:
    void follow();
    void judge();
    void addFit(ReadinessFacts& facts) const;
    void noteTimes();
    void measureRate();
    void forgetAccepted();

    LiveSuit& suit_;
    const std::function<std::optional<double>()> storage_left_s_;
    std::unique_ptr<ReadinessJudge> judge_;
    Readiness readiness_;
    std::string serial_;
    std::set<int> without_boards_, without_sources_;
    std::vector<QTime> silent_since_;
    std::vector<bool> was_heard_;
    QTime nothing_since_;
    bool is_lost_ = false;
    std::optional<bool> checked_;
    BatteryForecast battery_;
    QElapsedTimer clock_;
    int64_t rate_from_sample_ = -1;
    QElapsedTimer rate_clock_;
    std::optional<double> bytes_per_s_;
    QTimer timer_;
};

}  // namespace noctule::ui
