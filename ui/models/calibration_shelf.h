// SPDX-License-Identifier: Apache-2.0
// The calibrations of the open session: the files in its calibration/, newest first, and the one that new
// takes are made with. Using another one is a step that can be undone; nothing is ever overwritten. The one
// in force goes to the connected suit.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <optional>
#include <vector>

#include "core/processing/calibrate_takes.h"
#include "ui/models/live_suit.h"
#include "ui/models/session_model.h"

namespace noctule::ui {

struct ShelvedCalibration {
    QString file;  ///< in calibration/
    Calibration calibration;

    QDateTime made() const;
};

class CalibrationShelf : public QObject {
    Q_OBJECT
public:
    CalibrationShelf(SessionModel& session, LiveSuit& suit, QObject* parent = nullptr);

    /// Newest first; of no session none.
    const std::vector<ShelvedCalibration>& all() const { return all_; }
    /// What takes are made with now: of the session, else what is known of the suit itself.
    std::optional<Calibration> inForce() const;
    QString fileInForce() const;
    /// Whose serial numbers are not those of the connected suit; empty: all fit, or nothing is connected.
    QStringList strangers(const Calibration& calibration) const;

    /// Writes "accelerometers-2026-11-22.json" and its report beside it and uses it. In words why not, else
    /// empty.
    QString save(const CalibrationResult& result, const QString& task);
    void use(const QString& file, const QString& what);
    /// What save() would call it: "accelerometers-2026-11-22", or with "-2" behind it.
    QString nextName(const QString& task) const;

signals:
    void changed();
    /// Nothing failed, but it should be known: whole sentences.
    void warned(const QString& what);

private:
    void keepMeasures(const Actor& actor, const QString& what);
    void follow();
    void read();
    void hand();
    QString folder() const;

    SessionModel& session_;
    LiveSuit& suit_;
    std::vector<ShelvedCalibration> all_;
    QString folder_, in_force_;
    std::optional<QString> handed_;   ///< to the suit that is connected
    std::optional<Calibration> own_;  ///< what the suit knew of itself before that
};

}  // namespace noctule::ui
