// SPDX-License-Identifier: Apache-2.0
// A room with anchors and somebody in a suit who stands, then walks round in it, as ranges with the errors
// that real ones have: noise, flesh, devices beside their places, poses that drift, echoes.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/math/rotation.h"
#include "core/room_survey/room_survey.h"

namespace noctule::room_survey {

struct WalkedRoom {
    std::vector<Vector3d> anchors_m{{2.3, 2.7, 2.3}, {-2.3, 2.4, 2.3}, {-2.3, 2.65, -2.3}, {2.3, 1.2, -2.3}};
    double walk_s = 57, stand_s = 3;
    double noise_m = 0.004, device_m = 0.005, flesh_m = 0.005;
    double drift_rad_per_s = 0.003, drift_m_per_s = 0.005;  ///< of the poses
    double echo_share = 0.03;
    double clock_m = 0;   ///< of the room's clock
    double scale = 6e-4;  ///< sigma of the speed of sound's error: 0.35 K
    bool clock_known = true;
    int devices = 13;
    std::vector<int> deaf{};  ///< anchors that the performer neither hears nor is heard by
    std::optional<std::pair<int, Vector3d>> moved{};  ///< in the middle of the walk
    bool walks = true;
    double between_sigma_m = 0.0015;
    std::vector<std::pair<int, int>> hidden{};  ///< pairs of anchors
    bool anchors_hear = false;
};

inline Evidence evidenceOf(const WalkedRoom& room, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    const auto vector = [&](double sigma) {
        return Vector3d{sigma * normal(random), sigma * normal(random), sigma * normal(random)};
    };
    Evidence evidence;
    evidence.performer = "A";
    evidence.devices = room.devices;
    evidence.clock_known = room.clock_known;
    const double scale = 1 + room.scale * normal(random);
    std::vector<Vector3d> halves_m;
    for (size_t a = 0; a < room.anchors_m.size(); ++a) {
        halves_m.push_back(0.005 * vector(1).normalized());
        evidence.anchors.push_back(
            {"anchor_" + std::to_string(a + 1), true, true, 0.01, room.anchors_m[a] + vector(0.3), 100, 100});
    }
    std::vector<Vector3d> devices_m, errors_m, flesh_m(static_cast<size_t>(room.devices), Vector3d::Zero());
    for (int d = 0; d < room.devices; ++d) {
        devices_m.push_back(Vector3d{0.7 * (uniform(random) - 0.5), 1.6 * uniform(random) - 0.9,
                                     0.4 * (uniform(random) - 0.5)});
        errors_m.push_back(vector(room.device_m));
    }
    constexpr double kStep_s = 0.02, kFlesh_s = 0.5, kRadius_m = 1.1, kSpeed_rad_per_s = 0.6;
    for (double t = 0; room.walks && t < room.stand_s + room.walk_s; t += kStep_s) {
        const double angle = kSpeed_rad_per_s * std::max(0.0, t - room.stand_s);
        // Round in a circle that begins at the origin, facing +z.
        const Vector3d root_m(kRadius_m * (1 - std::cos(angle)), 0.95, kRadius_m * std::sin(angle));
        const Quaterniond q = axisAngle(Vector3d::UnitY(), angle);
        const double drift_rad = room.drift_rad_per_s * std::max(0.0, t - room.stand_s);
        const Vector3d drift_m(room.drift_m_per_s * std::max(0.0, t - room.stand_s), 0, 0);
        const Quaterniond off = axisAngle(Vector3d::UnitY(), drift_rad);
        for (int d = 0; d < room.devices; ++d) {
            const auto i = static_cast<size_t>(d);
            const double keep = std::exp(-kStep_s / kFlesh_s);
            flesh_m[i] = keep * flesh_m[i] + vector(room.flesh_m * std::sqrt(1 - keep * keep));
            const int anchor = static_cast<int>(uniform(random) * static_cast<double>(room.anchors_m.size()));
            if (uniform(random) < 0.7 || std::ranges::count(room.deaf, anchor) > 0)
                continue;
            const auto a = static_cast<size_t>(anchor);
            const bool anchor_hears = uniform(random) < 0.3;
            Vector3d place_m = room.anchors_m[a] + (anchor_hears ? -1 : 1) * halves_m[a];
            if (room.moved && room.moved->first == anchor && t > room.stand_s + room.walk_s / 2)
                place_m += room.moved->second;
            const Vector3d by_pose_m = root_m + q * devices_m[i];
            const Vector3d true_m = by_pose_m + q * (errors_m[i] + flesh_m[i]);
            const double echo_m = uniform(random) < room.echo_share ? 0.1 + 0.5 * uniform(random) : 0;
            evidence.walk.push_back({t, anchor, anchor_hears, d, off * by_pose_m + drift_m,
                                     (off * q).toRotationMatrix(),
                                     scale * (true_m - place_m).norm() + room.noise_m * normal(random) +
                                         echo_m + (anchor_hears ? 1 : -1) * room.clock_m,
                                     room.noise_m});
        }
    }
    const auto count = static_cast<int>(room.anchors_m.size());
    for (int a = 0; room.anchors_hear && a < count; ++a)
        for (int b = 0; b < count; ++b) {
            const bool hidden = std::ranges::any_of(room.hidden, [&](const auto& pair) {
                return pair == std::pair(std::min(a, b), std::max(a, b));
            });
            if (a == b || hidden)
                continue;
            const auto i = static_cast<size_t>(a), k = static_cast<size_t>(b);
            const double bias_m = room.between_sigma_m * normal(random);
            for (int n = 0; n < 100; ++n) {
                const bool moved = room.moved && n >= 50;
                const auto at = [&](size_t anchor, double side) -> Vector3d {
                    const bool this_one = moved && room.moved->first == static_cast<int>(anchor);
                    return room.anchors_m[anchor] + side * halves_m[anchor] +
                           (this_one ? room.moved->second : Vector3d::Zero());
                };
                const double echo_m = uniform(random) < room.echo_share ? 0.1 + 0.5 * uniform(random) : 0;
                evidence.between.push_back(
                    {a, b, 0.4 * n,
                     scale * (at(i, 1) - at(k, -1)).norm() + bias_m + room.noise_m * normal(random) + echo_m,
                     room.noise_m});
            }
        }
    return evidence;
}

/// Errors of all places after the best turn and displacement of the whole.
inline Eigen::VectorXd constellationError(const std::vector<Vector3d>& truth_m,
                                          const std::vector<Vector3d>& found_m) {
    const auto n = static_cast<Eigen::Index>(truth_m.size());
    Eigen::Matrix3Xd truth(3, n), found(3, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        truth.col(i) = truth_m[static_cast<size_t>(i)];
        found.col(i) = found_m[static_cast<size_t>(i)];
    }
    const Eigen::Matrix4d T = Eigen::umeyama(found, truth, false);
    const Eigen::Matrix3Xd error =
        ((T.topLeftCorner<3, 3>() * found).colwise() + T.topRightCorner<3, 1>()) - truth;
    return error.reshaped();
}

}  // namespace noctule::room_survey
