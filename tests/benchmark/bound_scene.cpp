// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmark/bound_scene.h"

#include <algorithm>
#include <cmath>
#include <random>

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

double offsetSigma_m(const simulation::Scenario& scenario) {
    constexpr double kSpeed_m_per_s = 345;
    return scenario.source_offset_error_s * kSpeed_m_per_s;
}

double soundScaleSigma(const simulation::Scenario& scenario) {
    constexpr double kScalePerKelvin = 0.0018;
    return scenario.temperature_error_c * kScalePerKelvin;
}

Scene sceneOf(const std::string& motion, double seconds, uint64_t seed, const std::string& take_path,
              Boards boards) {
    simulation::StageRequest request = nominalStage(motion, seconds);
    request.seed = seed;
    if (boards == Boards::kFlawless) {
        simulation::Scenario& s = request.scenario;
        s.codec = false;
        for (double* error : {&s.gyro_noise_rad_per_s, &s.accel_noise_m_per_s2, &s.gyro_bias_rad_per_s,
                              &s.accel_bias_m_per_s2, &s.gyro_bias_walk_rad_per_s_per_sqrt_s,
                              &s.gyro_matrix_error, &s.accel_matrix_error})
            *error = 0;
    }
    Scene scene;
    scene.stage = std::move(simulation::prepareStage(request).value());
    writeReadings(scene.stage, take_path);
    scene.tree = KinematicTree(scene.stage.actor.skeleton, BallCoordinates::kManifold);
    scene.model = mountSuit(scene.stage.suit, scene.stage.calibration, scene.stage.actor, scene.tree).value();
    addTruth(scene);
    const Take take = Take::open(take_path).value();
    addReadings(scene, take);
    addDistances(scene, take);
    return scene;
}

std::vector<Instant> drawnInstants(const Scene& scene, const Scene& flawless, uint64_t seed) {
    const simulation::Scenario& scenario = scene.stage.scenario;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const auto draw3 = [&](double sigma) {
        return Vector3d{sigma * normal(random), sigma * normal(random), sigma * normal(random)};
    };
    BodyState errors;
    for (size_t b = 0; b < scene.model.boards.size(); ++b) {
        errors.gyro_bias.push_back(draw3(scenario.gyro_bias_rad_per_s));
        errors.accel_bias.push_back(draw3(scenario.accel_bias_m_per_s2));
    }
    for (size_t s = 0; s < scene.model.sources.size(); ++s)
        errors.source_offset_m.push_back(offsetSigma_m(scenario) * normal(random));
    errors.sound_scale = soundScaleSigma(scenario) * normal(random);
    const auto disturb = [&](TriadReading& reading, double sigma, const Vector3d& bias) {
        for (AxisReading& axis : reading.axes) {
            axis.value += sigma * normal(random) + axis.sensitive_axis_board.dot(bias);
            axis.sigma = sigma;
        }
    };
    StateLayout layout;
    layout.freedoms = scene.tree.freedoms();
    ObservationModel observations(scene.tree, scene.model, layout);
    std::vector<Instant> instants = scene.instants;
    for (size_t k = 0; k < instants.size(); ++k) {
        Instant& instant = instants[k];
        for (Vector3d& bias : errors.gyro_bias)
            bias += draw3(scenario.gyro_bias_walk_rad_per_s_per_sqrt_s * std::sqrt(kStep_s));
        instant.inertial = flawless.instants[k].inertial;
        for (InertialMeasurement& reading : instant.inertial) {
            const auto board = static_cast<size_t>(reading.board);
            disturb(reading.gyro, scenario.gyro_noise_rad_per_s, errors.gyro_bias[board]);
            disturb(reading.accel, scenario.accel_noise_m_per_s2, errors.accel_bias[board]);
        }
        errors.motion = instant.truth.motion;
        const double now_s = static_cast<double>(k) * kStep_s;
        for (DistanceMeasurement& distance : instant.distances)
            distance.distance_m +=
                distance.sigma_m * normal(random) -
                observations
                    .distance(errors, distance, distance.emission_s - now_s, distance.arrival_s - now_s)
                    .block.residual[0];
    }
    return instants;
}

}  // namespace noctule
