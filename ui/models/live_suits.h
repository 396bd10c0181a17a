// SPDX-License-Identifier: Apache-2.0
// The suits that are connected, each worn by a performer of its own, and the one of them that is looked at.
// One suit alone records by itself (live_suit.h). Several record together into one take
// (devices/live/live_group.h), to which they lend their sessions meanwhile. On the interface's thread.
#pragma once

#include <QDateTime>
#include <QPointer>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

#include "core/body/floor_move.h"
#include "devices/live/record_take.h"
#include "ui/models/calibration_shelf.h"
#include "ui/models/live_suit.h"
#include "ui/models/storage.h"
#include "ui/models/suit_check.h"

namespace noctule::ui {

/// The last check of a suit that is connected, with the calibration in force.
struct CheckedSuit {
    QDateTime when;
    bool is_good = false;
};

/// A suit with what is judged and kept of it. Not connected it is free for the next one.
struct SuitInUse {
    SuitInUse(Jobs& jobs, SessionModel& session, const LiveSuit::Surroundings& surroundings,
              std::function<std::optional<double>()> storage_left_s, const QString& suits_folder)
        : suit(jobs, session, surroundings),
          check(suit, std::move(storage_left_s)),
          calibrations(session, suit, suits_folder) {}

    LiveSuit suit;
    SuitCheck check;
    CalibrationShelf calibrations;
    std::optional<CheckedSuit> checked;
    /// Connected while another one was: worn by a performer of its own, not the session's current one.
    bool is_beside = false;
    int performer = -1;  ///< of the session, where `is_beside`
    /// Where its live body is shown (place_reset.h); another one for each stream.
    std::shared_ptr<FloorMove> floor = std::make_shared<FloorMove>();
};

class LiveSuits : public QObject {
    Q_OBJECT
public:
    static constexpr int kMost = 5;
    using Phase = LiveSuit::Phase;
    struct Folders {
        std::function<QString()> takes;  ///< where takes would go
        QString suits;                   ///< where calibrations of suits are kept beyond sessions
    };

    LiveSuits(Jobs& jobs, SessionModel& session, LiveSuit::Surroundings surroundings, Folders folders,
              QObject* parent = nullptr);

    /// Always there; not connected: none is.
    SuitInUse& current() { return *current_; }
    const SuitInUse& current() const { return *current_; }
    /// By the operator; refused() where the guard objects.
    void setCurrent(SuitInUse& worn);
    /// Asked, while `owner` lives, before the operator looks at another suit: why that cannot be now, else
    /// empty.
    void setChoiceGuard(QObject* owner, std::function<QString()> why_not);
    /// In the order in which they stand in a take.
    std::vector<SuitInUse*> connected() const;
    bool areSeveral() const { return connected().size() > 1; }
    bool isFull() const { return connected().size() >= kMost; }
    /// Null: no suit is connected there.
    SuitInUse* at(const QString& address) const;
    /// The suit of the box with this serial number, where its link is broken; else null.
    SuitInUse* lost(const QString& serial) const;
    /// One more beside those that are connected; it is looked at then, unless the guard objects.
    void add(const QString& address, const KnownWearing& known = {});
    /// Who wears it: "Ada"; without a session "Performer 2"; "Room" of anchors that nobody wears.
    QString nameOf(const SuitInUse& worn) const;
    /// 0 for A.
    int letterOf(const SuitInUse& worn) const;
    /// Who wore it before gets the other's suit.
    void setPerformer(SuitInUse& worn, const QString& name);
    /// Why those that are connected cannot be recorded together: two on one carrier, one box twice.
    std::optional<Error> whyNotTogether() const;
    void setChecked(SuitInUse& worn, const std::optional<CheckedSuit>& checked);

    // A take of all that are connected.

