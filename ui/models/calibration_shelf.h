// SPDX-License-Identifier: Apache-2.0
// The calibrations of the open session: the files in its calibration/, newest first, and the one that new
// takes are made with. Using another one is a step that can be undone; nothing is ever overwritten. The one
// in force goes to the connected suit. What was found of a suit's parts is kept beyond the session
// (suit_memory.h) and used where the session has no calibration.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <optional>
#include <vector>

#include "core/processing/calibrate_takes.h"
#include "core/suit/calibration_parts.h"
#include "ui/models/live_suit.h"
#include "ui/models/session_model.h"
#include "ui/models/suit_memory.h"

namespace noctule::ui {

struct ShelvedCalibration {
    QString file;  ///< in calibration/
    Calibration calibration;

    QDateTime made() const;
};

class CalibrationShelf : public QObject {
    Q_OBJECT
public:
    /// `suits_folder`: where calibrations of suits are kept beyond sessions.
    CalibrationShelf(SessionModel& session, LiveSuit& suit, const QString& suits_folder,
                     QObject* parent = nullptr);

    /// Newest first; of no session none.
    const std::vector<ShelvedCalibration>& all() const { return all_; }
    /// What takes are made with now: of the session, else what is known of the suit itself.
    std::optional<Calibration> inForce() const;
    QString fileInForce() const;
    /// It is the one that this suit's takes are made with.
    bool isInForce(const ShelvedCalibration& shelved) const;
    /// The connected suit uses what an earlier session found of its parts; absent: it does not.
    const std::optional<Calibration>& remembered() const { return remembered_; }
    /// The calibration in force with values of parts that another session found later; absent: none is newer.
    const std::optional<Calibration>& newer() const { return newer_; }
    /// Whose serial numbers are not those of the connected suit; empty: all fit, or nothing is connected.
    QStringList strangers(const Calibration& calibration) const;
    /// Another suit's takes are made with it, or its serial numbers are another suit's (ownerOf).
    bool isOfAnotherSuit(const ShelvedCalibration& shelved) const;
    /// Serial number of the other suit that the calibration belongs to: of its box, else of a part. Empty: it
    /// may be this suit's. `path`: of a file that is to be imported.
    QString otherSuitOf(const QString& path) const;
    QString otherSuitOf(const Calibration& calibration) const;

    /// Writes "accelerometers-2026-11-22.json" and its report beside it and uses it. In words why not, else
    /// empty.
    QString save(const CalibrationResult& result, const QString& task);
    void use(const QString& file, const QString& what);
    /// Writes newer() into the session and uses it.
    QString useNewer();
    /// Copies a calibration file into the session and uses it, whosever it is. In words why not, else empty.
    QString importFile(const QString& path);
    /// Writes the one in force. In words why not, else empty.
    QString exportFile(const QString& path) const;
    /// The suit is worn beside others: the session's one calibration is not its own, unless its parts say so.
    void setBeside(bool beside);
    /// What save() would call it: "accelerometers-2026-11-22", or with "-2" behind it.
    QString nextName(const QString& task) const;

signals:
    void changed();
    /// save() has put a calibration in force.
    void saved(const QString& task, bool is_good);
    /// A whole sentence about what goes on.
    void told(const QString& what);
    /// Nothing failed, but it should be known: whole sentences.
    void warned(const QString& what);
    /// Another calibration of the session is given to the suit; what warned() said of the one before is over.
    void replaced();

private:
    void keepMeasures(const Actor& actor, const QString& what);
    void follow();
    void read(const QStringList& files);
    /// The file that the session names was read, or it names none.
    bool isInForceThere() const;
    void warnIfGone();
    /// Names of the calibration files in the folder, sorted.
    QStringList files() const;
    void noteWhatWasTakenBack(const QString& before);
    void hand();
    void remember(const Calibration& calibration);
    void recall();
    bool isOwnFile() const;
    bool isLeftToOthers(const Calibration& calibration) const;
    const ShelvedCalibration* chosenFile() const;
    CalibrationOwner ownerOf(const Calibration& calibration) const;
    void warnOfStrangers(const Calibration& calibration);
    QString write(const Calibration& calibration, const QString& name) const;
    QString folder() const;

    SessionModel& session_;
    LiveSuit& suit_;
    std::vector<ShelvedCalibration> all_;
    std::vector<Calibration> taken_back_;  ///< in this session
    QString folder_, in_force_;
    QStringList files_;              ///< files() when they were read
    std::optional<QString> handed_;  ///< to the suit that is connected
    const SuitMemory memory_;
    std::optional<Calibration> remembered_, newer_;
    bool is_beside_ = false;
};

}  // namespace noctule::ui
