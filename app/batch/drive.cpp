// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

#include "app/batch/drive_recording.h"
#include "app/batch/files.h"
#include "app/batch/operator_keys.h"
#include "app/batch/program.h"
#include "app/batch/robot_profiles.h"
#include "app/batch/verb.h"
#include "core/job/atomic_file.h"
#include "core/math/rotation.h"
#include "core/processing/pose_runs.h"
#include "core/robot/robot_report.h"
#include "core/robot/urdf_reader.h"
#include "devices/device/clock.h"
#include "devices/live/live_session.h"
#include "devices/robot/drive_loop.h"
#include "devices/robot/motion_poses.h"

namespace noctule::batch {
namespace {

constexpr std::chrono::milliseconds kLookAtDevice{20};
constexpr std::chrono::seconds kDeviceGreets{10}, kDeviceStops{6};

/// Poses that go into a feed, from a thread of their own.
class LivePoses {
public:
    virtual ~LivePoses() = default;
    virtual bool ended() const = 0;
    virtual std::optional<Error> trouble() const { return std::nullopt; }
    virtual void tell(nlohmann::json&) const {}
    /// Of a take that is being recorded.
    virtual std::optional<LiveSession::TakeInput> takeInput() const { return std::nullopt; }
    /// Ends the take that is being recorded, if there is one.
    virtual std::optional<StreamResult> endTake() { return std::nullopt; }
};

/// A take's poses at the times at which they were made.
class TakePoses : public LivePoses {
public:
    TakePoses(TimedMotion motion, robot_link::PoseFeed& feed, bool repeats)
        : poses_(std::move(motion), feed,
                 repeats ? robot_link::MotionPoses::AtEnd::kRepeats : robot_link::MotionPoses::AtEnd::kEnds,
                 true) {}
    bool ended() const override { return poses_.ended(); }

private:
    robot_link::MotionPoses poses_;
};

/// A suit that is worn right now.
class SuitPoses : public LivePoses {
public:
    explicit SuitPoses(std::unique_ptr<Device> device) : session_(std::move(device)) {}
    ~SuitPoses() override {
        session_.stop();
        session_.finish();
    }

    Status begin(const StreamRequest& request, const std::string& address, const JobContext& job) {
        session_.connect();
        const auto until = std::chrono::steady_clock::now() + kDeviceGreets;
        while (session_.status()->link != LinkState::kReady &&
               session_.status()->link != LinkState::kRefused && std::chrono::steady_clock::now() < until &&
               !job.cancelled())
            std::this_thread::sleep_for(kLookAtDevice);
        if (job.cancelled())
            return JobContext::cancelledError();
        const auto status = session_.status();
        if (status->link != LinkState::kReady)
            return status->trouble.value_or(
                Error{ErrorKind::kDevice, address + ": no driver box answers",
                      "Check that it is switched on and that the address is right"});
        if (Status begun = session_.begin(request); !begun)
            return begun;
        const auto trouble = session_.processingTrouble();
        return trouble ? Status(*trouble) : Status(Done{});
    }
    bool ended() const override { return !session_.status()->stream_is_open; }
    std::optional<Error> trouble() const override {
        const auto processing = session_.processingTrouble();
        return processing ? processing : session_.status()->trouble;
    }
    void tell(nlohmann::json& json) const override {
        if (const auto frame = session_.latest())
            json["poses"] = {{"count", frame->poses},
                             {"latency_median_ms", 1e3 * frame->latency_median_s},
                             {"latency_p999_ms", 1e3 * frame->latency_p999_s}};
    }

