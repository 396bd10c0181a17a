// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmark/bound_scene.h"

#include <algorithm>
#include <cmath>

#include "core/live/inertial_calibrator.h"
#include "core/math/rotation.h"
#include "core/recording/take.h"
#include "tests/benchmark/nominal_stage.h"

namespace noctule {
namespace {

constexpr double kDirect_m = 0.015;

/// Rotation and translation from one state to another, per coordinate, over the time between them.
Eigen::VectorXd meanRate(const KinematicTree& tree, const MotionState& from, const MotionState& to,
                         double dt_s) {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(tree.freedoms());
    for (size_t l = 0; l < tree.links().size(); ++l) {
        const Link& link = tree.links()[l];
        if (link.type == LinkType::kHinge) {
            change[link.first] = to.angle_rad[l] - from.angle_rad[l];
        } else if (link.count >= 3) {
            change.segment<3>(link.first + link.count - 3) =
                logQuaternion(from.q_parent_link[l].conjugate() * to.q_parent_link[l]);
            if (link.type == LinkType::kFree)
                change.segment<3>(link.first) = to.p_world_root - from.p_world_root;
        }
    }
    return change / dt_s;
}

/// True states of all steps, rates and accelerations by differences; the accelerations' process noise from
/// them.
void addTruth(Scene& scene) {
    const size_t steps = static_cast<size_t>(scene.stage.body->performance().duration_s() / kStep_s);
    scene.instants.resize(steps);
    for (size_t k = 0; k < steps; ++k) {
        BodyState& truth = scene.instants[k].truth;
        truth.motion =
            scene.tree.stateFromPose(scene.stage.body->performance().pose(static_cast<double>(k) * kStep_s));
        truth.gyro_bias.assign(scene.model.boards.size(), Vector3d::Zero());
        truth.accel_bias = truth.gyro_bias;
        truth.source_offset_m.assign(scene.model.sources.size(), 0.0);
    }
    const auto motion = [&](size_t k) -> MotionState& { return scene.instants[k].truth.motion; };
    for (size_t k = 1; k + 1 < steps; ++k)
        motion(k).rate = meanRate(scene.tree, motion(k - 1), motion(k + 1), 2 * kStep_s);
    for (size_t k = 2; k + 2 < steps; ++k)
        motion(k).accel = (motion(k + 1).rate - motion(k - 1).rate) / (2 * kStep_s);

    const Eigen::Index n = scene.tree.freedoms();
    Eigen::ArrayXd square = Eigen::ArrayXd::Zero(n), change = square;
    double count = 0;
    for (size_t k = static_cast<size_t>(scene.rest_s() / kStep_s) + 2; k + 2 + kStepsPerFrame < steps;
         ++k, ++count) {
        square += motion(k).accel.array().square();
        change += (motion(k + kStepsPerFrame).accel - motion(k).accel).array().square();
    }
    scene.variance = square / count;
    // Over a frame accelerations of variance v change by 2 v (1 - decay per frame).
    const Eigen::ArrayXd per_frame = (1 - change / (2 * square).max(1e-30)).max(0.0).min(1.0);
    scene.decay = per_frame.pow(1.0 / kStepsPerFrame);
}

size_t stepOf(double time_s) {
    return static_cast<size_t>(std::max(0.0, std::round(time_s / kStep_s)));
}

void addReadings(Scene& scene, const Take& take) {
    InertialCalibrator calibrator(scene.stage.suit, scene.stage.calibration,
                                  scene.stage.scenario.sample_rate_hz);
    auto readings = take.readings(kPrimaryRun).value();
    for (auto reading = readings.next().value(); reading; reading = readings.next().value()) {
        InertialMeasurement measurement = calibrator.convert(*reading);
        for (int i = 0; i < 3; ++i) {
            measurement.gyro.axes[static_cast<size_t>(i)].sigma = scene.stage.scenario.gyro_noise_rad_per_s;
            measurement.accel.axes[static_cast<size_t>(i)].sigma = scene.stage.scenario.accel_noise_m_per_s2;
        }
        if (const size_t k = stepOf(measurement.time_s); k < scene.instants.size())
            scene.instants[k].inertial.push_back(measurement);
    }
    const std::vector<ExternalRootRow> roots = take.externalRoot().value();
    for (const ExternalRootRow& row : roots) {
        const double time_s = 1e-9 * static_cast<double>(row.time_ns);
        if (const size_t k = stepOf(time_s); k < scene.instants.size())
            scene.instants[k].roots.push_back(
                {time_s, row.p_world_root, row.q_world_root, row.sigma_p_m, row.sigma_q_rad});
    }
}

/// Those of the direct path, and how they scatter.
void addDistances(Scene& scene, const Take& take) {
    StateLayout layout;
    layout.freedoms = scene.tree.freedoms();
    ObservationModel observations(scene.tree, scene.model, layout);
    auto ranges = take.ranges(kPrimaryRun).value();
    double square = 0, count = 0;
    for (auto range = ranges.next().value(); range; range = ranges.next().value()) {
        const double sent_s = static_cast<double>(range->pulse_sample) / scene.stage.scenario.sample_rate_hz;
        const DistanceMeasurement measurement{
            0,    range->source, range->board, sent_s, sent_s + range->distance_m / 345, range->distance_m,
            0.001};
        const size_t k = stepOf(measurement.arrival_s);
        if (k >= scene.instants.size())
            continue;
        const double now_s = static_cast<double>(k) * kStep_s;
        const auto [block, cos_angle] = observations.distance(scene.instants[k].truth, measurement,
                                                              sent_s - now_s, measurement.arrival_s - now_s);
        if (cos_angle < 0 || std::abs(block.residual[0]) > kDirect_m)
            continue;
        scene.instants[k].distances.push_back(measurement);
        square += block.residual[0] * block.residual[0];
        ++count;
    }
    scene.sigma_distance_m = std::sqrt(square / std::max(1.0, count));
    for (Instant& instant : scene.instants)
        for (DistanceMeasurement& distance : instant.distances)
            distance.sigma_m = scene.sigma_distance_m;
}

}  // namespace

Scene sceneOf(const std::string& motion, double seconds, uint64_t seed, const std::string& take_path) {
    simulation::StageRequest request = nominalStage(motion, seconds);
    request.seed = seed;
    Scene scene;
    scene.stage = std::move(simulation::prepareStage(request).value());
    simulation::TakeRequest take_request;
    take_request.out_path = take_path;
    take_request.level = simulation::Level::kReadings;
    take_request.overwrite = true;
    take_request.created_utc = "2000-01-01T00:00:00Z";
    simulation::writeTake(scene.stage, take_request, {}).value();
    scene.tree = KinematicTree(scene.stage.actor.skeleton, BallCoordinates::kManifold);
    scene.model = mountSuit(scene.stage.suit, scene.stage.calibration, scene.stage.actor, scene.tree).value();
    addTruth(scene);
    const Take take = Take::open(take_path).value();
    addReadings(scene, take);
    addDistances(scene, take);
    return scene;
}

}  // namespace noctule
