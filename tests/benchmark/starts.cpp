// SPDX-License-Identifier: Apache-2.0
// Does the filter find the body when the performer does not hold the pose that was asked for? One simulated
// take (readings level, nominal, root given), started over and over with every joint turned about an axis
// drawn anew:
//
//     measure_starts [MOTION.bvh [SECONDS [STARTS [DEGREES [SEED]]]]]
//
// A start has converged when the mean error over all joints in the last second is below half a degree.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "core/live/motion_tracker.h"
#include "core/math/conventions.h"
#include "core/recording/take.h"
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

/// The take as any is processed, by a studio that takes the performer to hold `rest_pose`.
std::vector<TimedPose> trackedPoses(const Take& take, const Actor& actor, const Pose& rest_pose) {
    const double rate_hz = static_cast<double>(take.sampleRate_hz().value());
    const auto rest = take.restInterval().value();
    Actor believed = actor;
    believed.rest_q_parent_joint = rest_pose.q_parent_joint;
    TrackerSettings settings;
    settings.root_given = true;
    const auto tracker =
        MotionTracker::create(take.suit().value(), take.calibrationInForce().value().value, believed, rate_hz,
                              std::pair<int64_t, int64_t>(rest->first, rest->last), settings)
            .value();
    const std::vector<ExternalRootRow> roots = take.externalRoot().value();
    for (const ExternalRootRow& row : roots)
        tracker->add(RootMeasurement{1e-9 * static_cast<double>(row.time_ns), row.p_world_root,
                                     row.q_world_root, row.sigma_p_m, row.sigma_q_rad});
    auto ranges = take.ranges(kPrimaryRun).value();
    while (const auto range = ranges.next().value())
        tracker->add(*range);
    auto readings = take.readings(kPrimaryRun).value();
    int64_t last = 0;
    while (const auto reading = readings.next().value()) {
        tracker->add(*reading);
        last = static_cast<int64_t>(reading->sample);
    }
    tracker->advanceTo(last);
    return tracker->takePoses();
}

void measure(const std::string& motion, double seconds, int starts, double off_deg, uint64_t seed) {
    const std::string path =
        (std::filesystem::temp_directory_path() / ("starts_" + std::to_string(seed) + ".noctule")).string();
    const Scene scene = sceneOf(motion, seconds, 1, path);
    const Take take = Take::open(path).value();
    const auto error_deg = [&](const Pose& rest_pose) {
        return meanError_deg(scene, trackedPoses(take, scene.stage.actor, rest_pose),
                             scene.stage.world->duration_s() - 1);
    };
    std::printf("%s, %.0f s, %.1f s of them rest; from the pose as asked %.3f degrees\n", motion.c_str(),
                seconds, scene.rest_s(), error_deg(scene.stage.actor.restPose()));
    std::mt19937_64 random(seed);
    std::vector<double> errors;
    for (int i = 0; i < starts; ++i)
        errors.push_back(error_deg(turnedPose(scene, radians(off_deg), random)));
    std::filesystem::remove(path);
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
                     argc > 2 ? std::atof(argv[2]) : 7, argc > 3 ? std::atoi(argv[3]) : 1000,
                     argc > 4 ? std::atof(argv[4]) : 10, argc > 5 ? std::strtoull(argv[5], nullptr, 10) : 1);
    return 0;
}
