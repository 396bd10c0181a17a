// SPDX-License-Identifier: Apache-2.0
#include "app/batch/devices/drive_outcome.h"
#include "app/batch/devices/drive_poses.h"
#include "app/batch/devices/drive_recording.h"
#include "app/batch/devices/operator_keys.h"
#include "app/batch/files.h"
#include "app/batch/program.h"
#include "app/batch/robot_profiles.h"
#include "app/batch/verb.h"
#include "core/job/atomic_file.h"
#include "core/math/rotation.h"
#include "core/processing/pose_runs.h"
#include "core/robot/urdf_reader.h"
#include "devices/machine/clock.h"
#include "devices/robot/drive_loop.h"

namespace noctule::batch {
namespace {

/// What is driven, and by whom.
struct DriveJob {
    robot::RobotModel model;
    robot::RobotProfile profile;
    robot::DrivenParts parts;
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
        return Error{ErrorKind::kUnusable, arguments.operands().front() + ": its result has no poses",
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
    auto parts = robot::drivenParts(drive.model, drive.profile, partsChoice(arguments));
    if (!parts)
        return parts.error();
    drive.parts = std::move(*parts);
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
        return posesOfTake(std::move(*drive.motion), feed, arguments.given("repeat"));
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
    return posesOfSuit(request, arguments.text("device"), context.job());
}

robot_link::LinkOptions linkOptionsOf(const Arguments& arguments, const DriveJob& drive) {
    robot_link::LinkOptions options;
    options.joints = drive.parts.joints();
    options.period_s = 1 / *arguments.number("rate");
    const std::string message = arguments.text("message");
    options.ros_command = message == "trajectory" ? robot_link::RosCommand::kJointTrajectory
                          : message == "pose"     ? robot_link::RosCommand::kPose
                                                  : robot_link::RosCommand::kJointState;
    options.command_topic = arguments.text("topic");
    options.state_topic = arguments.text("state-topic");
    for (const robot::RobotArm& arm : drive.parts.arms)
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

Result<Outcome> finishDrive(const VerbContext& context, const robot_link::DriveReport& report,
                            const RobotDriveRow& drive, const LivePoses& poses, const HandRecord& record) {
    const Arguments& arguments = context.arguments;
    if (arguments.given("report"))
        if (Status written =
                writeFileAtomically(arguments.text("report"), driveHtml(report, drive, record.hands()),
                                    arguments.given("overwrite"));
            !written)
            return written.error();
    if (const std::string out = arguments.text("out"); !out.empty())
        if (Status written = writeFileAtomically(out, report.table, arguments.given("overwrite")); !written)
            return written.error();
    Outcome outcome{driveJson(report, drive, record.hands()), driveText(report, drive), std::nullopt};
    poses.tell(outcome.json);
    for (const std::optional<Error>& trouble : {poses.trouble(), robotTrouble(report, drive.address)})
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
    row.joints = drive.parts.joints();
    for (const robot::RobotArm& arm : drive.parts.arms)
        row.arms.push_back(arm.profile.name);
    return row;
}

/// Null: none is wanted.
Result<std::unique_ptr<DriveRecording>> startRecording(const Arguments& arguments, const DriveJob& drive,
                                                       const LivePoses& poses) {
    if (!arguments.given("record"))
        return std::unique_ptr<DriveRecording>();
    const std::string take = arguments.operands().empty() ? "" : arguments.operands().front();
    return DriveRecording::begin(driveRowOf(arguments, drive), drive.parts.arms, take, poses.takeInput());
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
    if (Status fits = checkOutputs(arguments, {"out", "report"}); !fits)
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
    HandRecord record(drive->parts.arms);
    const robot_link::DrivePlan plan{
        **link,
        feed,
        drive->model,
        drive->profile,
        drive->parts,
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
    auto outcome = finishDrive(context, *report, driveRowOf(arguments, *drive), **poses, record);
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
    verb.summary = kDriveSummary;
    verb.operands = "[T.noctule]";
    verb.max_operands = 1;
    verb.example = "noctule --batch drive wave.noctule --robot g1.urdf --to udp://127.0.0.1:41950 --hold";
    verb.options = {
        inputFile("robot", "R.urdf", "the robot; a xacro file has to be expanded first").needed(),
        text("to", "ADDRESS", "the robot's interface: udp://HOST:PORT, or rosbridge://HOST:PORT (or ws://)")
            .needed(),
        text("device", "ADDRESS", "the suit: tcp://HOST:PORT, serial:///dev/ttyACM0 or replay:T.noctule"),
        inputFile("calibration", "C.json", "of the suit"),
        inputFile("actor", "A.json", "the performer who wears it"),
        number("rest-seconds", "S", 0, 3600, "the performer holds the rest pose so long at the beginning")
            .orElse("0"),
        text("run", "NAME", "which result of the take; else the last"),
        flag("repeat", "the take begins again after its end"),
        inputFile("profile", "P.json",
                  "how its arms answer to a performer's; else found by the robot's name, or made"),
        armsOption(),
        trunkOption(),
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
        "of the input lets the dead man's key go.",
        "The robot holds when no fresh pose or no state of the robot comes for 0.1 s. A command is the last "
        "one and at most speed times period.",
        "A disk that is full or a take that another program holds never stops the robot; what could not be "
        "recorded is said at the end. `inspect` lists recorded drives, `export` writes them.",
        "Legs are not driven: they keep the robot's balance, and that is its own controller's.",
        "Robots hurt people. Keep an emergency stop in reach that does not depend on this program."};
    verb.run = runDriveVerb;
    return verb;
}

}  // namespace noctule::batch
