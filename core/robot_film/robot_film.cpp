// SPDX-License-Identifier: Apache-2.0
#include "core/robot_film/robot_film.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"
#include "core/mesh/mannequin/mannequin.h"
#include "core/render/body_scene.h"
#include "core/robot_film/robot_mesh.h"

namespace noctule::robot {
namespace {

constexpr Rgba kRobotColor{0.45F, 0.62F, 0.86F, 1};
constexpr double kApart_m = 0.25;  ///< between the performer's joints and the robot
constexpr size_t kMeasured = 24;   ///< frames in which what the robot fills is measured

/// The command of each frame of the clip; the last one stays.
size_t commandAt(const RobotTrajectory& commands, double time_s) {
    const double frame = std::round(time_s / commands.frame_time_s);
    return static_cast<size_t>(std::clamp(frame, 0.0, static_cast<double>(commands.frames.size() - 1)));
}

JointValues valuesOf(const RobotModel& model, const RobotTrajectory& commands, size_t frame) {
    JointValues values;
    for (size_t i = 0; i < commands.joints.size(); ++i)
        values[model.findJoint(commands.joints[i])] = commands.frames[frame][i];
    return values;
}

/// Both turned so that the performer faces the camera at first, as a robot that only stands there does.
void faceCamera(MotionClip& clip, RobotTrajectory& commands) {
    const auto performer = PerformerArms::make(clip.skeleton, clip.name);
    if (!performer || clip.frames.empty())
        return;
    const double heading_rad = performer->at(globalPose(clip, 0)).heading_rad;
    const Quaterniond back = axisAngle(Vector3d::UnitY(), -heading_rad);
    for (Pose& pose : clip.frames) {
        pose.p_world_root = back * pose.p_world_root;
        pose.q_parent_joint.front() = back * pose.q_parent_joint.front();
    }
    for (Eigen::Isometry3d& root : commands.root)
        root = back * root;
}

}  // namespace

FilmCompanion companionOf(const MotionClip& clip, const RobotModel& model, const RobotProfile& profile,
                          std::shared_ptr<const SkinnedMesh> mesh, const RobotTrajectory& commands) {
    require(!commands.frames.empty(), "companionOf() needs commands");
    const size_t step = std::max<size_t>(1, clip.frames.size() / kMeasured);
    Eigen::AlignedBox3d way, filled;
    std::vector<JointValues> values;
    std::vector<Eigen::Isometry3d> roots;
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        const size_t command = commandAt(commands, static_cast<double>(f) * clip.frame_time_s);
        values.push_back(valuesOf(model, commands, command));
        roots.push_back(commands.root.empty() ? standingRoot(model, profile, 0)
                                              : commands.root[std::min(command, commands.root.size() - 1)]);
        if (f % step != 0)
            continue;
        way.extend(placeBody(clip.skeleton, clip.frames[f], {}, nullptr).box());
        filled.extend(boxOf(model, profile, values.back(), roots.back()));
    }
    // It stands on the ground, or on a post that is not drawn when it has no legs.
    const Eigen::Translation3d place(way.max().x() + kApart_m - filled.min().x(), -filled.min().y(),
                                     way.center().z() - filled.center().z());
    FilmCompanion robot{std::move(mesh), {}, kRobotColor};
    for (size_t f = 0; f < values.size(); ++f)
        robot.skin.push_back(skinOf(model, *robot.mesh, values[f], place * roots[f]));
    return robot;
}

Status writeRobotFilm(const std::string& path, MotionClip clip, const RobotModel& model,
                      const RobotProfile& profile, std::shared_ptr<const SkinnedMesh> mesh,
                      RobotTrajectory commands, bool overwrite, const JobContext& job) {
    faceCamera(clip, commands);
    const MovingBody performer =
        MovingBody::ofOurs(makeMannequin(defaultActor()), clip.skeleton, feetAtRest(clip.skeleton));
    const FilmSubject subject{
        performer, clip, {}, companionOf(clip, model, profile, std::move(mesh), commands)};
    return writeFilm(path, subject, {}, overwrite, job);
}

}  // namespace noctule::robot
