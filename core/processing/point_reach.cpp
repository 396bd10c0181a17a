// SPDX-License-Identifier: Apache-2.0
#include "core/processing/point_reach.h"

#include <algorithm>

namespace noctule {
namespace {

/// The joints from a segment's own up to the root's.
std::vector<int> upwards(const Skeleton& skeleton, int joint) {
    std::vector<int> path;
    for (; joint >= 0; joint = skeleton.joint(joint).parent)
        path.push_back(joint);
    return path;
}

}  // namespace

std::vector<std::vector<cooperative::Reach>> pointReaches(const Actor& actor,
                                                          const std::vector<WornPoint>& points) {
    const Skeleton& skeleton = actor.skeleton;
    const std::vector<Vector3d> joints_m = globalPose(skeleton, actor.restPose()).p_world_joint;
    std::vector<std::vector<cooperative::Reach>> reaches(points.size(),
                                                         std::vector<cooperative::Reach>(points.size()));
    for (size_t a = 0; a < points.size(); ++a)
        for (size_t b = 0; b < points.size(); ++b) {
            std::vector<int> up = upwards(skeleton, skeleton.find(points[a].segment)),
                             down = upwards(skeleton, skeleton.find(points[b].segment));
            if (up.empty() || down.empty())
                continue;
            int shared = -1;
            for (; !up.empty() && !down.empty() && up.back() == down.back(); up.pop_back(), down.pop_back())
                shared = up.back();
            if (shared < 0)
                continue;
            // What is left are the joints that turn between both points.
            std::vector<Vector3d> way_m{points[a].rest_m};
            for (const int joint : up)
                way_m.push_back(joints_m[static_cast<size_t>(joint)]);
            for (auto joint = down.rbegin(); joint != down.rend(); ++joint)
                way_m.push_back(joints_m[static_cast<size_t>(*joint)]);
            way_m.push_back(points[b].rest_m);
            double sum_m = 0, longest_m = 0;
            for (size_t k = 1; k < way_m.size(); ++k) {
                sum_m += (way_m[k] - way_m[k - 1]).norm();
                longest_m = std::max(longest_m, (way_m[k] - way_m[k - 1]).norm());
            }
            reaches[a][b] = {std::max(0.0, 2 * longest_m - sum_m), sum_m};
        }
    return reaches;
}

}  // namespace noctule
