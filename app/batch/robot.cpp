// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>

#include "app/batch/files.h"
#include "app/batch/motion_file.h"
#include "app/batch/robot_profiles.h"
#include "app/batch/verb.h"
#include "core/body/actor.h"
#include "core/figure/our_frames.h"
#include "core/job/atomic_file.h"
#include "core/media/video_file.h"
#include "core/motion/timed_poses.h"
#include "core/processing/pose_runs.h"
#include "core/robot/command_files.h"
#include "core/robot/robot_report.h"
#include "core/robot/urdf_reader.h"
#include "core/robot_film/robot_film.h"
#include "core/robot_film/robot_mesh.h"

namespace noctule::batch {
namespace {

/// A take's poses without a rate of their own become commands so many times a second.
constexpr double kUsualRate_hz = 140;

bool isBvh(const std::string& path) {
    const std::string ending = std::filesystem::path(path).extension().string();
    return ending == ".bvh" || ending == ".BVH";
}

TimedMotion timed(const MotionClip& clip) {
    TimedMotion motion{clip.skeleton, {}};
    for (size_t i = 0; i < clip.frames.size(); ++i)
        motion.frames.push_back(
            {std::llround(static_cast<double>(i) * clip.frame_time_s * 1e9), clip.frames[i], {}});
    return motion;
}

Result<MotionClip> motionOfTake(const std::string& path, const std::string& run_name, double rate_hz) {
    const auto take = Take::open(path);
    if (!take)
        return take.error();
    const auto run = choosePoseRun(*take, run_name);
    if (!run)
        return run.error();
    const auto poses = take->poses(run->run);
    if (!poses)
        return poses.error();
    return toClip(takeName(path), *poses, rate_hz);
}

Result<MotionClip> motionFor(const VerbContext& context, const std::string& path) {
    const Arguments& arguments = context.arguments;
    const auto rate_hz = arguments.number("rate");
    if (!isBvh(path))
        return motionOfTake(path, arguments.text("run"), rate_hz.value_or(kUsualRate_hz));
    const auto understood = readUnderstood(path, arguments, context.console);
    if (!understood)
        return understood.error();
    const MotionClip clip =
        figure::inOurFrames(understood->clip, understood->joints, defaultActor().skeleton);
    if (!rate_hz || !clip.p_parent_joint_m.empty())
        return clip;
    return toClip(clip.name, timed(clip), *rate_hz);
}

robot::MappingChoice choiceFor(const Arguments& arguments) {
    robot::MappingChoice choice = partsChoice(arguments);
    const std::string mapping = arguments.text("mapping");
    choice.mapping = mapping == "miller"         ? robot::Mapping::kMiller
                     : mapping == "miller-trunk" ? robot::Mapping::kMillerTrunk
                                                 : robot::Mapping::kPosture;
    choice.legs = arguments.given("legs");
    return choice;
}

/// Many joints say the same; the first few tell it.
void tellNotices(Console& console, const std::string& path, const std::vector<std::string>& notices) {
    constexpr size_t kTold = 3;
    for (size_t i = 0; i < std::min(kTold, notices.size()); ++i)
        console.warn(path + ": " + notices[i]);
    if (notices.size() > kTold)
        console.warn(path + ": so for " + std::to_string(notices.size() - kTold) + " more; --json lists all");
}

nlohmann::json figuresJson(const std::vector<robot::ArmFigures>& figures) {
    nlohmann::json arms = nlohmann::json::array();
    for (const robot::ArmFigures& arm : figures)
        arms.push_back({{"arm", arm.arm},
                        {"upper_mean_deg", arm.upper_mean_deg},
                        {"upper_max_deg", arm.upper_max_deg},
                        {"forearm_mean_deg", arm.forearm_mean_deg},
                        {"forearm_max_deg", arm.forearm_max_deg},
                        {"wrist_mean_mm", arm.wrist_mean_mm},
                        {"wrist_max_mm", arm.wrist_max_mm},
                        {"limited_frames", arm.limited_frames}});
    return arms;
}

Outcome outcomeOf(const std::string& input, const robot::RobotModel& model,
                  const robot::RobotTrajectory& trajectory, const robot::LimitUse& use) {
    Outcome outcome{
        {{"motion", input},
         {"robot", model.name},
         {"joints", trajectory.joints},
         {"frames", trajectory.frames.size()},
         {"frame_time_s", trajectory.frame_time_s},
         {"arms", figuresJson(trajectory.arms)},
         {"held_frames", trajectory.held_frames},
         {"limit_use", {{"speed", use.speed}, {"acceleration", use.acceleration}, {"jerk", use.jerk}}},
         {"notices", model.notices}},
        input + " on robot " + model.name + ": " + std::to_string(trajectory.frames.size()) +
            " commands of " + std::to_string(trajectory.joints.size()) + " joints\n",
        std::nullopt};
    char line[300];
    for (const robot::ArmFigures& arm : trajectory.arms) {
        std::snprintf(
            line, sizeof line,
            "  %-6s upper arm %.1f deg, forearm %.1f deg, wrist %.1f mm in the mean; %d frames at a "
            "limit\n",
            arm.arm.c_str(), arm.upper_mean_deg, arm.forearm_mean_deg, arm.wrist_mean_mm, arm.limited_frames);
        outcome.text += line;
    }
    for (const robot::ArmFigures& leg : trajectory.legs) {
        std::snprintf(
            line, sizeof line,
            "  %-6s thigh %.1f deg, shank %.1f deg, ankle %.1f mm in the mean; %d frames at a limit\n",
            leg.arm.c_str(), leg.upper_mean_deg, leg.forearm_mean_deg, leg.wrist_mean_mm, leg.limited_frames);
        outcome.text += line;
    }
    if (!trajectory.legs.empty())
        outcome.json["legs"] = figuresJson(trajectory.legs);
    if (trajectory.held_frames > 0)
        outcome.text += "  " + std::to_string(trajectory.held_frames) +
                        " frames held: " + trajectory.nearest_parts + " would have come too near\n";
    if (!trajectory.loop_start_s.empty())
        outcome.json["loop_from_s"] = trajectory.loop_start_s.front();
    return outcome;
}

/// No command leaves this program that breaks a limit.
Status checkLimits(const robot::LimitUse& use) {
    if (use.place <= 1 && use.speed <= 1 + 1e-6 && use.acceleration <= 1 + 1e-6 && use.jerk <= 1 + 1e-6)
        return Done{};
    return Error{ErrorKind::kInternal, "the commands of joint \"" + use.joint + "\" break a limit",
                 "Report this with the URDF, the profile and the motion; nothing was written"};
}

Status writeCommands(const Arguments& arguments, const robot::RobotProfile& profile,
                     const robot::RobotTrajectory& trajectory) {
    const bool overwrite = arguments.given("overwrite");
    if (const std::string path = arguments.text("profile-out"); !path.empty())
        if (Status written = writeJson(path, robot::toJson(profile), overwrite); !written)
            return written;
    if (const std::string path = arguments.text("trajectory"); !path.empty())
        if (Status written = writeJson(path, robot::jointTrajectory(trajectory), overwrite); !written)
            return written;
    return writeFileAtomically(arguments.text("out"), robot::commandTable(trajectory), overwrite);
}

/// Absent: not asked for.
Status writeReport(const Arguments& arguments, const MotionClip& clip, const robot::RobotModel& model,
                   const robot::RobotProfile& profile, const robot::RobotTrajectory& trajectory) {
    const std::string path = arguments.text("report");
    if (path.empty())
        return Done{};
    const auto hands = robot::wristsOf(clip, model, profile, choiceFor(arguments), trajectory);
    if (!hands)
        return hands.error();
    robot::RobotReport report{clip.name + " on robot " + model.name,
                              "The commands keep the robot's limits of place, speed, acceleration and jerk.",
                              "the performer's wrist from the shoulder, in the robot's size",
                              "where the commands bring the robot's wrist",
                              *hands,
                              {}};
    report.facts = {
        {"Commands", std::to_string(trajectory.frames.size())},
        {"Joints", std::to_string(trajectory.joints.size())},
        {"Frames held, as parts would have come too near", std::to_string(trajectory.held_frames)}};
    return writeFileAtomically(path, robot::reportHtml(report), arguments.given("overwrite"));
}

/// Absent: not asked for.
Status writeFilm(const VerbContext& context, const MotionClip& clip, const robot::RobotModel& model,
                 const robot::RobotProfile& profile, const robot::RobotTrajectory& trajectory) {
    const std::string path = context.arguments.text("video");
    if (path.empty())
        return Done{};
    const robot::RobotLook look =
        robot::lookOf(model, profile, context.arguments.text("robot"), context.job());
    tellNotices(context.console, context.arguments.text("robot"), look.notices);
    const bool resamples = clip.p_parent_joint_m.empty();
    return robot::writeRobotFilm(
        path, resamples ? toClip(clip.name, timed(clip), FilmSettings().frames_per_second) : clip, model,
        profile, look.mesh, trajectory, context.arguments.given("overwrite"), context.job());
}

Status checkRobotOutputs(const Arguments& arguments) {
    const std::string video = arguments.text("video");
    if (!video.empty() && !isVideoFileName(video))
        return Error{ErrorKind::kUsage, video + ": films of this kind cannot be written",
                     "End its name with .mp4, .mkv or .avi"};
    return checkOutputs(arguments, {"out", "trajectory", "profile-out", "report", "video"});
}

Result<Outcome> runRobot(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    const std::string input = arguments.operands().front(), urdf = arguments.text("robot");
    if (Status fits = checkRobotOutputs(arguments); !fits)
        return fits.error();
    const auto model = robot::readUrdf(urdf, &context.cancel);
    if (!model)
        return model.error();
    tellNotices(context.console, urdf, model->notices);
    const auto profile = robotProfile(*model, arguments.text("profile"));
    if (!profile)
        return profile.error();
    const auto clip = motionFor(context, input);
    if (!clip)
        return clip.error();
    auto trajectory = robot::mapMotion(*clip, *model, *profile, choiceFor(arguments), context.job());
    if (!trajectory)
        return trajectory.error();
    const auto limits = robot::limitsOf(*model, *profile, *trajectory);
    if (!limits)
        return limits.error();
    if (arguments.given("loop"))
        if (Status closed = robot::closeLoop(*trajectory, *limits); !closed)
            return closed.error();
    const robot::LimitUse use = robot::limitUse(*trajectory, *limits);
    if (Status kept = checkLimits(use); !kept)
        return kept.error();
    if (Status written = writeCommands(arguments, *profile, *trajectory); !written)
        return written.error();
    if (Status written = writeReport(arguments, *clip, *model, *profile, *trajectory); !written)
        return written.error();
    if (Status written = writeFilm(context, *clip, *model, *profile, *trajectory); !written)
        return written.error();
    return outcomeOf(input, *model, *trajectory, use);
}

}  // namespace

Verb robotVerb() {
    Verb verb;
    verb.name = "robot";
    verb.summary = "commands for a robot's arms that follow a motion within the robot's limits";
    verb.operands = "T.noctule|M.bvh";
    verb.min_operands = verb.max_operands = 1;
    verb.example = "noctule --batch robot wave.noctule --robot g1.urdf --out wave.csv";
    verb.options = {
        inputFile("robot", "R.urdf", "the robot; a xacro file has to be expanded first").needed(),
        text("out", "C.csv", "the commands, a column per joint in rad or m").needed(),
        inputFile(
            "profile", "P.json",
            "how its arms answer to a performer's; else found by the robot's name, or made from the URDF"),
        text("profile-out", "P.json", "writes the profile that was used"),
        text("trajectory", "T.json", "the commands as a JointTrajectory of ROS"),
        text("report", "R.html", "the wrists asked for and commanded, in three views, and what is between"),
        text("video", "F", "a film of the performer and the robot beside: .mp4, .mkv or .avi"),
        choice("mapping", {"posture", "miller", "miller-trunk"},
               "posture and scaled wrist, or the angles of Miller 2004")
            .orElse("posture"),
        armsOption(),
        trunkOption(),
        flag("legs", "legs follow too, feet first: for robots that balance by themselves, and for films"),
        flag("loop", "goes back to the beginning, for playback without end"),
        number("rate", "HZ", 1, 1000, "commands a second; else 140, of BVH the file's rate"),
        text("run", "NAME", "which result of the take; else the last")};
    for (Option& option : motionOptions("motion"))
        verb.options.push_back(std::move(option));
    verb.remarks = {
        "Commands keep the limits of place and speed, and those of acceleration and jerk that the profile "
        "names. A limit that the URDF leaves out is assumed and said: check it before a robot moves.",
        "Arms brake when capsules around the robot's own parts come nearer than the profile's clearance."};
    verb.run = runRobot;
    return verb;
}

}  // namespace noctule::batch