    /// kNone to kRefused as of the suit that is looked at; of a take as of all.
    Phase phase() const;
    bool isTakeOpen() const;
    /// Why those that are connected cannot begin a take together, in words; empty: they can.
    QString whyNotRecord() const;
    /// In words why not, else empty.
    QString record(const LiveSuit::TakePlan& plan);
    /// Of the take that runs, or ran last.
    bool isSurvey() const { return plan_.is_survey; }
    void stopRecording();
    bool canPreRoll() const { return !areSeveral() && current_->suit.canPreRoll(); }
    /// Of the suit that has most.
    double recordedSeconds() const;
    /// Of the suit that has least on the disk, of those whose sound flows.
    struct OnDisk {
        std::optional<RecorderState> recorder;
        int sample_rate_hz = 0;
    };
    OnDisk onDisk() const;
    StorageWatch& storage() { return storage_; }
    /// Of the sound of all that are connected; without one of the usual suit.
    double bytesPerSecond() const;
    /// Of the sound that arrives from all of them; absent until it was measured of each that sends.
    std::optional<double> measuredBytesPerSecond() const;
    /// How long all of them can be recorded, while they are at the rate so far; absent: not known.
    std::optional<double> storageLeft_s() const;
    /// Second of the take that it stands at. It is with the first performer, where readers look for it.
    double addMarker(const QString& label);
    void addNote(const QString& text);

    /// Connects to a signal of whichever suit is looked at; `slot` is called, too, when another one is.
    template <class Source, class Receiver, class Slot>
    void follow(void (Source::*signal)(), Receiver* receiver, Slot slot) {
        const auto call = [=] {
            if constexpr (std::is_member_function_pointer_v<Slot>)
                (receiver->*slot)();
            else
                slot();
        };
        forEach(receiver, [this, signal, receiver, call](SuitInUse& worn) {
            connect(&partOf<Source>(worn), signal, receiver, [this, &worn, call] {
                if (&worn == current_)
                    call();
            });
        });
        connect(this, &LiveSuits::currentChanged, receiver, call);
    }
    /// For each suit that there is and that comes, as long as `owner` lives.
    void forEach(QObject* owner, std::function<void(SuitInUse&)> act);

signals:
    void currentChanged();
    void refused(const QString& why);  ///< to look at another suit
    /// Which are connected, who wears them, how they fare.
    void changed();
    void recordingStarted(const QString& take_name);
    /// Over and saved, as LiveSuit::recordingEnded().
    void recordingEnded(const QString& take_name, const QString& trouble);
    void posesMissing(const QString& take_name);
    /// A take of several is saved; it holds no poses yet, and can be processed. Not told of a survey's.
    void takeOfSeveral(const QString& path);
    void checkedChanged();
    void failed(const QString& what, const QString& remedy);
    void warned(const QString& what);

private:
    template <class Part>
    static Part& partOf(SuitInUse& worn) {
        if constexpr (std::is_same_v<Part, LiveSuit>)
            return worn.suit;
        else if constexpr (std::is_same_v<Part, SuitCheck>)
            return worn.check;
        else
            return worn.calibrations;
    }
    SuitInUse& make();
    void lookAt(SuitInUse& worn);
    void followPhase(SuitInUse& worn);
    void assignPerformers();
    void assignPerformer(SuitInUse& worn);
    bool isWornByAnother(const SuitInUse& worn, const std::string& performer) const;
    std::string nameInTake(const SuitInUse& worn) const;
    // live_suits_take.cpp
    void lookAtTake();
    void beginTake();
    GroupRequest requestOf(const LiveSuit::TakePlan& plan) const;
    void takeBegun(const Result<std::vector<std::string>>& begun);
    void endTake();
    void takeEnded(const GroupReport& report, bool unasked);
    void giveBack();

    Jobs& jobs_;
    SessionModel& session_;
    const LiveSuit::Surroundings surroundings_;
    const Folders folders_;
    StorageWatch storage_;
    std::vector<std::unique_ptr<SuitInUse>> all_;
    SuitInUse* current_ = nullptr;
    QPointer<QObject> guard_;
    std::function<QString()> why_not_other_;
    struct Follower {
        QPointer<QObject> owner;
        std::function<void(SuitInUse&)> act;
    };
    std::vector<Follower> followers_;

    Phase take_phase_ = Phase::kNone;   ///< of a take of several; kNone: there is none
    std::vector<SuitInUse*> recorded_;  ///< by it
    LiveSuit::TakePlan plan_;           ///< of the take that began last
    std::shared_ptr<LiveGroup> group_;  ///< null: it waits until all suits are at rest
    bool stop_wanted_ = false;
    QString take_name_;
    QTimer timer_;
};

}  // namespace noctule::ui
