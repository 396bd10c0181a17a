// SPDX-License-Identifier: Apache-2.0
// A person who stands, walks with a turn, bends the knees and stands again, by forward kinematics; and what
// sensors on the segments read, mounted at random turns, each with a heading and a drift of its own. A rate
// is the mean since the reading before, as sensors that integrate tell it.
#pragma once

#include <cmath>
#include <map>
#include <random>

#include "core/math/easing.h"
#include "core/math/rotation.h"
#include "core/posing/pose_body.h"

namespace noctule::posing::test {

inline constexpr double kRate_hz = 50, kDuration_s = 30;

/// Segments of a whole suit.
inline const std::vector<std::string> kWhole = {
    "Hips",         "Spine",     "Chest",     "Head",    "LeftArm",  "LeftForeArm", "LeftHand", "RightArm",
    "RightForeArm", "RightHand", "LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg",  "RightLeg", "RightFoot"};

inline double between(double t, double from, double to) {
    const double x = std::clamp((t - from) / (to - from), 0.0, 1.0);
    return x * x * x * (10 - 15 * x + 6 * x * x);
}

/// Truth at t: stands to 2 s, walks to 20 s and turns by 140 degrees meanwhile, squats at 24 s.
inline Pose walkAt(const Actor& actor, double t) {
    Pose pose = standingPose(actor, false);
    const auto turn = [&](const std::string& joint, const Vector3d& axis, double angle_rad) {
        Quaterniond& q = pose.q_parent_joint[size_t(actor.skeleton.find(joint))];
        q = axisAngle(axis, angle_rad) * q;
    };
    const Vector3d X = Vector3d::UnitX(), Y = Vector3d::UnitY(), Z = Vector3d::UnitZ();
    const double walk = between(t, 2, 3.5) * (1 - between(t, 18.5, 20));
    const double phase = 2 * std::numbers::pi * 0.9 * t;
    const double squat = between(t, 21.5, 23) * (1 - between(t, 24.5, 26));
    for (const auto& [side, shift, sign] :
         {std::tuple{"Left", 0.0, 1.0}, std::tuple{"Right", std::numbers::pi, -1.0}}) {
        const double swing = std::sin(phase + shift);
        const double knee = 0.5 + 0.45 * std::sin(phase + shift + 0.9) + 0.1 * std::sin(2 * phase);
        const std::string s = side;
        turn(s + "UpLeg", X, -walk * (0.1 + 0.4 * swing) - 1.2 * squat);
        turn(s + "UpLeg", Z, walk * sign * 0.06 * swing);
        turn(s + "Leg", X, walk * knee + 1.9 * squat);
        turn(s + "Foot", X, -walk * 0.2 * swing - 0.7 * squat);
        turn(s + "Arm", X, walk * 0.4 * swing - 0.5 * squat);
        turn(s + "Arm", Y, sign * walk * 0.15 * std::cos(phase));
        turn(s + "ForeArm", -sign * Y, walk * (0.4 + 0.25 * swing));
        turn(s + "Hand", Y, walk * 0.2 * std::sin(phase + 1));
    }
    turn("Spine", Y, walk * 0.1 * std::sin(phase));
    turn("Spine", X, 0.05 * walk + 0.3 * squat);
    turn("Chest", Y, walk * 0.12 * std::sin(phase + 0.3));
    turn("Head", Y, walk * 0.15 * std::sin(phase / 3));
    const double heading = 2.44 * between(t, 8, 13);
    pose.q_parent_joint[0] = axisAngle(Y, heading) * axisAngle(Y, walk * 0.12 * std::sin(phase)) *
                             axisAngle(Z, walk * 0.05 * std::sin(phase));
    const double along = t < 2 ? 0 : 1.1 * (std::min(t, 20.0) - 2);
    pose.p_world_root +=
        walk * Vector3d(0.03 * std::sin(phase), 0.02 * std::sin(2 * phase + 1), 0.03 * std::sin(2 * phase)) +
        walk * along * Vector3d(std::sin(heading), 0, std::cos(heading)) + squat * Vector3d(0, -0.35, -0.1);
    return pose;
}

struct MadeSuit {
    SensorTracks tracks;
    std::vector<Pose> truth;
    std::vector<Quaterniond> q_segment_sensor;  ///< per sensor; the tracks do not state it
};

inline MadeSuit madeSuit(const Actor& actor, const std::vector<std::string>& segments, unsigned seed,
                         double rate_hz = kRate_hz) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(-1, 1);
    MadeSuit suit;
    suit.tracks.rate_hz = rate_hz;
    const double dt = 1 / rate_hz;
    const auto rows = size_t(kDuration_s * rate_hz);
    std::vector<GlobalPose> bodies;
    for (size_t i = 0; i < rows + 2; ++i) {
        const Pose pose = walkAt(actor, (double(i) - 1) * dt);
        bodies.push_back(globalPose(actor.skeleton, pose));
        if (i >= 1 && i <= rows)
            suit.truth.push_back(pose);
    }
    for (const std::string& segment : segments) {
        const auto j = size_t(actor.skeleton.find(segment));
        SensorTrack track;
        track.id = "on " + segment;
        track.segment = segment;
        const Quaterniond q_segment_sensor =
            Quaterniond{normal(random), normal(random), normal(random), normal(random)}.normalized();
        const Vector3d place_m = 0.06 * Vector3d{uniform(random), uniform(random), uniform(random)};
        const double heading = 3.1 * uniform(random), drift = 0.003 * uniform(random);
        const auto at = [&](size_t i) -> Vector3d {
            return bodies[i].p_world_joint[j] + bodies[i].q_world_joint[j] * place_m;
        };
        for (size_t i = 1; i <= rows; ++i) {
            const Quaterniond q = bodies[i].q_world_joint[j] * q_segment_sensor;
            const Vector3d accel = (at(i + 1) - 2 * at(i) + at(i - 1)) / (dt * dt);
            const Quaterniond step = bodies[i - 1].q_world_joint[j].conjugate() * bodies[i].q_world_joint[j];
            const auto noise = [&](double sigma) -> Vector3d {  // as dense at every rate
                return std::sqrt(rate_hz / kRate_hz) * sigma *
                       Vector3d{normal(random), normal(random), normal(random)};
            };
            track.rate_rad_per_s.push_back(q_segment_sensor.conjugate() * (logQuaternion(step) / dt) +
                                           noise(0.005));
            track.accel_m_per_s2.push_back(
                q.conjugate() * (accel + kStandardGravity_m_per_s2 * Vector3d::UnitY()) + noise(0.05));
            track.q_world_sensor.push_back(axisAngle(Vector3d::UnitY(), heading + drift * double(i) * dt) *
                                           q);
            track.heading_sigma_rad.push_back(std::numbers::pi);
        }
        suit.tracks.sensors.push_back(std::move(track));
        suit.q_segment_sensor.push_back(q_segment_sensor);
    }
    return suit;
}

}  // namespace noctule::posing::test
