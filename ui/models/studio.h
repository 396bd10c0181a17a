// SPDX-License-Identifier: Apache-2.0
// What all screens share: one session, one take under review, one time, one selection, one list of jobs, one
// set of preferences. Pages get a Studio& and talk to each other through it only.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QPointer>
#include <QSettings>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/figure/understood_motion.h"
#include "core/mesh/skinned_mesh.h"
#include "core/processing/process_take.h"
#include "ui/jobs/jobs.h"
#include "ui/models/contact_editor.h"
#include "ui/models/live_suits.h"
#include "ui/models/marker_editor.h"
#include "ui/models/remote_start.h"
#include "ui/models/selection.h"
#include "ui/models/session_model.h"
#include "ui/models/shown_body.h"
#include "ui/models/suit_finder.h"
#include "ui/models/take_document.h"
#include "ui/models/time_cursor.h"
#include "ui/models/virtual_suit.h"

namespace noctule::ui {

class LogFile;

/// What the program gives the studio: the screens know no simulator.
struct StudioParts {
    std::string software;                  ///< "noctule 0.1.0"
    std::function<std::string()> utc_now;  ///< ISO 8601
    /// Writes a take of the virtual suit on a sample motion, not yet processed.
    std::function<Status(const std::string& path, const JobContext&)> make_sample_take;
    /// Writes a take of the suit worn by the person of a motion, not yet processed. `scenario`: "nominal".
    std::function<Status(const figure::UnderstoodMotion& motion, const std::string& scenario,
                         const std::string& path, const JobContext&)>
        make_motion_take{};
    /// Path of noctule-virtual-suit; empty: there is none.
    std::string virtual_suit_program{};
    /// Outlives the studio; null: nothing is logged.
    LogFile* log = nullptr;
    /// Writes the sound of two virtual suits, worn by "A" and "B", that hear each other; null: there is one
    /// virtual suit only.
    std::function<Status(const std::string& path, const JobContext&)> make_pair_take{};
};

enum class Step { kStart, kConnect, kCalibrate, kRecord, kReview, kExport, kPerformer, kRobot };

class Studio : public QObject {
    Q_OBJECT
public:
    explicit Studio(StudioParts parts, QObject* parent = nullptr);

    const StudioParts& parts() const { return parts_; }
    Jobs& jobs() { return jobs_; }
    TimeCursor& time() { return time_; }
    Selection& selection() { return selection_; }
    SessionModel& session() { return session_; }
    ShownBody& shownBody() { return shown_body_; }
    TakeDocument& take() { return take_; }
    TakeChanges& changes() { return changes_; }
    MarkerEditor& markers() { return markers_; }
    ContactEditor& contacts() { return contacts_; }
    SuitFinder& finder() { return finder_; }
    LiveSuits& suits() { return suits_; }
    /// The one that is looked at, and what belongs to it.
    LiveSuit& suit() { return suits_.current().suit; }
    CalibrationShelf& calibrations() { return suits_.current().calibrations; }
    SuitCheck& check() { return suits_.current().check; }
    VirtualSuit& virtualSuit() { return virtual_suit_; }
    VirtualSuit& secondVirtualSuit() { return second_virtual_suit_; }
    RemoteStart& remoteStart() { return remote_start_; }
    QSettings& settings() { return settings_; }
    /// The body that ships with the studio; null until a job of the start has loaded it, or when it cannot be
    /// read.
    std::shared_ptr<const SkinnedMesh> body() const { return body_; }
    /// What views of motions draw: that of the session, or the studio's own.
    BodyLook look() const { return {body_, shown_body_.worn(), shown_body_.blending()}; }
    /// Runs `act` as soon as loading the body has ended, at once when it has; not when `context` is gone.
    void whenBodyIsThere(QObject* context, std::function<void()> act);

    /// Where sessions are made unless the operator says otherwise.
    QString sessionsFolder() const;
    /// Where calibrations of suits are kept beyond sessions.
    QString suitsFolder() const;
    /// Of the open session, else the one where sessions are made.
    QString takesFolder() const;
    /// A session with a sample take, processed and open in Review. The one made earlier is used again. A job;
    /// cancelled, nothing of it stays.
    Job* tryVirtualSuit();
    /// A take of the open session (one by date when none is open) with a simulated suit on the motion's
    /// person, processed and open in Review. A job; cancelled, nothing of it stays. Null: no session, and
    /// session().failed() said why.
    Job* importMotion(std::shared_ptr<const figure::UnderstoodMotion> motion, const std::string& scenario);
    /// Makes one by date when none is open; false: it could not be made, and session().failed() said why.
    bool makeSureOfSession() { return suit().makeSureOfSession(); }
    /// Starts the virtual suit's program and connects it.
    void startVirtualSuit();
    /// Two of them beside each other, that hear each other: the first begins anew.
    void startSecondVirtualSuit();
    /// A take of it that is being recorded ends intact first. With the first goes the second.
    void stopVirtualSuit();
    void stopSecondVirtualSuit();
    using CheckedSuit = ui::CheckedSuit;
    /// The last check of the suit that is looked at; empty: none was made.
    const std::optional<CheckedSuit>& checked() const { return suits_.current().checked; }
    void setChecked(const std::optional<CheckedSuit>& checked);
    /// The most accurate settings for a take that is recorded: the whole take smoothed, or of several people
    /// all together, and pulses found by their whole shape.
    static ProcessRequest accurateRequest(const std::string& take_path);
    /// Processes a take of the session as a job; shows the new run when the take is open.
    Job* process(ProcessRequest request);
    /// One after the other, so that all that waits holds no other work up.
    void processInTurn(std::vector<ProcessRequest> requests);

public slots:
    void say(const QString& sentence) { emit said(sentence); }
    void goTo(noctule::ui::Step step) { emit stepRequested(step); }
    /// Three seconds of standing still, then back to Record.
    void checkSuit() { emit checkRequested(); }

signals:
    void stepRequested(noctule::ui::Step step);
    void checkRequested();
    void checkedChanged();
    void bodyLoaded();  ///< or not; once
    /// A sentence for the status bar.
    void said(const QString& text);
    /// Something failed: what happened, and what to do.
    void failed(const QString& what, const QString& remedy);
    /// Nothing failed, but it should be known: whole sentences.
    void warned(const QString& what);

private:
    StudioParts parts_;
    QSettings settings_;
    Jobs jobs_;
    TimeCursor time_;
    Selection selection_;
    SessionModel session_;
    ShownBody shown_body_;
    TakeDocument take_;
    TakeChanges changes_;
    MarkerEditor markers_;
    ContactEditor contacts_;
    SuitFinder finder_;
    LiveSuits suits_;
    VirtualSuit virtual_suit_, second_virtual_suit_;
    RemoteStart remote_start_;
    void openTakeUnderReview(int index);
    void loadBody();
    void connectSuits();
    void connectVirtualSuits();
    void followSuit(SuitInUse& worn);
    void followVirtualSuits();

    std::shared_ptr<const SkinnedMesh> body_;
    bool body_ended_ = false;  ///< loading it
    QPointer<Job> trying_;     ///< the virtual suit
    bool virtual_suit_ends_ = false, second_virtual_suit_ends_ = false, second_virtual_suit_waits_ = false;
    std::shared_ptr<std::timed_mutex> processing_;  ///< a take takes one writer, the machine one filter
};

}  // namespace noctule::ui

Q_DECLARE_METATYPE(noctule::ui::Step)
