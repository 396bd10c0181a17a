// SPDX-License-Identifier: Apache-2.0
#include "core/figure/up_axis.h"

#include <algorithm>
#include <cmath>

#include "core/figure/facing.h"
#include "core/math/order_statistics.h"
#include "core/math/rotation.h"

namespace noctule::figure {
namespace {

constexpr UpAxis kAxes[] = {UpAxis::kY,      UpAxis::kZ,      UpAxis::kX,
                            UpAxis::kMinusX, UpAxis::kMinusY, UpAxis::kMinusZ};

Vector3d directionOf(UpAxis axis) {
    switch (axis) {
        case UpAxis::kZ:
            return Vector3d::UnitZ();
        case UpAxis::kX:
            return Vector3d::UnitX();
        case UpAxis::kMinusX:
            return -Vector3d::UnitX();
        case UpAxis::kMinusY:
            return -Vector3d::UnitY();
        case UpAxis::kMinusZ:
            return -Vector3d::UnitZ();
        case UpAxis::kAuto:
        case UpAxis::kY:
            break;
    }
    return Vector3d::UnitY();
}

/// Trunk and legs in one line count fully; a crawling or sitting body hardly.
double standingWeight(const GlobalPose& pose, const JointMapping& mapping) {
    const double line = trunkOf(pose, mapping).normalized().dot(legsOf(pose, mapping).normalized());
    return std::clamp((line - 0.8) / 0.15, 0.0, 1.0);
}

double uprightness(const GlobalPose& pose, const JointMapping& mapping, const Vector3d& up) {
    return (trunkOf(pose, mapping).normalized() + legsOf(pose, mapping).normalized()).dot(up) / 2;
}

/// The zero pose seen as a pose; only a standing one tells where up is.
double zeroUprightness(const MotionClip& clip, const JointMapping& mapping, const Vector3d& up) {
    GlobalPose zero{zeroPositions(clip), {}};
    if (trunkOf(zero, mapping).norm() < 1e-9 || legsOf(zero, mapping).norm() < 1e-9 ||
        standingWeight(zero, mapping) < 0.5)
        return 0;
    return uprightness(zero, mapping, up);
}

/// 1 when the lowest joint stays at one height, 0 when it wanders by a fifth of the legs or more.
double floorEvidence(const SeenMotion& seen, const JointMapping& mapping, const Vector3d& up) {
    std::vector<double> lowest, legs;
    for (const GlobalPose& pose : seen.poses()) {
        double least = 1e300;
        for (const auto& [name, joint] : mapping)
            least = std::min(least, up.dot(pose.p_world_joint[static_cast<size_t>(joint)]));
        lowest.push_back(least);
        legs.push_back(legsOf(pose, mapping).norm());
    }
    std::sort(lowest.begin(), lowest.end());
    const size_t tenth = lowest.size() / 10;
    const double spread = lowest[lowest.size() - 1 - tenth] - lowest[tenth];
    return std::clamp(1 - spread / (0.2 * middleValue(legs)), 0.0, 1.0);
}

}  // namespace

Result<UpAxis> upAxisFromText(const std::string& text) {
    for (const auto& [word, axis] :
         {std::pair{"y", UpAxis::kY}, std::pair{"z", UpAxis::kZ}, std::pair{"auto", UpAxis::kAuto}})
        if (text == word)
            return axis;
    return Error{ErrorKind::kUsage, "'" + text + "' is no axis that can point up", "Give y, z or auto"};
}

std::string toText(UpAxis axis) {
    const Vector3d up = directionOf(axis);
    Eigen::Index largest = 0;
    up.cwiseAbs().maxCoeff(&largest);
    return std::string(up[largest] > 0 ? "+" : "-") + "XYZ"[largest];
}

UpAxisChoice judgeUpAxis(const SeenMotion& seen, const JointMapping& mapping, UpAxis axis) {
    UpAxisChoice choice{axis};
    const Vector3d up = directionOf(axis);
    double weights = 0, sum = 0;
    for (const GlobalPose& pose : seen.poses()) {
        const double standing = standingWeight(pose, mapping), weight = standing + 0.02;
        choice.standing += standing / static_cast<double>(seen.poses().size());
        weights += weight;
        sum += weight * uprightness(pose, mapping, up);
    }
    choice.upright = weights > 0 ? sum / weights : 0;
    return choice;
}

/// A figure that never stands (it crawls or lies throughout) shows its axis in the zero pose and the floor
/// alone. A zero pose that stands along Y in a file whose motion stands along Z is common: SMPL's.
UpAxisChoice findUpAxis(const MotionClip& clip, const SeenMotion& seen, const JointMapping& mapping) {
    constexpr double kZero = 0.5, kFloor = 0.4, kClearly = 0.3, kStands = 0.8, kRarely = 0.1;
    struct Judged {
        UpAxisChoice choice;
        double zero, score;
    };
    std::vector<Judged> judged;
    for (const UpAxis axis : kAxes) {
        const Vector3d up = directionOf(axis);
        const UpAxisChoice choice = judgeUpAxis(seen, mapping, axis);
        const double zero = zeroUprightness(clip, mapping, up);
        const double motion = choice.upright * (choice.standing < kRarely ? 0.5 : 1);
        judged.push_back({choice, zero, motion + kZero * zero + kFloor * floorEvidence(seen, mapping, up)});
    }
    const double y_score = judged[0].score;
    UpAxisChoice best = judged[0].choice;
    if (judged[1].score > y_score + kClearly)
        best = judged[1].choice;
    for (size_t a = 2; a < judged.size(); ++a) {
        const bool upside_down = best.axis == UpAxis::kY && judged[a].choice.axis == UpAxis::kMinusY;
        const bool stands = judged[a].choice.upright > kStands && judged[a].choice.standing > kRarely;
        const bool zero_agrees = judged[a].zero > kStands || (!upside_down && judged[a].zero == 0);
        if (stands && zero_agrees)
            best = judged[a].choice;
    }
    for (const Judged& other : judged)
        if (other.choice.axis != best.axis &&
            (other.zero > kStands ||
             (other.choice.upright > 0.5 && other.choice.upright > best.upright - kClearly)))
            best.doubtful = true;
    best.doubtful = best.doubtful || (best.axis != UpAxis::kY && best.axis != UpAxis::kZ);
    return best;
}

void turnUp(MotionClip& clip, UpAxis axis) {
    const Vector3d up = directionOf(axis);
    const Quaterniond turn = up.y() < -0.5 ? axisAngle(Vector3d::UnitZ(), std::numbers::pi)
                                           : smallestRotation(up, Vector3d::UnitY());
    for (Pose& pose : clip.frames) {
        pose.p_world_root = turn * pose.p_world_root;
        pose.q_parent_joint[0] = turn * pose.q_parent_joint[0];
    }
    for (std::vector<Vector3d>& places : clip.p_parent_joint_m)
        places[0] = turn * places[0];
}

}  // namespace noctule::figure
