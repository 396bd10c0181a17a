// SPDX-License-Identifier: Apache-2.0
#include "core/body/usual_pose.h"

#include <numbers>

#include "core/body/joint_names.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

struct Row {
    const char* joint;
    Vector3d turn_deg, sigma_deg;
};

/// As `learn_usual_pose` (tests/benchmark/) prints it for test_mocapbank, test_freebvh and walk01 of
/// bvh-toolbox (MIT), bvh_test1 of pybvh (MIT) and zombieWalk1 of MakeHuman (CC0), five motions of 25 s in
/// all that no figure of ours is measured on.
const Row kRows[] = {
    {"Spine", {8, 0, 0}, {7, 5, 5}},          {"Chest", {11, 0, 0}, {7, 5, 3}},
    {"Head", {-8, 0, 0}, {12, 14, 6}},        {"LeftShoulder", {0, -2, -5}, {0, 6, 6}},
    {"LeftArm", {6, -28, -57}, {16, 26, 22}}, {"LeftForeArm", {-2, -33, 0}, {25, 15, 5}},
    {"LeftHand", {-2, -4, -2}, {12, 15, 15}}, {"LeftUpLeg", {-9, 8, 4}, {35, 10, 9}},
    {"LeftLeg", {31, 0, 0}, {35, 0, 0}},      {"LeftFoot", {-14, 1, -6}, {11, 3, 11}},
};

}  // namespace

std::optional<UsualTurn> usualTurn(const std::string& joint) {
    constexpr double kRadians = std::numbers::pi / 180;
    const std::string other_side = mirroredSegment(joint);
    for (const Row& row : kRows) {
        if (row.joint != joint && row.joint != other_side)
            continue;
        const Quaterniond q = expQuaternion(kRadians * row.turn_deg);
        return UsualTurn{row.joint == joint ? q : mirroredInX(q), kRadians * row.sigma_deg};
    }
    return std::nullopt;
}

}  // namespace noctule
