// SPDX-License-Identifier: Apache-2.0
// Does the filter find the body when the performer does not hold the pose that was asked for? One simulated
// take (readings level, nominal, root given), started over and over with every joint turned about an axis
// drawn anew:
//
//     measure_starts [MOTION.bvh [SECONDS [STARTS [DEGREES]]]]
//
// A start has converged when the mean error over all joints in the last second is below half a degree.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "core/math/conventions.h"
#include "tests/benchmark/run_scene.h"

namespace noctule {
namespace {

constexpr double kConverged_deg = 0.5;

/// Every joint but the root turned by `angle_rad`; hinges one way or the other.
Pose turnedPose(const Scene& scene, double angle_rad, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    MotionState state = scene.tree.stateFromPose(scene.stage.actor.restPose());
    Eigen::VectorXd turn = Eigen::VectorXd::Zero(scene.tree.freedoms());
    for (const Link& link : scene.tree.links()) {
        if (link.type == LinkType::kFree || link.count == 0)
            continue;
        Eigen::VectorXd axis(link.count);
        for (double& component : axis)
            component = normal(random);
        turn.segment(link.first, link.count) = angle_rad * axis.normalized();
    }
    scene.tree.retract(state, turn);
    return scene.tree.poseFromState(state);
}

void measure(const std::string& motion, double seconds, int starts, double off_deg) {
    const std::string path = (std::filesystem::temp_directory_path() / "starts.noctule").string();
    const Scene scene = sceneOf(motion, seconds, 1, path);
    std::filesystem::remove(path);
    ManifoldParameters parameters;
    parameters.root_given = true;
    const auto error_deg = [&](const Pose& rest_pose) {
        return meanError_deg(scene, estimatedPoses(scene, scene.instants, parameters, false, rest_pose),
                             static_cast<double>(scene.instants.size()) * kStep_s - 1);
    };
    std::printf("%s, %.0f s after %.1f s of rest; from the pose as asked %.3f degrees\n", motion.c_str(),
                seconds, scene.rest_s(), error_deg(scene.stage.actor.restPose()));
    std::mt19937_64 random(1);
    std::vector<double> errors;
    for (int i = 0; i < starts; ++i)
        errors.push_back(error_deg(turnedPose(scene, radians(off_deg), random)));
    std::ranges::sort(errors);
    const auto converged = std::ranges::lower_bound(errors, kConverged_deg) - errors.begin();
    std::printf(
        "%d starts, every joint %.0f degrees off: %.1f %% converged; median %.3f, 99th percentile %.3f, "
        "worst %.3f degrees\n",
        starts, off_deg, 100 * static_cast<double>(converged) / starts, errors[errors.size() / 2],
        errors[errors.size() * 99 / 100], errors.back());
}

}  // namespace
}  // namespace noctule

int main(int argc, char** argv) {
    noctule::measure(argc > 1 ? argv[1] : "/usr/share/assimp/models/BVH/01_01.bvh",
                     argc > 2 ? std::atof(argv[2]) : 8, argc > 3 ? std::atoi(argv[3]) : 1000,
                     argc > 4 ? std::atof(argv[4]) : 10);
    return 0;
}
