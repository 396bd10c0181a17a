// SPDX-License-Identifier: Apache-2.0
#include "core/posing/root_place.h"

#include <cmath>

namespace noctule::posing {

namespace {

constexpr double kSoft_m = 0.008;    ///< points so little above the lowest share the weight
constexpr double kHeelShare = 0.35;  ///< of the foot's length, behind the ankle
constexpr double kSole_m = 0.06;     ///< below an ankle without toes

struct SolePoint {
    int joint;
    Vector3d p_joint_point_m;
};

std::vector<SolePoint> solePoints(const Skeleton& skeleton) {
    std::vector<SolePoint> points;
    for (const char* name : {"LeftFoot", "RightFoot"}) {
        const int foot = skeleton.find(name);
        if (foot < 0)
            continue;
        Vector3d ball = skeleton.joint(foot).end_m.value_or(Vector3d(0, -kSole_m, 2 * kSole_m));
        for (int j = foot + 1; j < skeleton.size(); ++j)
            if (skeleton.joint(j).parent == foot) {
                ball = skeleton.joint(j).offset_m;
                if (skeleton.joint(j).end_m)
                    points.push_back({j, *skeleton.joint(j).end_m});
                break;
            }
        points.push_back({foot, ball});
        points.push_back({foot, Vector3d(0, ball.y(), -kHeelShare * ball.z())});
    }
    if (points.empty())
        points.push_back({0, Vector3d::Zero()});
    return points;
}

}  // namespace

void placeRoot(const Skeleton& skeleton, std::vector<TimedPose>& poses) {
    const auto points = solePoints(skeleton);
    std::vector<Vector3d> before;
    Vector3d root = Vector3d::Zero();
    for (TimedPose& timed : poses) {
        if (!timed.pose)
            continue;
        timed.pose->p_world_root = Vector3d::Zero();
        const GlobalPose body = globalPose(skeleton, *timed.pose);
        std::vector<Vector3d> now;
        double lowest = 1e9;
        for (const SolePoint& point : points) {
            now.push_back(body.p_world_joint[size_t(point.joint)] +
                          body.q_world_joint[size_t(point.joint)] * point.p_joint_point_m);
            lowest = std::min(lowest, now.back().y());
        }
        Vector3d step = Vector3d::Zero();
        double weights = 0;
        for (size_t p = 0; p < now.size() && !before.empty(); ++p) {
            const double weight = std::exp(-(now[p].y() - lowest) / kSoft_m);
            step += weight * (before[p] - now[p]);
            weights += weight;
        }
        if (weights > 0)
            root += step / weights;
        root.y() = -lowest;
        timed.pose->p_world_root = root;
        before = std::move(now);
    }
}

}  // namespace noctule::posing
