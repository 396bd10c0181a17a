// SPDX-License-Identifier: Apache-2.0
#include "core/guide/exercises.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kBlend_s = 1;

/// How much each part takes part, 0 to 1.
struct Effort {
    double squat, elbows, circles, kicks, trunk, head;
};
constexpr Effort kEfforts[kExerciseCount] = {{1, 1, 0, 0, 0, 0},     {0, 0, 1, 0, 0, 0},
                                             {0, 0, 0.3, 1, 0, 0},   {0, 0, 0, 0, 1, 0},
                                             {0, 0.6, 0, 0, 0.2, 1}, {0.3, 0.5, 0.6, 0.8, 0.4, 0.3}};

/// Segments of the middle or of either side.
constexpr std::array<std::array<const char*, 5>, kExerciseCount> kAsked = {{{"UpLeg", "Leg", "ForeArm"},
                                                                            {"Arm", "ForeArm"},
                                                                            {"UpLeg", "Leg", "Foot"},
                                                                            {"Spine", "Chest"},
                                                                            {"Head", "Shoulder", "Hand"},
                                                                            {}}};

double wave(double hz, double t_s, double phase = 0) {
    return std::sin(2 * std::numbers::pi * hz * t_s + phase);
}

/// 0 to 1 and back.
double bend(double hz, double t_s, double phase = 0) {
    return (1 - wave(hz, t_s, phase)) / 2;
}

Quaterniond about(double x, double y, double z) {
    return expQuaternion(Vector3d(x, y, z));
}

class Mover {
public:
    Mover(const Actor& actor, const Effort& effort, double t_s)
        : actor_(actor), effort_(effort), t_(t_s), pose_(actor.restPose()) {}

    Pose pose() {
        moveTrunk();
        for (const double side : {1.0, -1.0}) {
            moveLeg(side);
            moveArm(side);
        }
        return pose_;
    }

private:
    /// Turns on from the rest pose; a body without the joint does without.
    void turn(const std::string& joint, const Quaterniond& q) {
        if (const int index = actor_.skeleton.find(joint); index >= 0)
            pose_.q_parent_joint[static_cast<size_t>(index)] =
                q * pose_.q_parent_joint[static_cast<size_t>(index)];
    }
    double squat() const { return 1.1 * effort_.squat * bend(0.5, t_); }

    void moveTrunk() {
        const double trunk = effort_.trunk, head = effort_.head, squat = this->squat();
        pose_.q_parent_joint[0] = about(0.35 * squat + 0.15 * trunk * wave(0.4, t_),
                                        0.5 * trunk * wave(0.3, t_), 0.15 * trunk * wave(0.37, t_, 1)) *
                                  pose_.q_parent_joint[0];
        pose_.p_world_root.y() -= 0.43 * (1 - std::cos(0.8 * squat)) * 1.6;
        turn("Spine", about(0.1 * squat + 0.3 * trunk * wave(0.45, t_), 0.25 * trunk * wave(0.53, t_, 1),
                            0.3 * trunk * wave(0.61, t_, 2)));
        turn("Chest", about(0.15 * squat + 0.3 * trunk * wave(0.55, t_, 2), 0.35 * trunk * wave(0.43, t_),
                            0.3 * trunk * wave(0.5, t_, 1)));
        turn("Head",
             about(0.5 * head * wave(0.6, t_), 0.8 * head * wave(0.45, t_, 1), 0.3 * head * wave(0.7, t_)));
    }

    void moveLeg(double side) {
        const std::string name = side > 0 ? "Left" : "Right";
        const double phase = side > 0 ? 0 : 2.6, squat = this->squat();
        const double kick = effort_.kicks * wave(0.55, t_, phase);
        turn(name + "UpLeg", about(-1.25 * squat - 0.5 * kick, side * (0.2 * squat + 0.3 * kick),
                                   side * (0.15 * squat + 0.25 * effort_.kicks * bend(0.43, t_, phase))));
        turn(name + "Leg", about(1.8 * squat + 0.9 * effort_.kicks * bend(0.6, t_, phase), 0, 0));
        turn(name + "Foot",
             axisAngle(Vector3d::UnitZ(), 0.3 * effort_.kicks * wave(0.7, t_, phase)) *
                 axisAngle(Vector3d::UnitX(), -0.5 * squat + 0.4 * effort_.kicks * wave(0.8, t_, phase)));
    }

    void moveArm(double side) {
        const std::string name = side > 0 ? "Left" : "Right";
        const double phase = side > 0 ? 0 : 0.7;
        const double elbows = effort_.elbows, circle = effort_.circles, trunk = effort_.trunk,
                     shrug = effort_.head;
        turn(name + "Shoulder",
             axisAngle(Vector3d::UnitZ(), side * (0.35 * shrug * bend(0.5, t_, phase) +
                                                  0.3 * circle * (1 + wave(0.6, t_, phase + 1.57)) / 2)) *
                 axisAngle(Vector3d::UnitY(), 0.25 * (shrug + trunk + circle) * wave(0.6, t_, phase)));
        turn(name + "Arm",
             about(-(0.5 * elbows + 0.8 * circle + 0.6 * trunk) + 0.6 * circle * wave(0.6, t_, phase),
                   -side * 0.4 * trunk * wave(0.5, t_, phase), 0) *
                 about(0, 0, side * 0.6 * circle * (1 + wave(0.6, t_, phase + 1.57))) *
                 about(0.5 * (circle + elbows) * wave(0.47, t_, phase), 0, 0));
        turn(name + "ForeArm",
             axisAngle(-side * Vector3d::UnitY(), 0.5 * (elbows + circle + trunk) +
                                                      1.3 * elbows * bend(0.7, t_, phase) +
                                                      0.5 * (trunk + circle) * bend(0.6, t_, phase)) *
                 axisAngle(Vector3d::UnitX(), 0.8 * elbows * wave(0.5, t_, phase + 1) +
                                                  0.5 * (trunk + circle) * wave(0.6, t_, phase)));
        turn(name + "Hand",
             axisAngle(Vector3d::UnitZ(), 0.35 * (elbows + shrug) * wave(0.8, t_, phase)) *
                 axisAngle(Vector3d::UnitY(), 0.6 * (elbows + shrug) * wave(0.65, t_, phase + 1)));
    }

    const Actor& actor_;
    const Effort effort_;
    const double t_;
    Pose pose_;
};

Effort scaled(Effort effort, double share) {
    for (double* part :
         {&effort.squat, &effort.elbows, &effort.circles, &effort.kicks, &effort.trunk, &effort.head})
        *part *= share;
    return effort;
}

double smooth(double share) {
    const double u = std::clamp(share, 0.0, 1.0);
    return u * u * (3 - 2 * u);
}

}  // namespace

bool asksFor(Exercise exercise, const std::string& segment) {
    std::string name = segment;
    for (const char* side : {"Left", "Right"})
        if (name.starts_with(side))
            name.erase(0, std::string(side).size());
    return std::ranges::any_of(kAsked[static_cast<size_t>(exercise)],
                               [&name](const char* asked) { return asked && name == asked; });
}

Pose exercisePose(const Actor& actor, Exercise exercise, double t_s, double lasts_s) {
    const double share = smooth(t_s / kBlend_s) * smooth((lasts_s - t_s) / kBlend_s);
    return Mover(actor, scaled(kEfforts[static_cast<size_t>(exercise)], share), t_s).pose();
}

}  // namespace noctule
