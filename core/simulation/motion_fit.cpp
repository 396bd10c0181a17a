// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/motion_fit.h"

#include <algorithm>

#include "core/figure/measures.h"
#include "core/math/rotation.h"
#include "core/simulation/low_pass.h"
#include "core/simulation/motion_cleaning.h"
#include "core/simulation/source_figure.h"
#include "core/simulation/twist_continuity.h"

namespace noctule::simulation {
namespace {

/// Local rotations that bring the mover as near to the wanted orientations as its joints allow.
class FrameFitter {
public:
    FrameFitter(const SourceFigure& figure, const Skeleton& mover, double frame_time_s)
        : figure_(figure), mover_(mover), twists_(mover.joints().size()) {
        for (const Joint& joint : mover.joints())
            quality_.push_back({joint.name});
        noted_.assign(quality_.size(), 0);
        for (const std::string side : {"Left", "Right"})
            for (const auto& [segment, child] :
                 {std::pair{"UpLeg", "Leg"}, {"Leg", "Foot"}, {"Arm", "ForeArm"}, {"ForeArm", "Hand"}}) {
                const int upper = mover.find(side + segment), lower = mover.find(side + child);
                if (upper >= 0 && lower >= 0)
                    twists_[upper].emplace(mover.joint(lower).offset_m.normalized(), frame_time_s);
            }
    }

    Pose fit(const GlobalPose& source) {
        Pose pose = mover_.zeroPose();
        std::vector<Quaterniond> q_world(quality_.size());
        for (int j = 0; j < mover_.size(); ++j) {
            const Quaterniond q_world_parent =
                j == 0 ? Quaterniond::Identity() : q_world[mover_.joint(j).parent];
            std::optional<Quaterniond> wanted = figure_.target(j, source);
            if (wanted && twists_[j])
                wanted = twists_[j]->next(*wanted);
            if (wanted)
                pose.q_parent_joint[j] =
                    projectOntoJoint(mover_.joint(j), q_world_parent.conjugate() * *wanted, true)
                        .q_parent_joint;
            q_world[j] = (q_world_parent * pose.q_parent_joint[j]).normalized();
            if (wanted)
                note(j, angleBetween(*wanted, q_world[j]));
        }
        return pose;
    }

    std::vector<FitQuality> quality() const {
        std::vector<FitQuality> seen;
        for (size_t j = 1; j < quality_.size(); ++j)
            if (noted_[j] > 0 && mover_.joint(static_cast<int>(j)).type != JointType::kFixed) {
                seen.push_back(quality_[j]);
                seen.back().mean_rad /= noted_[j];
            }
        return seen;
    }

private:
    void note(int joint, double error_rad) {
        quality_[joint].mean_rad += error_rad;
        quality_[joint].max_rad = std::max(quality_[joint].max_rad, error_rad);
        ++noted_[joint];
    }

