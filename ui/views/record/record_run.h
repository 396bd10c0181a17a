// SPDX-License-Identifier: Apache-2.0
// From pressing the record button to the take in Review: what stands in the way, the countdown and its tones,
// the take's name and shot, markers and notes while it runs, and what happens after it. What of it is a
// choice of the operator is remembered.
#pragma once

#include <QObject>
#include <QTimer>
#include <vector>

#include "ui/models/capture_context.h"
#include "ui/models/countdown.h"
#include "ui/models/transitions.h"

namespace noctule::ui {

/// Of the take that is being recorded.
struct TakeMark {
    enum class Kind { kMarker, kNote } kind = Kind::kMarker;
    double t_s = 0;
    QString text;
};

/// What keeps a take from being recorded now; empty text: nothing.
struct RecordObstacle {
    QString title, text;
    bool may_record_anyway = false;  ///< what is recorded then can still be used
    bool is_of_disk = false;         ///< the recorder would end at once: another folder helps
    explicit operator bool() const { return !title.isEmpty(); }
};

/// What a problem that hinders means for a take into `folder`.
RecordObstacle obstacleOf(const ReadinessProblem& problem, const SuitCheck& check, const QString& folder);

class RecordRun : public QObject {
    Q_OBJECT
public:
    enum class State { kNoSuit, kReady, kRefused, kCountdown, kRecording, kSaving };
    static std::span<const PhaseTransition<State>> transitions();

    explicit RecordRun(CaptureContext& capture, QObject* parent = nullptr);

    State state() const { return state_; }
    /// In kRefused, what stands in the way.
    const RecordObstacle& obstacle() const { return obstacle_; }
    /// Suits that a take records.
    int suitCount() const { return static_cast<int>(capture_.suits().connected().size()); }
    /// Begins, ends the countdown, or stops; refused it tells why.
    void press();
    /// As if nothing stood in the way, where that is safe.
    void recordAnyway();
    /// True when there was one.
    bool endCountdown();
    void stop();
    /// Another program begins a take now, without a countdown. An empty name: ours.
    void beginFromElsewhere(const QString& name, const QString& notes);
    /// Another program ends it.
    void stopFromElsewhere();

    double countdownLeft() const { return countdown_.left_s(); }
    int countdownSeconds() const { return countdown_.seconds(); }
    /// The take begins so long before the recording does; 0 where the suit allows none.
    int preRollSeconds() const { return canPreRoll() ? pre_roll_s_ : 0; }
    bool canPreRoll() const { return capture_.suits().canPreRoll(); }
    void setPreRollSeconds(int seconds);
    bool tones() const { return tones_; }
    void setTones(bool tones);
    bool opensReview() const { return opens_review_; }
    void setOpensReview(bool opens);

    /// "walk_003": of the take that runs, else of the one to come.
    QString takeName() const;
    /// What comes after takeName(); only while it runs.
    QString nextName() const;
    /// "walk" of anything typed; what cannot be part of a file's name becomes "_".
    void setName(const QString& typed);
    /// Index into the session's shot list, -1: none. Its first word names the takes.
    int shot() const { return shot_; }
    void setShot(int shot);

    /// Each does something only while a take runs.
    void addMarker();
    void addNote(const QString& text);
    const std::vector<TakeMark>& marks() const { return marks_; }

signals:
    void changed();
    /// 30 times a second while it counts or records.
    void ticked();
    void marksChanged();
    /// Somebody pressed the button, and the obstacle should be seen.
    void refused();

private:
    void follow();
    State stateNow() const;
    RecordObstacle obstacleNow() const;
    RecordObstacle obstacleOfSuit(const SuitInUse& worn) const;
    void beginOrCount();
    void beginOwn();
    /// Why it cannot begin; empty: it does.
    QString begin(const QString& base);
    void onStarted(const QString& take);
    void onEnded(const QString& take, const QString& trouble);
    void followSession();
    void chooseDueShot();
    void applyShot(int shot);
    /// Heard with one's back to the screen.
    void cue(const QString& words) const { Countdown::cue(words, tones_); }

    CaptureContext& capture_;
    State state_ = State::kNoSuit;
    int suits_ = 0;  ///< connected, when this was told last
    RecordObstacle obstacle_;
    Countdown countdown_;
    int pre_roll_s_;
    bool tones_, opens_review_;
    QString base_, running_;
    QString told_notes_;  ///< by another program, for the take that begins
    int shot_ = -1;
    bool without_shot_ = false;  ///< the operator wants it so
    std::vector<TakeMark> marks_;
    int markers_ = 0;
    QTimer tick_;
};

}  // namespace noctule::ui
