// SPDX-License-Identifier: Apache-2.0
// The suit that is connected: its link, what it shows now, and the recording of takes into the session. What
// stands between two takes is a stream without a take, begun by itself: it lets the health be seen.
// On the interface's thread; nothing here waits for the device, the disk or the filter.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <memory>
#include <mutex>
#include <optional>

#include "devices/live/live_group.h"
#include "ui/jobs/jobs.h"
#include "ui/models/session_model.h"
#include "ui/models/transitions.h"
#include "ui/models/wearing.h"

namespace noctule::ui {

class LiveSuit : public QObject {
    Q_OBJECT
public:
    enum class Phase {
        kNone,  ///< no device
        kConnecting,
        kReady,     ///< greeted; no stream
        kLooking,   ///< a stream without a take: health, levels, live body
        kStarting,  ///< a take begins
        kRecording,
        kSaving,   ///< stopped; the take becomes one file
        kRefused,  ///< for good; see status()->trouble
    };
    static std::span<const PhaseTransition<Phase>> transitions();
    struct TakePlan {
        QString base_name;      ///< "walk": walk_001, walk_002, ...
        QString shot;           ///< of the shot list; empty: none
        double rest_s = 0;      ///< the performer begins in the rest pose
        double pre_roll_s = 0;  ///< so much of what was seen before stands in the take
        /// Of a room, of several suits: who began it shows it. It is neither processed nor opened in Review.
        bool is_survey = false;
    };
    /// What a calibration works on: the seconds before `seen_sample` of what is looked at, as a short take of
    /// its own. However late it is kept, it begins there.
    struct EvidencePlan {
        int64_t seen_sample = 0;  ///< LiveFrame::sample
        QString base_name;        ///< "accelerometers_1"
        std::string kind;         ///< of the take: level, turntable, jig, motion
        double length_s = 0;
        QString placement;  ///< of a jig: marked over the whole length
        double rest_s = 0;  ///< so long before seen_sample the rest pose is held; marked
    };
    struct Surroundings {
        std::string software;
        std::function<std::string()> utc_now;
    };

    LiveSuit(Jobs& jobs, SessionModel& session, Surroundings surroundings, QObject* parent = nullptr);
    ~LiveSuit() override;

    Phase phase() const { return phase_; }
    const QString& address() const { return address_; }
    /// An earlier connection to this address is still being closed; the next one waits for it.
    bool isClosing(const QString& address) const { return closing_.contains(address); }
    /// The suit that is connected goes first. `known`: beforehand; of the virtual suit.
    void connectTo(const QString& address, const KnownWearing& known = {});
    /// A take that is being recorded ends intact first.
    void disconnectSuit();

    /// Never null; of kNone an empty one.
    std::shared_ptr<const SessionStatus> status() const;
    /// The link is broken: frame() is the last one before.
    bool isLost() const { return status()->link == LinkState::kLost; }
    /// No sound arrives: the link is broken or stalls. frame() is the last one before.
    bool isSilent() const { return isLost() || status()->link == LinkState::kStalled; }
    /// Of the driver box; empty before it has told it.
    QString serial() const;
    /// The newest live frame; null without a stream or when nothing is processed. Its poses are true only
    /// with a calibration().
    std::shared_ptr<const LiveFrame> frame() const { return frame_; }
    /// Of the take being recorded.
    std::optional<RecorderState> recording() const;
    double recordedSeconds() const;
    /// Of the stream or take that began last, processed or not, on its clock.
    int64_t reachedSample() const { return live_ ? live_->reachedSample() : 0; }
    link::LinkStatistics link() const;
    /// As it is worn: the performer's suit where the serial numbers agree, else as the box says.
    const Suit& suit() const { return wearing_.suit; }
    const Actor& actor() const { return wearing_.actor; }
    const Wearing& wearing() const { return wearing_; }
    /// What poses and distances are made with; absent: none fits, then nothing is processed but health.
    const std::optional<Calibration>& calibration() const { return known_.calibration; }
    /// Poses mean something. Without distances, or with rates that drift by tens of degrees a second, they
    /// would only mislead.
    bool canMoveBody() const;
    void setCalibration(std::optional<Calibration> calibration);
    /// Back to what came with connectTo(); of the virtual suit that is exact.
    void takeOwnCalibration();
    /// Gets every pose at once, on the thread that makes it, with the time at which its data came
    /// (std::chrono::steady_clock, ns). Null: nobody. When this returns the earlier one is called no more.
    void setPoseListener(PoseListener listener);
    /// The calibration came with connectTo(), and nothing has moved since.
    bool isKnownExactly() const { return known_.calibration && is_own_ && known_.is_exact; }
    /// Boards slipped or were exchanged: a check may find something.
    void noteWornOtherwise();
    const KnownWearing& known() const { return known_; }

