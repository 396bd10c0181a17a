// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/robot_drive.h"

#include <QPointer>

#include "core/body/actor.h"
#include "core/robot/saved_profile.h"
#include "core/robot/urdf_reader.h"
#include "core/robot_film/robot_mesh.h"
#include "devices/machine/clock.h"
#include "ui/language/core_words.h"
#include "ui/robot/robot_running.h"
#include "ui/robot/robot_words.h"

namespace noctule::ui {
namespace {

constexpr int kTick_ms = 33;
constexpr int64_t kSilentFor_ns = 300'000'000;
constexpr double kBridge_s = 1;  ///< between the end of a motion and its beginning
constexpr size_t kMostSpells = 50;

QString wordsOfError(const Error& error) {
    return coreWords(error);
}

Result<std::shared_ptr<const RobotParts>> readParts(const RobotChoice& choice, const JobContext& job) {
    auto model = robot::readUrdf(choice.urdf.toStdString(), job.cancel);
    if (!model)
        return model.error();
    auto profile = robot::profileFor(*model, choice.profile.toStdString(), job.cancel);
    if (!profile)
        return profile.error();
    auto driven = robot::drivenParts(*model, *profile, choice.mapping());
    if (!driven)
        return driven.error();
    auto parts = std::make_shared<RobotParts>();
    parts->joints = driven->joints();
    parts->speeds = driven->speeds();
    for (const robot::Chain* chain : driven->chains())
        parts->axes.insert(parts->axes.end(), chain->joints().begin(), chain->joints().end());
    parts->mesh = robot::lookOf(*model, *profile, choice.urdf.toStdString(), job).mesh;
    parts->model = std::move(*model);
    parts->profile = std::move(*profile);
    parts->driven = std::move(*driven);
    return std::shared_ptr<const RobotParts>(std::move(parts));
}

robot_link::LinkOptions optionsOf(const RobotParts& parts) {
    robot_link::LinkOptions options;
    options.joints = parts.joints;
    for (const robot::RobotArm& arm : parts.driven.arms)
        options.arms.push_back(arm.profile.name);
    return options;
}

robot::JointVector valuesOf(const std::vector<double>& all, size_t first, int count) {
    robot::JointVector q(count);
    for (int i = 0; i < count; ++i)
        q[i] = all[first + static_cast<size_t>(i)];
    return q;
}

}  // namespace

RobotDrive::RobotDrive(Studio& studio, QObject* parent)
    : QObject(parent), studio_(studio), choice_(loadRobot(studio.settings())) {
    timer_.setInterval(kTick_ms);
    connect(&timer_, &QTimer::timeout, this, &RobotDrive::tick);
    studio.suits().follow(&LiveSuit::wearingChanged, this, [this] {
        if (leader_ == Leader::kSuit)
            restart();
    });
    studio.suits().follow(&LiveSuit::phaseChanged, this, &RobotDrive::followSuitsTake);
    connect(&studio.suits(), &LiveSuits::recordingEnded, this, [this] {
        if (const QString take = std::exchange(recorded_take_, QString()); !take.isEmpty())
            readRecorded(take);
    });
    const auto follow_take = [this] {
        if (leader_ == Leader::kTake)
            restart();
    };
    connect(&studio.take(), &TakeDocument::opened, this, follow_take);
    connect(&studio.take(), &TakeDocument::runsChanged, this, follow_take);
    connect(&studio.take(), &TakeDocument::motionChanged, this, [this] {
        if (leader_ == Leader::kTake && running_ && !running_->motion())
            restart();
    });
}

RobotDrive::~RobotDrive() {
    end();
}

void RobotDrive::setRobot(const RobotChoice& choice) {
    end();
    choice_ = choice;
    saveRobot(studio_.settings(), choice);
    parts_ = nullptr;
    spells_.clear();
    read(true);
    emit robotChanged();
}

void RobotDrive::removeRobot() {
    end();
    ++reading_;
    wants_link_ = false;
    choice_ = {};
    saveRobot(studio_.settings(), choice_);
    parts_ = nullptr;
    spells_.clear();
    setTrouble({});
    emit robotChanged();
}

void RobotDrive::read(bool connects) {
    wants_link_ = connects;
    setTrouble({});
    const int number = ++reading_;
    using Parts = std::shared_ptr<const RobotParts>;
    studio_.jobs().start<Parts>(
        tr("Reading the robot"),
        [choice = choice_](const JobContext& job) -> Result<Parts> { return readParts(choice, job); },
        [self = QPointer(this), number](Result<Parts> parts) -> QString {
            if (!self || self->reading_ != number)
                return {};
            if (!parts) {
                self->setTrouble(wordsOfError(parts.error()));
                return {};
            }
            self->parts_ = std::move(*parts);
            emit self->robotChanged();
            if (self->wants_link_)
                self->begin();
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void RobotDrive::connectRobot() {
    if (!hasRobot() || running_)
        return;
    if (!parts_)
        return read(true);
    begin();
}

void RobotDrive::disconnectRobot() {
    wants_link_ = false;
    setTrouble({});
    end();
    judge();
    emit linkChanged();
}

void RobotDrive::begin() {
    wants_link_ = true;
    const bool of_take = leader_ == Leader::kTake;
    const auto motion = of_take ? studio_.take().shownMotion() : nullptr;
    const bool has_motion = motion && !motion->frames.empty();
    // Without a suit nobody leads, but the robot is seen.
    const Actor& worn = studio_.suit().actor();
    const Actor actor = worn.skeleton.joints().empty() ? defaultActor() : worn;
    const Skeleton& skeleton = has_motion ? motion->skeleton : actor.skeleton;
    const QString where = of_take ? tr("The performer of the take") : tr("The performer");
    const auto performer = robot::PerformerArms::make(skeleton, where.toStdString());
    trouble_is_leaders_ = !performer;
    if (!performer)
        return setTrouble(wordsOfError(performer.error()));
    auto link = robot_link::makeInterface(choice_.address.toStdString(), optionsOf(*parts_));
    if (!link)
        return setTrouble(wordsOfError(link.error()));
    robot::DriveSettings settings;
    settings.follows_posture = choice_.follows_posture;
    settings.teleop.farthest_rad = choice_.accept_within_rad;
    RobotRunning::Plan plan{parts_,       std::move(*link), skeleton, *performer,
                            std::nullopt, repeats_,         settings, choice_.speed};
    if (has_motion)
        plan.motion = repeats_ ? robot_link::joinedEnds(*motion, kBridge_s) : *motion;
    setTrouble({});
    moments_.clear();
    table_.clear();
    running_ = std::make_unique<RobotRunning>(std::move(plan));
    running_->setKeys(dead_man_, clutch_);
    if (!of_take) {
        led_by_ = &studio_.suit();
        led_by_->setPoseListener([feed = &running_->feed()](const TimedPose& pose, int64_t arrived_ns) {
            feed->put(pose, arrived_ns);
        });
    }
    timer_.start();
    followSuitsTake();
    tick();
}

/// The robot gets no command any more and holds by its own watchdog.
void RobotDrive::end() {
    timer_.stop();
    endRecording();
    if (LiveSuit* suit = std::exchange(led_by_, nullptr))
        suit->setPoseListener({});
    running_.reset();
    dead_man_ = clutch_ = false;
    emit keysChanged();
}

void RobotDrive::restart() {
    if (running_) {
        end();
        begin();
    } else if (std::exchange(trouble_is_leaders_, false)) {
        setTrouble({});  // another one leads, or another take
    }
    emit leaderChanged();
}

void RobotDrive::setLeader(Leader leader) {
    if (leader == leader_)
        return;
    leader_ = leader;
    restart();
}

QString RobotDrive::whyNoLeader() const {
    if (leader_ == Leader::kTake)
        return studio_.take().isOpen() && studio_.take().shownRun() >= 0
                   ? QString()
                   : tr("No take with a motion is open. Open one in Review.");
    if (studio_.suit().phase() == LiveSuit::Phase::kNone)
        return tr("No suit is connected. Connect one, or let a take lead.");
    return studio_.suit().canMoveBody()
               ? QString()
               : tr("The suit is not calibrated: its poses would mislead the robot.");
}

void RobotDrive::setPlaying(bool playing) {
    if (running_ && running_->motion())
        running_->motion()->setPlaying(playing);
    emit leaderChanged();
}

bool RobotDrive::isPlaying() const {
    return running_ && running_->motion() && running_->motion()->isPlaying();
}

void RobotDrive::setRepeats(bool repeats) {
    if (repeats == repeats_)
        return;
    repeats_ = repeats;
    if (leader_ == Leader::kTake)
        restart();
    else
        emit leaderChanged();
}

void RobotDrive::pass() {
    if (running_)
        running_->setKeys(dead_man_, clutch_);
    emit keysChanged();
}

void RobotDrive::setDeadMan(bool held) {
    if (held == dead_man_)
        return;
    dead_man_ = held && running_;
    pass();
}

void RobotDrive::setClutch(bool in) {
    if (in == clutch_)
        return;
    clutch_ = in && running_;
    pass();
}

void RobotDrive::hold() {
    dead_man_ = clutch_ = false;
    pass();
}

void RobotDrive::accept() {
    if (running_)
        running_->press(&robot::TeleopKeys::accept);
}

void RobotDrive::stop() {
    if (running_)
        running_->press(&robot::TeleopKeys::stop);
    hold();
}

void RobotDrive::reset() {
    if (running_)
        running_->press(&robot::TeleopKeys::reset);
}

void RobotDrive::setSpeed(double share) {
    choice_.speed = std::clamp(share, 0.05, 1.0);
    saveRobot(studio_.settings(), choice_);
    if (running_)
        running_->setSpeed(choice_.speed);
}

RobotDrive::Link RobotDrive::link() const {
    if (!running_)
        return Link::kOff;
    const robot_link::LinkStatus status = running_->status();
    if (!status.state)
        return Link::kConnecting;
    return steadyNow_ns() - status.state_arrived_ns > kSilentFor_ns ? Link::kSilent : Link::kAnswers;
}

robot_link::LinkStatus RobotDrive::linkStatus() const {
    return running_ ? running_->status() : robot_link::LinkStatus{};
}

void RobotDrive::setTrouble(const QString& trouble) {
    if (trouble == trouble_)
        return;
    trouble_ = trouble;
    emit linkChanged();
}

void RobotDrive::tick() {
    if (!running_)
        return;
    RobotRunning::News news = running_->take();
    for (RobotMoment& moment : news.moments)
        moments_.push_back(std::move(moment));
    while (!moments_.empty() && moments_.front().time_s < moments_.back().time_s - kShown_s)
        moments_.pop_front();
    table_.append(news.rows.data(), static_cast<int>(news.rows.size()));
    if (leader_ == Leader::kTake && isPlaying() && !moments_.empty())
        studio_.time().setTime(moments_.back().pose_time_s);
    if (news.end) {
        disconnectRobot();
        return setTrouble(wordsOfError(*news.end));
    }
    judge();
    if (const Link now = link(); now != told_link_) {
        told_link_ = now;
        emit linkChanged();
    }
    emit ticked();
}

void RobotDrive::judge() {
    const auto [word, reason] =
        running_ && !moments_.empty()
            ? wordFor(moments_.back().output, {dead_man_, clutch_, choice_.accept_within_rad})
            : std::pair{RobotWord::kNotSynchronised, QString()};
    const QDateTime now = QDateTime::currentDateTime();
    const bool is_new = word != word_ || reason != reason_ || spells_.empty();
    if (!spells_.empty())
        spells_.back().seconds = static_cast<double>(spells_.back().since.msecsTo(now)) * 1e-3;
    if (!is_new)
        return;
    word_ = word;
    reason_ = reason;
    spells_.push_back({word, reason, now, 0});
    if (spells_.size() > kMostSpells)
        spells_.erase(spells_.begin());
    emit wordChanged();
}

RobotDrive::HandPaths RobotDrive::handPaths(size_t arm) const {
    HandPaths paths;
    if (!parts_ || arm >= parts_->driven.arms.size())
        return paths;
    size_t first = 0;
    for (size_t i = 0; i < arm; ++i)
        first += static_cast<size_t>(parts_->driven.arms[i].chain.size());
    const robot::RobotArm& shown = parts_->driven.arms[arm];
    const Matrix3d R_body_base = shown.profile.R_base_body.transpose();
    robot::ChainState state;
    const auto add = [&](const std::vector<double>& q, double time_s, std::vector<robot::PathPoint>& path) {
        shown.chain.forward(valuesOf(q, first, shown.chain.size()), state);
        path.push_back({time_s, R_body_base * state.p_base_tip});
    };
    for (const RobotMoment& moment : moments_) {
        add(moment.output.q, moment.time_s, paths.commanded);
        const bool is_news = paths.achieved.empty() || moment.actual_time_s > paths.achieved.back().time_s;
        if (!moment.actual.empty() && is_news)
            add(moment.actual, moment.actual_time_s, paths.achieved);
    }
    paths.tracking = robot::trackingOf(paths.commanded, paths.achieved);
    return paths;
}

QByteArray RobotDrive::table() const {
    return table_;
}

}  // namespace noctule::ui
