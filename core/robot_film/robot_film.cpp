// SPDX-License-Identifier: Apache-2.0
#include "core/robot_film/robot_film.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/mannequin.h"
#include "core/render/body_scene.h"
#include "core/robot_film/robot_mesh.h"

namespace noctule::robot {
namespace {

constexpr Rgba kRobotColor{0.45F, 0.62F, 0.86F, 1};
constexpr double kApart_m = 0.25;  ///< between the performer's joints and the robot
constexpr size_t kMeasured = 24;   ///< frames in which what the robot fills is measured

JointValues valuesAt(const RobotModel& model, const RobotTrajectory& commands, double time_s) {
    const double frame = std::round(time_s / commands.frame_time_s);
    const auto at =
        static_cast<size_t>(std::clamp(frame, 0.0, static_cast<double>(commands.frames.size() - 1)));
    JointValues values;
    for (size_t i = 0; i < commands.joints.size(); ++i)
        values[model.findJoint(commands.joints[i])] = commands.frames[at][i];
    return values;
}

}  // namespace

FilmCompanion companionOf(const MotionClip& clip, const RobotModel& model, const RobotProfile& profile,
                          const RobotTrajectory& commands) {
    require(!commands.frames.empty(), "companionOf() needs commands");
    const size_t step = std::max<size_t>(1, clip.frames.size() / kMeasured);
    Eigen::AlignedBox3d way, filled;
    std::vector<JointValues> values;
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        values.push_back(valuesAt(model, commands, static_cast<double>(f) * clip.frame_time_s));
        if (f % step != 0)
            continue;
        way.extend(placeBody(clip.skeleton, clip.frames[f], {}, nullptr).box());
        filled.extend(boxOf(model, profile, values.back()));
    }
    // It stands on the ground, or on a post that is not drawn when it has no legs.
    const Eigen::Translation3f place(static_cast<float>(way.max().x() + kApart_m - filled.min().x()),
                                     static_cast<float>(-filled.min().y()),
                                     static_cast<float>(way.center().z() - filled.center().z()));
    FilmCompanion robot{meshOf(model, profile), {}, kRobotColor};
    for (const JointValues& now : values) {
        robot.skin.push_back(skinOf(model, *robot.mesh, now, 0));
        for (Eigen::Matrix4f& bone : robot.skin.back())
            bone = place * bone;
    }
    return robot;
}

Status writeRobotFilm(const std::string& path, const MotionClip& clip, const RobotModel& model,
                      const RobotProfile& profile, const RobotTrajectory& commands, bool overwrite,
                      const JobContext& job) {
    const MovingBody performer =
        MovingBody::ofOurs(makeMannequin(defaultActor()), clip.skeleton, feetAtRest(clip.skeleton));
    const FilmSubject subject{performer, clip, {}, companionOf(clip, model, profile, commands)};
    return writeFilm(path, subject, {}, overwrite, job);
}

}  // namespace noctule::robot