    /// Begins a take in the session's folder; without a session one is made by date. In words why not, else
    /// empty.
    QString record(const TakePlan& plan);
    /// Whether a take can begin before it is asked for: not when each stream begins in the rest pose, as the
    /// virtual suit's do.
    bool canPreRoll() const { return known_.rest_s == 0; }
    void stopRecording();
    /// Of the take being recorded: where a robot's rows go.
    std::optional<LiveSession::TakeInput> takeInput() const {
        return live_ && phase_ == Phase::kRecording ? live_->takeInput() : std::nullopt;
    }
    /// Keeps what was seen just now; evidenceRecorded() comes when it is on disk. In words why not, else
    /// empty.
    QString keepEvidence(const EvidencePlan& plan);
    /// Second of the take that it stands at.
    double addMarker(const QString& label);
    void addNote(const QString& text);
    /// Who wears it; empty: the session's current performer.
    void setPerformer(const QString& name);

    /// Lends the session for a take of several suits (live_suits.h): nothing begins by itself until
    /// takeBack(). What runs ends first, see isAtRest().
    void lend();
    bool isLent() const { return is_lent_; }
    bool isAtRest() const { return !working_; }
    std::shared_ptr<LiveSession> session() const { return live_; }
    /// How it is worn, for the take of several.
    GroupSuit groupSuit() const;
    /// What the take of several does: kRecording or kSaving.
    void followTake(Phase phase, const QString& take_name);
    /// `recorded`: its part of the take; absent: no take came to be.
    void takeBack(const std::optional<RecorderState>& recorded);
    /// Why no take can begin now, in words; empty: one can.
    QString whyNotRecord() const;
    /// Lights a board's lamp, or lets a source sound by itself for some seconds. Nothing happens to a board
    /// that is unplugged.
    void blinkBoard(int board);
    /// As the box says; true where it does not tell.
    bool isPlugged(int board) const;
    /// Whose lamp is lit by blinkBoard(); -1: none.
    int blinkingBoard() const { return blinking_; }
    void playSource(int source);

signals:
    void phaseChanged();
    /// status(), link() or recording() may differ; at most 10 times a second.
    void statusChanged();
    /// At most 60 times a second, and only when there is a new one.
    void frameChanged();
    /// suit(), actor() or calibration() differ.
    void wearingChanged();
    /// The poses of frame() begin anew, at the origin.
    void streamBegan();
    void blinkingChanged();
    void recordingStarted(const QString& take_name);
    /// Over and saved; the take is in the session's list. `trouble` is empty when the operator stopped it.
    void recordingEnded(const QString& take_name, const QString& trouble);
    /// The take is whole, but has no poses yet: the live view could not keep up.
    void posesMissing(const QString& take_name);
    void evidenceRecorded(const QString& path, const QString& trouble);
    void failed(const QString& what, const QString& remedy);
    /// Nothing failed, but it should be known: whole sentences.
    void warned(const QString& what);
    /// It is lent, and the operator wants it to be disconnected: the take should end.
    void leaveWanted();

private:
    void look();
    void lookAtFrame();
    void lookAtStatus();
    void followLink();
    void setPhase(Phase phase);
    void endBlinking();
    void wear();
    StreamRequest requestOf(const std::optional<TakePlan>& plan) const;
    StreamRequest requestOf(const EvidencePlan& plan) const;
    void evidenceEnded(const StreamResult& result);
    std::optional<link::Settings> settings() const;
    void begin(const std::optional<TakePlan>& plan);
    void begun(bool of_take, bool in_midst, const std::optional<Error>& trouble);
    Phase phaseWithoutTake() const;
    void endTake();
    void ended(const StreamResult& result, bool unasked);
    void release();

    Jobs& jobs_;
    SessionModel& session_;
    const Surroundings surroundings_;
    struct PoseTap {
        std::mutex mutex;
        PoseListener listener;
    };
    std::shared_ptr<PoseTap> pose_tap_ = std::make_shared<PoseTap>();  ///< of streams that still end, too
    std::shared_ptr<LiveSession> live_;
    int connection_ = 0;   ///< what jobs of an earlier one bring is void
    QStringList closing_;  ///< addresses of earlier ones that jobs still close
    QString address_, next_address_;
    QString box_;  ///< serial number of the one that was connected there
    Phase phase_ = Phase::kNone;
    bool working_ = false;  ///< a job has the session
    bool is_lent_ = false;
    QString performer_;  ///< empty: the session's current one
    bool look_again_ = false, stop_wanted_ = false, leave_wanted_ = false, told_ = false;
    std::optional<TakePlan> next_take_;
    std::optional<int> lone_source_;
    bool sources_set_ = false;  ///< the box has not its own choice of sources
    Wearing wearing_;
    KnownWearing known_, next_known_;
    std::optional<Calibration> own_;  ///< that came with connectTo()
    bool is_own_ = true;              ///< known_.calibration is it
    std::shared_ptr<const SessionStatus> status_ = std::make_shared<const SessionStatus>();
    std::shared_ptr<const LiveFrame> frame_;
    std::optional<RecorderState> recorded_;  ///< as seen last
    QString take_name_;
    QTimer timer_, lone_timer_, blink_timer_;
    int blinking_ = -1;
    int looks_ = 0;
    QElapsedTimer since_trouble_;
};

}  // namespace noctule::ui