    std::optional<LiveSession::TakeInput> takeInput() const override { return session_.takeInput(); }
    std::optional<StreamResult> endTake() override {
        session_.stop();
        const auto until = std::chrono::steady_clock::now() + kDeviceStops;
        while (session_.status()->stream_is_open && std::chrono::steady_clock::now() < until)
            std::this_thread::sleep_for(kLookAtDevice);
        return session_.finish();
    }

private:
    mutable LiveSession session_;
};

/// The hands as they were told and as they went, for the report.
class HandRecord {
public:
    /// `arms` outlive it.
    explicit HandRecord(const std::vector<robot::RobotArm>& arms) : arms_(arms) {
        for (const robot::RobotArm& arm : arms)
            hands_.push_back({arm.profile.name, {}, {}});
    }
    void add(const robot_link::DriveMoment& moment) {
        const auto seconds = [&](int64_t steady_ns) {
            return static_cast<double>(steady_ns - moment.start_ns) * 1e-9;
        };
        const bool has_news = moment.link.state && moment.link.state_arrived_ns != last_state_ns_;
        size_t first = 0;
        for (size_t i = 0; i < arms_.size() && hands_[i].wanted.size() < kMostPoints; ++i) {
            hands_[i].wanted.push_back(
                {seconds(moment.now_ns), robot::tipInChest(arms_[i], moment.output.q, first)});
            if (has_news)
                hands_[i].reached.push_back({seconds(moment.link.state_arrived_ns),
                                             robot::tipInChest(arms_[i], moment.link.state->q, first)});
            first += static_cast<size_t>(arms_[i].chain.size());
        }
        if (has_news)
            last_state_ns_ = moment.link.state_arrived_ns;
    }
    const std::vector<robot::HandPair>& hands() const { return hands_; }

private:
    static constexpr size_t kMostPoints = 1'000'000;
    const std::vector<robot::RobotArm>& arms_;
    std::vector<robot::HandPair> hands_;
    int64_t last_state_ns_ = 0;
};

/// What is driven, and by whom.
struct DriveJob {
    robot::RobotModel model;
    robot::RobotProfile profile;
    std::vector<robot::RobotArm> arms;
    std::optional<TimedMotion> motion;
    std::optional<Actor> actor;
    std::optional<Calibration> calibration;
    Skeleton skeleton;
};

Status checkSourceOfPoses(const Arguments& arguments) {
    const bool from_take = !arguments.operands().empty();
    if (from_take == arguments.given("device"))
        return Error{ErrorKind::kUsage, "one source of poses is needed",
                     "Name a take, or give --device ADDRESS and --calibration C.json"};
    if (from_take && (arguments.given("calibration") || arguments.given("actor")))
        return Error{ErrorKind::kUsage, "--calibration and --actor belong to --device",
                     "Leave them out: the take has its own"};
    if (!from_take && (arguments.given("run") || arguments.given("repeat")))
        return Error{ErrorKind::kUsage, "--run and --repeat belong to a take", "Leave them out"};
    if (!from_take && !arguments.given("calibration"))
        return Error{ErrorKind::kUsage, "without a calibration a suit gives no poses",
                     "Give --calibration C.json"};
    return Done{};
}

Status readTake(const Arguments& arguments, DriveJob& drive) {
    const auto take = Take::open(arguments.operands().front());
    if (!take)
        return take.error();
    const auto run = choosePoseRun(*take, arguments.text("run"));
    if (!run)
        return run.error();
    auto poses = take->poses(run->run);
    if (!poses)
        return poses.error();
    if (poses->frames.empty())
        return Error{ErrorKind::kUnusable, arguments.operands().front() + ": its run has no poses",
                     "Process the take first"};
    drive.skeleton = poses->skeleton;
    drive.motion = std::move(*poses);
    return Done{};
}

Result<DriveJob> readDrive(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    DriveJob drive;
    const std::string urdf = arguments.text("robot");
    auto model = robot::readUrdf(urdf, &context.cancel);
    if (!model)
        return model.error();
    for (const std::string& notice : model->notices)
        if (!context.console.wantsJson())
            context.console.tell(urdf + ": " + notice);
    drive.model = std::move(*model);
    auto profile = robotProfile(drive.model, arguments.text("profile"));
    if (!profile)
        return profile.error();
    drive.profile = std::move(*profile);
    auto arms = robot::drivenArms(drive.model, drive.profile, armChoice(arguments.text("arms")));
    if (!arms)
        return arms.error();
    drive.arms = std::move(*arms);
    if (!arguments.operands().empty()) {
        const Status read = readTake(arguments, drive);
        return read ? Result<DriveJob>(std::move(drive)) : Result<DriveJob>(read.error());
    }
    if (Status read = readGiven(arguments, "actor", readActor, drive.actor); !read)
        return read.error();
    if (Status read = readGiven(arguments, "calibration", readCalibration, drive.calibration); !read)
        return read.error();
    drive.skeleton = (drive.actor ? *drive.actor : defaultActor()).skeleton;
    return drive;
}

Result<std::unique_ptr<LivePoses>> startPoses(const VerbContext& context, DriveJob& drive,
                                              robot_link::PoseFeed& feed) {
    const Arguments& arguments = context.arguments;
    if (drive.motion)
        return std::unique_ptr<LivePoses>(
            new TakePoses(std::move(*drive.motion), feed, arguments.given("repeat")));
    const std::string address = arguments.text("device");
    auto device = makeDevice(address);
    if (!device)
        return device.error();
    StreamRequest request;
    request.calibration = drive.calibration;
    request.actor = drive.actor;
    request.rest_s = *arguments.number("rest-seconds");
    request.software = softwareName();
    request.created_utc = utcNow();
    request.take = takeOfSuit(arguments);
    request.keep_results = request.take.has_value();
    request.pose_listener = [&feed](const TimedPose& pose, int64_t arrived_ns) {
        feed.put(pose, arrived_ns);
    };
    auto poses = std::make_unique<SuitPoses>(std::move(*device));
    if (Status begun = poses->begin(request, address, context.job()); !begun)
        return begun.error();
    return std::unique_ptr<LivePoses>(std::move(poses));
}

robot_link::LinkOptions linkOptionsOf(const Arguments& arguments, const DriveJob& drive) {
    robot_link::LinkOptions options;
    options.joints = robot::jointsOf(drive.arms);
    options.period_s = 1 / *arguments.number("rate");
    const std::string message = arguments.text("message");
    options.ros_command = message == "trajectory" ? robot_link::RosCommand::kJointTrajectory
                          : message == "pose"     ? robot_link::RosCommand::kPose
                                                  : robot_link::RosCommand::kJointState;
    options.command_topic = arguments.text("topic");
    options.state_topic = arguments.text("state-topic");
    for (const robot::RobotArm& arm : drive.arms)
        options.arms.push_back(arm.profile.name);
    return options;
}

robot::DriveSettings settingsOf(const Arguments& arguments) {
    robot::DriveSettings settings;
    settings.teleop.dt_s = 1 / *arguments.number("rate");
    settings.teleop.scale = *arguments.number("scale");
    settings.teleop.speed_scale = *arguments.number("speed");
    settings.teleop.farthest_rad = radians(*arguments.number("accept-within"));
    settings.follows_posture = arguments.text("follow") == "posture";
    return settings;
}

nlohmann::json handsJson(const std::vector<robot::HandPair>& hands) {
    nlohmann::json all = nlohmann::json::array();
    for (const robot::HandPair& hand : hands) {
        nlohmann::json one{{"arm", hand.arm}, {"tracking", nullptr}};
        if (const auto tracking = robot::trackingOf(hand.wanted, hand.reached))
            one["tracking"] = {{"delay_ms", 1e3 * tracking->delay_s},
                               {"apart_rms_mm", 1e3 * tracking->apart_rms_m},
                               {"rest_rms_mm", 1e3 * tracking->rest_rms_m},
                               {"rest_max_mm", 1e3 * tracking->rest_max_m},
                               {"points", tracking->points}};
        all.push_back(std::move(one));
    }
    return all;
}

nlohmann::json driveJson(const robot_link::DriveReport& report, const DriveJob& drive,
                         const std::string& to) {
    const LatencyHistogram& latency = report.link.latency;
    nlohmann::json json{{"robot", drive.model.name},
                        {"to", to},
                        {"joints", robot::jointsOf(drive.arms)},
                        {"commands", report.commands},
                        {"commands_following", report.following},
                        {"steps_skipped", report.skipped},
                        {"commands_dropped", report.link.dropped},
                        {"states", report.link.states},
                        {"messages_refused", report.link.refused_messages},
                        {"reconnections", report.link.reconnections},
                        {"largest_speed_use", report.largest_speed_use},
                        {"longest_hold_ms", 1e3 * report.longest_hold_s}};
    json["latency"] = {{"count", latency.count()},
                       {"median_ms", 1e3 * latency.quantile_s(0.5)},
                       {"p999_ms", 1e3 * latency.quantile_s(0.999)},
                       {"worst_ms", static_cast<double>(latency.worst_ns()) * 1e-6}};
    return json;
}

std::string driveText(const robot_link::DriveReport& report, const DriveJob& drive) {
    const LatencyHistogram& latency = report.link.latency;
    char text[300];
    std::snprintf(text, sizeof text,
                  ": %lld commands, %lld while following; from the arrival of data to the command %.1f ms in "
                  "the median, %.1f ms at 99.9 %%\n",
                  static_cast<long long>(report.commands), static_cast<long long>(report.following),
                  1e3 * latency.quantile_s(0.5), 1e3 * latency.quantile_s(0.999));
    return "robot " + drive.model.name + text;
}

Status writeDriveReport(const Arguments& arguments, const robot_link::DriveReport& report,
                        const DriveJob& drive, const HandRecord& record) {
    const LatencyHistogram& latency = report.link.latency;
    char quantiles[100];
    std::snprintf(quantiles, sizeof quantiles, "%.1f ms, %.1f ms", 1e3 * latency.quantile_s(0.5),
                  1e3 * latency.quantile_s(0.999));
    const robot::RobotReport page{"Robot " + drive.model.name + ", driven live",
                                  "Times are those at which commands were made and states arrived.",
                                  "the hand as it was commanded",
                                  "the hand as the robot tells it",
                                  record.hands(),
                                  {{"Commands", std::to_string(report.commands)},
                                   {"Commands while following", std::to_string(report.following)},
                                   {"Data to command: median, 99.9 %", quantiles}}};
    return writeFileAtomically(arguments.text("report"), robot::reportHtml(page),
                               arguments.given("overwrite"));
}

Result<Outcome> finishDrive(const VerbContext& context, const robot_link::DriveReport& report,
                            const DriveJob& drive, const LivePoses& poses, const HandRecord& record) {
    const Arguments& arguments = context.arguments;
    if (arguments.given("report"))
        if (Status written = writeDriveReport(arguments, report, drive, record); !written)
            return written.error();
    if (const std::string out = arguments.text("out"); !out.empty())
        if (Status written = writeFileAtomically(out, report.table, arguments.given("overwrite")); !written)
            return written.error();
    Outcome outcome{driveJson(report, drive, arguments.text("to")), driveText(report, drive), std::nullopt};
    outcome.json["hands"] = handsJson(record.hands());
    poses.tell(outcome.json);
    for (const std::optional<Error>& trouble : {poses.trouble(), report.link.trouble})
        if (trouble && !outcome.failure) {
            context.console.error(*trouble);
            outcome.json["error"] = errorJson(*trouble);
            outcome.failure = trouble;
        }
    return outcome;
}

RobotDriveRow driveRowOf(const Arguments& arguments, const DriveJob& drive) {
    RobotDriveRow row;
    row.created_utc = utcNow();
    row.software = softwareName();
    row.robot = drive.model.name;
    row.address = arguments.text("to");
    row.leader = arguments.operands().empty() ? "suit" : "take";
    row.rate_hz = *arguments.number("rate");
    row.joints = robot::jointsOf(drive.arms);
    for (const robot::RobotArm& arm : drive.arms)
        row.arms.push_back(arm.profile.name);
    return row;
}

/// Null: none is wanted.
Result<std::unique_ptr<DriveRecording>> startRecording(const Arguments& arguments, const DriveJob& drive,
                                                       const LivePoses& poses) {
    if (!arguments.given("record"))
        return std::unique_ptr<DriveRecording>();
    const std::string take = arguments.operands().empty() ? "" : arguments.operands().front();
    return DriveRecording::begin(driveRowOf(arguments, drive), drive.arms, take, poses.takeInput());
}

Status checkDrive(const Arguments& arguments) {
    if (Status source = checkSourceOfPoses(arguments); !source)
        return source;
    return checkDriveRecording(arguments);
}

Result<Outcome> runDriveVerb(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    if (Status source = checkDrive(arguments); !source)
        return source.error();
    if (Status fits =
            checkOutputs({arguments.text("out"), arguments.text("report")}, arguments.given("overwrite"),
                         {arguments.text("robot"), arguments.text("profile")});
        !fits)
        return fits.error();
    auto drive = readDrive(context);
    if (!drive)
        return drive.error();
    const auto performer = robot::PerformerArms::make(drive->skeleton, "the performer");
    if (!performer)
        return performer.error();
    const auto link = robot_link::makeInterface(arguments.text("to"), linkOptionsOf(arguments, *drive));
    if (!link)
        return link.error();
    // Before the suit begins: no take comes to be when no robot answers.
    if (Status answers = robot_link::awaitRobot(**link, context.job()); !answers)
        return answers.error();
    robot_link::PoseFeed feed(drive->skeleton, *performer);
    const auto poses = startPoses(context, *drive, feed);
    if (!poses)
        return poses.error();
    const auto recording = startRecording(arguments, *drive, **poses);
    if (!recording)
        return recording.error();
    OperatorKeys keys(arguments.given("hold"));
    HandRecord record(drive->arms);
    const robot_link::DrivePlan plan{
        **link,
        feed,
        drive->model,
        drive->profile,
        drive->arms,
        {performer->armLength_m(robot::Side::kLeft), performer->armLength_m(robot::Side::kRight)},
        settingsOf(arguments),
        arguments.number("seconds"),
        [&](const robot::DriveOutput&) {
            const robot::TeleopKeys pressed = keys.next();
            if (const std::string complaint = keys.takeComplaint(); !complaint.empty())
                context.console.warn(complaint);
            return pressed;
        },
        [&] { return (*poses)->ended(); },
        [&](const std::string& sentence) { context.console.tell(sentence); },
        arguments.given("out"),
        [&](const robot_link::DriveMoment& moment) {
            if (arguments.given("report") || context.console.wantsJson())
                record.add(moment);
            if (*recording)
                (*recording)->add(moment);
        },
        true};
    const auto report = robot_link::runDrive(plan, context.job());
    if (!report)
        return report.error();
    auto outcome = finishDrive(context, *report, *drive, **poses, record);
    if (outcome && *recording) {
        const robot_link::DriveRecord recorded = (*recording)->finish();
        tellRecording(context, recorded, (*poses)->endTake(), *outcome);
    }
    return outcome;
}

}  // namespace

Verb driveVerb() {
    Verb verb;
    verb.name = "drive";
    verb.summary = "drive a robot's arms live, with a suit or with a take in real time";
    verb.operands = "[T.noctule]";
    verb.max_operands = 1;
    verb.example = "noctule --batch drive wave.noctule --robot g1.urdf --to udp://127.0.0.1:41950 --hold";
    verb.options = {
        text("robot", "R.urdf", "the robot; a xacro file has to be expanded first").needed(),
        text("to", "ADDRESS", "the robot's interface: udp://HOST:PORT, or ws://HOST:PORT of a rosbridge")
            .needed(),
        text("device", "ADDRESS", "the suit: tcp://HOST:PORT, serial:///dev/ttyACM0 or replay:T.noctule"),
        text("calibration", "C.json", "of the suit"),
        text("actor", "A.json", "the performer who wears it"),
        number("rest-seconds", "S", 0, 3600, "the performer holds the rest pose so long at the beginning")
            .orElse("0"),
        text("run", "NAME", "which run of the take; else the last"),
        flag("repeat", "the take begins again after its end"),
        text("profile", "P.json",
             "how its arms answer to a performer's; else found by the robot's name, or made"),
        choice("arms", {"both", "left", "right"}, "which of the profile's arms are driven").orElse("both"),
        choice("follow", {"posture", "hand"}, "the arm's posture, or the hand's way from where it engaged")
            .orElse("posture"),
        flag("hold", "the dead man's key is held, and postures are accepted as soon as they are near"),
        number("accept-within", "DEG", 0.1, 180, "a joint farther from the performer is not accepted")
            .orElse("20"),
        number("speed", "SHARE", 0.01, 1, "of the joints' speed limits").orElse("1"),
        number("scale", "N", 0.05, 5, "of the hand's way, with --follow hand").orElse("1"),
        number("rate", "HZ", 10, 1000, "commands a second").orElse("140"),
        choice("message", {"joint-state", "trajectory", "pose"}, "what is published over rosbridge")
            .orElse("joint-state"),
        text("topic", "NAME", "where it is published; else one below /noctule"),
        text("state-topic", "NAME", "where the robot tells its joints").orElse("/joint_states"),
        number("seconds", "S", 0.1, 1e6, "how long; else to the end of the take or until Ctrl-C"),
        text("out", "C.csv", "commands and states with their times"),
        text("report", "R.html", "the hands commanded and achieved, in three views, with delay and rest")};
    for (Option& option : driveRecordingOptions())
        verb.options.push_back(std::move(option));
    verb.remarks = {
        "Without --hold, lines on standard input are the keys: engage, accept, release, stop, reset. The end "
        "of "
        "the input lets the dead man's key go.",
        "The robot holds when no fresh pose or no state of the robot comes for 0.1 s. A command is the last "
        "one "
        "and at most speed times period.",
        "A disk that is full or a take that another program holds never stops the robot; what could not be "
        "recorded is said at the end. `inspect` lists recorded drives, `export` writes them.",
        "Robots hurt people. Keep an emergency stop in reach that does not depend on this program."};
    verb.run = runDriveVerb;
    return verb;
}

}  // namespace noctule::batch
