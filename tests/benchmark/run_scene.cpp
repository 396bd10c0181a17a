// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmark/run_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "core/estimation/smoothing_filter.h"
#include "core/motion/comparison.h"

namespace noctule {
namespace {

/// The means over the rest pose, and as surely as motion_tracker.cpp takes them.
RestReadings restReadings(const std::vector<Instant>& instants, double rest_s) {
    constexpr double kGyroFloor_rad_per_s = 0.0005, kAccelFloor_m_per_s2 = 0.01;
    RestReadings rest{rest_s / 2, rest_s, {}};  // at first the stream's codes have yet to reach the readings
    std::map<int, std::vector<const InertialMeasurement*>> by_board;
    for (size_t k = 0; static_cast<double>(k) * kStep_s <= rest_s; ++k)
        for (const InertialMeasurement& reading : instants[k].inertial)
            if (reading.time_s > rest.begin_s)
                by_board[reading.board].push_back(&reading);
    const auto add = [](TriadReading& mean, const TriadReading& reading, double count, double floor) {
        mean.count = reading.count;
        for (size_t i = 0; i < static_cast<size_t>(reading.count); ++i) {
            mean.axes[i].sensitive_axis_board = reading.axes[i].sensitive_axis_board;
            mean.axes[i].value += reading.axes[i].value / count;
            mean.axes[i].sigma = std::hypot(reading.axes[i].sigma / std::sqrt(count), floor);
        }
    };
    for (const auto& [board, readings] : by_board) {
        InertialMeasurement mean{board, rest_s, {}, {}};
        for (const InertialMeasurement* reading : readings) {
            add(mean.gyro, reading->gyro, static_cast<double>(readings.size()), kGyroFloor_rad_per_s);
            add(mean.accel, reading->accel, static_cast<double>(readings.size()), kAccelFloor_m_per_s2);
        }
        rest.mean_by_board.push_back(mean);
    }
    return rest;
}

}  // namespace

std::vector<TimedPose> estimatedPoses(const Scene& scene, const std::vector<Instant>& instants,
                                      const ManifoldParameters& parameters, bool smoothed) {
    const Skeleton& skeleton = scene.stage.actor.skeleton;
    std::unique_ptr<Estimator> estimator;
    if (smoothed)
        estimator = std::make_unique<FixedIntervalSmoother>(
            skeleton, scene.model, parameters,
            UnnamedFile::make(std::filesystem::temp_directory_path(), "the spool", "").value());
    else
        estimator = std::make_unique<ManifoldFilter>(skeleton, scene.model, parameters);
    const auto first = static_cast<size_t>(scene.rest_s() / kStep_s) + 1;
    const RootMeasurement* root = nullptr;
    for (size_t k = first; k < instants.size() && !root && parameters.root_given; ++k)
        if (!instants[k].roots.empty())
            root = &instants[k].roots.front();
    estimator->start(scene.stage.actor.restPose(), restReadings(instants, scene.rest_s()), root);
    std::vector<TimedPose> poses;
    const auto take = [&] {
        std::vector<TimedPose> more = estimator->takePoses();
        poses.insert(poses.end(), more.begin(), more.end());
    };
    for (size_t k = first; k < instants.size(); ++k) {
        for (const RootMeasurement& root_now : instants[k].roots)
            estimator->add(root_now);
        for (const InertialMeasurement& reading : instants[k].inertial)
            estimator->add(reading);
        for (const DistanceMeasurement& distance : instants[k].distances)
            estimator->add(distance);
        estimator->advanceTo(static_cast<double>(k) * kStep_s);
        estimator->takeDecisions();
        take();
    }
    while (estimator->portionsLeft() > 0) {
        estimator->finishPortion({}).value();
        take();
    }
    return poses;
}

double meanError_deg(const Scene& scene, std::vector<TimedPose> poses, double from_s) {
    std::ranges::sort(poses, {}, &TimedPose::time_ns);
    TimedMotion reference{scene.stage.actor.skeleton, {}};
    for (const TimedPose& pose : poses)
        reference.frames.push_back(
            {pose.time_ns,
             scene.stage.body->performance().pose(1e-9 * static_cast<double>(pose.time_ns)),
             {}});
    ComparisonOptions options;
    options.from_ns = static_cast<int64_t>(1e9 * std::max(from_s, scene.rest_s())) + 1;
    return compareMotions({scene.stage.actor.skeleton, std::move(poses)}, reference, options)
        .value()
        .mean_deg;
}

}  // namespace noctule
