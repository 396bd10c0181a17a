// SPDX-License-Identifier: Apache-2.0
// The robot of the studio: which it is, its link, who leads it, the operator's keys, and what it did in the
// last seconds. Driving runs in a thread of its own, with the same loop as the verb `drive`; nothing here
// waits for the robot.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QTimer>
#include <deque>
#include <memory>

#include "core/robot/live_drive.h"
#include "core/robot/tracking.h"
#include "devices/robot/drive_recorder.h"
#include "devices/robot/robot_interface.h"
#include "ui/models/studio.h"
#include "ui/robot/robot_choice.h"

namespace noctule::ui {

/// A robot that has been read.
struct RobotParts {
    robot::RobotModel model;
    robot::RobotProfile profile;
    robot::DrivenParts driven;
    std::vector<std::string> joints;      ///< in the order of commands
    std::vector<robot::ChainJoint> axes;  ///< likewise, with their limits
    std::vector<double> speeds;           ///< rad/s, likewise
    std::shared_ptr<const SkinnedMesh> mesh;
};

/// One step of the drive; values in the order of RobotParts::joints.
struct RobotMoment {
    double time_s = 0;  ///< since the drive began
    robot::DriveOutput output;
    std::vector<double> actual;  ///< empty: the robot has not told yet
    double actual_time_s = 0;    ///< when it told
    double pose_time_s = 0;      ///< of the take or the suit
};

/// Always one of the four, in this order (style guide, section 9).
enum class RobotWord { kNotSynchronised, kReady, kFollowing, kHolding };

/// For so long the word was the same.
struct RobotSpell {
    RobotWord word = RobotWord::kNotSynchronised;
    QString reason;  ///< of kHolding
    QDateTime since;
    double seconds = 0;
};

class RobotRunning;

class RobotDrive : public QObject {
    Q_OBJECT
public:
    enum class Link { kOff, kConnecting, kAnswers, kSilent };
    enum class Leader { kSuit, kTake };

    explicit RobotDrive(Studio& studio, QObject* parent = nullptr);
    ~RobotDrive() override;

    bool hasRobot() const { return !choice_.isEmpty(); }
    const RobotChoice& choice() const { return choice_; }
    /// Null: none, or it is still being read, or it cannot be read.
    std::shared_ptr<const RobotParts> parts() const { return parts_; }
    /// Keeps the choice, reads the robot and connects. An earlier one is let go first.
    void setRobot(const RobotChoice& choice);
    void removeRobot();
    /// Reads the robot if that has not been done.
    void connectRobot();
    void disconnectRobot();
    /// What is wrong with the robot or its link: what happened, and what to do; empty: nothing.
    const QString& trouble() const { return trouble_; }

    Leader leader() const { return leader_; }
    void setLeader(Leader leader);
    /// Why nobody leads, in words; empty: somebody does.
    QString whyNoLeader() const;
    /// The take's motion goes on; it waits at its beginning until then.
    void setPlaying(bool playing);
    bool isPlaying() const;
    /// The take's motion is repeated, its end joined to its beginning.
    void setRepeats(bool repeats);
    bool repeats() const { return repeats_; }

    // The operator.
    void setDeadMan(bool held);
    bool deadMan() const { return dead_man_; }
    void setClutch(bool in);
    bool clutch() const { return clutch_; }
    void accept();
    void stop();
    void reset();
    void setSpeed(double share);
    /// Lets the dead man's key and the clutch go.
    void hold();

    Link link() const;
    robot_link::LinkStatus linkStatus() const;
    /// Of the last moment.
    RobotWord word() const { return word_; }
    /// "key released"; empty unless it holds.
    QString holdingReason() const { return reason_; }
    /// Newest last, of the last kShown_s; empty: nothing yet.
    const std::deque<RobotMoment>& moments() const { return moments_; }
    static constexpr double kShown_s = 8;
    /// Of the hand of the arm, in the axes of the chest (x left, y up, z ahead).
    struct HandPaths {
        std::vector<robot::PathPoint> commanded, achieved;
        std::optional<robot::Tracking> tracking;
    };
    HandPaths handPaths(size_t arm) const;

    /// Commands and the robot's states into a take: into the one that the suit records, by itself, or into
    /// the one in Review that leads.
    bool isRecording() const { return recorder_ != nullptr; }
    /// Why nothing can be recorded into the take in Review, in words; empty: it can.
    QString whyNotRecord() const;
    /// Into the take in Review.
    void setRecording(bool on);
    /// Of the first arm of the drive that was recorded last; no points: none in this session.
    const HandPaths& recordedPaths() const { return recorded_paths_; }
    const std::vector<RobotSpell>& spells() const { return spells_; }
    /// All commands and states since the drive began, as the verb `drive` writes them.
    QByteArray table() const;

signals:
    void robotChanged();      ///< choice or parts
    void linkChanged();       ///< link() or trouble()
    void ticked();            ///< moments(), at most 30 times a second
    void wordChanged();       ///< word() or holdingReason()
    void keysChanged();       ///< the operator's
    void leaderChanged();     ///< or what it plays
    void recordingChanged();  ///< isRecording() or recordedPaths()

private:
    void read(bool connects);
    void begin();
    void end();
    void restart();
    void tick();
    void judge();
    void setTrouble(const QString& trouble);
    void pass();
    void followSuitsTake();
    void beginRecording(std::unique_ptr<robot_link::DriveSink> sink, int64_t pose_origin_ns);
    void endRecording();
    void recorded(const robot_link::DriveRecord& record, const QString& take);
    void readRecorded(const QString& take);

    Studio& studio_;
    RobotChoice choice_;
    std::shared_ptr<const RobotParts> parts_;
    int reading_ = 0;  ///< what earlier readings bring is void
    QString trouble_;
    bool trouble_is_leaders_ = false;  ///< not the robot's
    LiveSuit* led_by_ = nullptr;       ///< has our listener
    Leader leader_ = Leader::kSuit;
    bool repeats_ = false, wants_link_ = false;
    bool dead_man_ = false, clutch_ = false;
    std::unique_ptr<RobotRunning> running_;
    std::deque<RobotMoment> moments_;
    QByteArray table_;
    RobotWord word_ = RobotWord::kNotSynchronised;
    QString reason_;
    std::vector<RobotSpell> spells_;
    Link told_link_ = Link::kOff;
    std::shared_ptr<robot_link::DriveRecorder> recorder_;
    HandPaths recorded_paths_;
    QString recorded_take_;  ///< of the suit, until it is saved
    QTimer timer_;
};

}  // namespace noctule::ui
