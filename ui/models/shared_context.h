// SPDX-License-Identifier: Apache-2.0
// What every screen may need: the open session, jobs, preferences, the body that is drawn, and how to say
// something to the operator or to go to another page.
#pragma once

#include <QObject>
#include <QSettings>
#include <functional>
#include <memory>
#include <string>

#include "core/figure/understood_motion.h"
#include "core/mesh/skinned_mesh.h"
#include "ui/jobs/jobs.h"
#include "ui/models/session_model.h"
#include "ui/models/shown_body.h"

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

/// What a failure or a warning is about. It is told until that is tried anew, succeeds or is exchanged.
enum class About {
    kSession,  ///< that it is not saved, until it is saved again or another one is opened
    kTakes,    ///< the session's takes and settings, until one is changed, imported or moved anew
    kCapture,  ///< connecting suits and recording them, until either begins anew
    kSuit,     ///< the suit that is connected, until another one is or its calibration is exchanged
    kTake,     ///< the take under review, until another one is opened or a change is ordered
    kProcess,  ///< a take that is processed, until one is processed again or another one is opened
    kFile,     ///< a file that is written or read for the operator, until the next one
};

enum class Step { kStart, kConnect, kCalibrate, kRecord, kReview, kExport, kPerformer, kRobot };

class SharedContext : public QObject {
    Q_OBJECT
public:
    explicit SharedContext(StudioParts parts, QObject* parent = nullptr);
    ~SharedContext() override;

    const StudioParts& parts() const { return parts_; }
    QSettings& settings() { return settings_; }
    Jobs& jobs() { return jobs_; }
    SessionModel& session() { return session_; }
    ShownBody& shownBody() { return shown_body_; }
    /// The body that ships with the studio; null until a job of the start has loaded it, or when it cannot be
    /// read.
    std::shared_ptr<const SkinnedMesh> body() const { return body_; }
    /// What views of motions draw: that of the session, or the studio's own.
    BodyLook look() const { return {body_, shown_body_.worn(), shown_body_.blending()}; }
    /// Runs `act` as soon as loading the body has ended, at once when it has; not when `context` is gone.
    void whenBodyIsThere(QObject* context, std::function<void()> act);

    /// Where sessions are made unless the operator says otherwise.
    QString sessionsFolder() const;
    /// Of the open session, else the one where sessions are made.
    QString takesFolder() const;

public slots:
    void say(const QString& sentence) { emit said(sentence); }
    /// Of a file: that it is written or in use.
    void sayOfFile(const QString& sentence);
    void goTo(noctule::ui::Step step) { emit stepRequested(step); }
    /// Three seconds of standing still, then back to Record.
    void checkSuit() { emit checkRequested(); }

signals:
    void stepRequested(noctule::ui::Step step);
    void checkRequested();
    void bodyLoaded();  ///< or not; once
    /// A sentence for the status bar.
    void said(const QString& text);
    /// Something failed: what happened, and what to do.
    void failed(const QString& what, const QString& remedy, noctule::ui::About about);
    /// Nothing failed, but it should be known: whole sentences.
    void warned(const QString& what, noctule::ui::About about);
    /// A take cannot be opened since its database is torn. `why`: a sentence.
    void tornTake(const QString& path, const QString& why);
    /// What was told of it holds no longer.
    void settled(noctule::ui::About about);

private:
    void loadBody();

    StudioParts parts_;
    QSettings settings_;
    Jobs jobs_;
    SessionModel session_;
    ShownBody shown_body_;
    std::shared_ptr<const SkinnedMesh> body_;
    bool body_ended_ = false;  ///< loading it
};

}  // namespace noctule::ui

Q_DECLARE_METATYPE(noctule::ui::About)
Q_DECLARE_METATYPE(noctule::ui::Step)
