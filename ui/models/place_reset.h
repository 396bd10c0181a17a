// SPDX-License-Identifier: Apache-2.0
// "My heading and place are here": from then on the live body that is looked at stands at its place in the
// row and faces the floor's forward (+Z), until its next stream begins there by itself. Only what is shown
// live is moved; readings, poses and takes stay as they are. A take that is recorded meanwhile gets a marker.
#pragma once

#include <QObject>
#include <QSettings>
#include <QTimer>

#include "ui/models/countdown.h"
#include "ui/models/live_suits.h"

namespace noctule::ui {

class PlaceReset : public QObject {
    Q_OBJECT
public:
    PlaceReset(LiveSuits& suits, SessionModel& session, QSettings& settings,
               Countdown::Clock now_ms = Countdown::steadyClock(), QObject* parent = nullptr);

    /// In words why it cannot be done now; empty: it can.
    QString whyNot() const;
    /// A step on the session's undo stack.
    void reset();
    /// After the countdown of Record, so that a lone performer gets to the mark; while it runs, ends it.
    void resetLater();
    bool isCounting() const { return countdown_.runs(); }
    /// As the same key does; nothing when none runs.
    void endCountdown();
    /// At the countdown; a timer does so 30 times a second.
    void look();

signals:
    void changed();  ///< whyNot() or isCounting()
    void wasReset(const QString& who);
    /// Any body is shown elsewhere now: reset, taken back or done again.
    void moved();
    /// In the take that is being recorded.
    void marked(double t_s, const QString& label);
    void said(const QString& sentence);

private:
    friend class PlaceStep;
    void follow();
    void stopCounting();
    bool tones() const;
    void tellMoved(const QString& label);

    LiveSuits& suits_;
    SessionModel& session_;
    QSettings& settings_;
    Countdown countdown_;
    QTimer timer_;
    const SuitInUse* counted_ = nullptr;  ///< whom the countdown is for
    QString why_not_;                     ///< as told last
};

}  // namespace noctule::ui