    const SourceFigure& figure_;
    const Skeleton& mover_;
    std::vector<FitQuality> quality_;
    std::vector<int> noted_;                              ///< frames per joint
    std::vector<std::optional<TwistContinuity>> twists_;  ///< of the limbs
};

/// Middle between the mover's thighs, in the root's frame.
Vector3d hipCentreOf(const Skeleton& mover) {
    const int left = mover.find("LeftUpLeg"), right = mover.find("RightUpLeg");
    if (left < 0 || right < 0)
        return Vector3d::Zero();
    return (mover.joint(left).offset_m + mover.joint(right).offset_m) / 2;
}

double legLength(const Skeleton& mover) {
    const int knee = mover.find("LeftLeg"), ankle = mover.find("LeftFoot");
    return knee < 0 || ankle < 0 ? 0 : mover.joint(knee).offset_m.norm() + mover.joint(ankle).offset_m.norm();
}

/// Rotation about the vertical that makes the root of a row face +Z.
Quaterniond towardsFront(const Coordinates& coordinates, const std::vector<double>& row) {
    const Vector3d forward = coordinates.toPose(row).q_parent_joint[0] * Vector3d::UnitZ();
    return axisAngle(Vector3d::UnitY(), -std::atan2(forward.x(), forward.z()));
}

/// Notes where the file has its figure: the fitted root stands beside the hips that were scaled with the
/// legs.
void noteStart(const Coordinates& coordinates, const Vector3d& hips_m, double scale, FittedMotion& fitted) {
    const Pose first = coordinates.toPose(fitted.rows[0]);
    const Vector3d forward = first.q_parent_joint[0] * Vector3d::UnitZ();
    fitted.start_yaw_rad = std::atan2(forward.x(), forward.z());
    fitted.start_m = first.p_world_root + (1 - scale) * hips_m;
    fitted.start_m.y() = 0;
}

/// Turns and shifts all rows: first frame above the origin facing +Z, feet on the floor. The floor is where
/// the lowest point is in the lowest twentieth of the frames: a figure that hops or falls still stands on it.
void placeOnFloor(const Coordinates& coordinates, std::vector<std::vector<double>>& rows) {
    const Quaterniond turn = towardsFront(coordinates, rows[0]);
    const Vector3d start(rows[0][0], 0, rows[0][2]);
    std::vector<double> lowest;
    for (std::vector<double>& row : rows) {
        Pose pose = coordinates.toPose(row);
        const Vector3d p = turn * (pose.p_world_root - start);
        const Quaterniond q = turn * pose.q_parent_joint[0];
        const double placed[7] = {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
        std::copy(placed, placed + 7, row.begin());
        lowest.push_back(lowestPoint(coordinates, row));
    }
    const auto twentieth = lowest.begin() + static_cast<std::ptrdiff_t>(lowest.size() / 20);
    std::nth_element(lowest.begin(), twentieth, lowest.end());
    for (std::vector<double>& row : rows)
        row[1] -= *twentieth;
}

void makeContinuous(const Coordinates& coordinates, std::vector<std::vector<double>>& rows) {
    for (size_t f = 1; f < rows.size(); ++f)
        coordinates.continueFrom(rows[f - 1], rows[f]);
}

/// Where a limb passes a pose that its two angles describe in two ways, the nearest angles jump from one to
/// the other: no motion either. They follow as fast as a person can turn a joint.
void limitAngleSpeed(const Coordinates& coordinates, double step_s, std::vector<std::vector<double>>& rows) {
    constexpr double kFastest_rad_per_s = 20;
    const double reach = kFastest_rad_per_s * step_s;
    for (int j = 1; j < coordinates.skeleton().size(); ++j)
        if (!coordinates.isQuaternion(j))
            for (size_t d = 0; d < coordinates.skeleton().joint(j).dof.size(); ++d) {
                const size_t column = static_cast<size_t>(coordinates.first(j)) + d;
                for (size_t f = 1; f < rows.size(); ++f)
                    rows[f][column] = rows[f - 1][column] +
                                      std::clamp(rows[f][column] - rows[f - 1][column], -reach, reach);
            }
}

}  // namespace

Result<Actor> actorFromClip(const MotionClip& clip, const std::optional<figure::JointMapping>& joints) {
    Result<figure::JointMapping> mapping = joints ? *joints : figure::mapJoints(clip);
    if (!mapping)
        return mapping.error();
    const BodyMeasures measures = figure::measure(clip, figure::SeenMotion(clip), *mapping);
    if (!(measures.height_m > 0.3 && measures.height_m < 4) || !(measures.trunk_m > 0))
        return Error{ErrorKind::kUnusable,
                     clip.name + ": its figure would be " + std::to_string(measures.height_m) + " m tall",
                     "Give the person's height with --height M, or the file's unit with --bvh-unit"};
    Actor actor = defaultActor(measures);
    actor.name = clip.name;
    return actor;
}

Actor freedActor(const Actor& actor) {
    std::vector<Joint> joints = actor.skeleton.joints();
    for (size_t j = 1; j < joints.size(); ++j) {
        joints[j].type = JointType::kBall;
        joints[j].dof = {{"x", Vector3d::UnitX()}, {"y", Vector3d::UnitY()}, {"z", Vector3d::UnitZ()}};
    }
    Actor freed = actor;
    freed.skeleton = Skeleton::make(std::move(joints)).value();
    return freed;
}

double lowestPoint(const Coordinates& coordinates, const std::vector<double>& row) {
    std::vector<Frame<double>> frames;
    coordinates.frames(row, frames);
    double lowest = frames[0].p.y();
    for (int j = 0; j < coordinates.skeleton().size(); ++j) {
        lowest = std::min(lowest, frames[j].p.y());
        if (const auto& end = coordinates.skeleton().joint(j).end_m)
            lowest = std::min(lowest, (frames[j].p + frames[j].r * *end).y());
    }
    return lowest;
}

Result<FittedMotion> fitMotion(const MotionClip& clip, const FitRequest& request) {
    Result<CleanedMotion> cleaned = cleanMotion(clip);
    if (!cleaned)
        return cleaned.error();
    Result<figure::JointMapping> mapping =
        request.joints ? *request.joints : figure::mapJoints(cleaned->clip);
    if (!mapping)
        return mapping.error();

    const SourceFigure figure(cleaned->clip, *mapping, request.actor.skeleton);
    const Coordinates coordinates(request.mover);
    FrameFitter fitter(figure, request.mover, clip.frame_time_s);
    const double scale = legLength(request.mover) / figure.legLength_m();
    FittedMotion fitted;
    fitted.step_s = clip.frame_time_s;
    fitted.repaired_frames = cleaned->repaired_frames;
    fitted.dropped_first_frame = cleaned->dropped_first_frame;
    for (size_t f = 0; f < cleaned->clip.frames.size(); ++f) {
        const GlobalPose source = globalPose(cleaned->clip, f);
        Pose pose = fitter.fit(source);
        pose.p_world_root =
            scale * figure.hipCentre(source) - pose.q_parent_joint[0] * hipCentreOf(request.mover);
        fitted.rows.push_back(coordinates.fromPose(pose));
    }
    fitted.quality = fitter.quality();
    if (fitted.rows.size() == 1)
        fitted.rows.push_back(fitted.rows[0]);
    makeContinuous(coordinates, fitted.rows);
    limitAngleSpeed(coordinates, fitted.step_s, fitted.rows);
    lowPassZeroPhase(fitted.rows, 1 / fitted.step_s, request.low_pass_hz);
    for (std::vector<double>& row : fitted.rows)
        coordinates.normalise(row);
    noteStart(coordinates, figure.hipCentre(globalPose(cleaned->clip, 0)), scale, fitted);
    placeOnFloor(coordinates, fitted.rows);
    makeContinuous(coordinates, fitted.rows);
    return fitted;
}

}  // namespace noctule::simulation
