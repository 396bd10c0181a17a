// SPDX-License-Identifier: Apache-2.0
#include "core/report/angle_names.h"

#include <array>
#include <string_view>

namespace noctule {
namespace {

/// Positive directions about Z (forward), X (left) and Y (up) of the T pose; limbs hang or point to their
/// side, so Z and Y are mirrored.
struct AngleWords {
    std::string_view joint;  ///< without its side
    std::array<std::string_view, 3> left, right;
};

constexpr std::array<std::string_view, 3> kTrunk = {"bending to the right", "flexion", "turn to the left"};
constexpr AngleWords kAngleWords[] = {
    {"Spine", kTrunk, kTrunk},
    {"Chest", kTrunk, kTrunk},
    {"Neck", kTrunk, kTrunk},
    {"Head", kTrunk, kTrunk},
    {"Shoulder",
     {"elevation", "forward rotation", "retraction"},
     {"depression", "forward rotation", "protraction"}},
    {"Arm",
     {"abduction", "internal rotation", "horizontal extension"},
     {"adduction", "internal rotation", "horizontal flexion"}},
    {"ForeArm", {"abduction", "pronation", "extension"}, {"adduction", "pronation", "flexion"}},
    {"Hand", {"extension", "pronation", "ulnar deviation"}, {"flexion", "pronation", "radial deviation"}},
    {"UpLeg",
     {"abduction", "extension", "external rotation"},
     {"adduction", "extension", "internal rotation"}},
    {"Leg", {"abduction", "flexion", "external rotation"}, {"adduction", "flexion", "internal rotation"}},
    {"Foot", {"eversion", "plantarflexion", "abduction"}, {"inversion", "plantarflexion", "adduction"}},
    {"ToeBase", {"eversion", "flexion", "abduction"}, {"inversion", "flexion", "adduction"}},
};

}  // namespace

std::string anatomicalAngle(const std::string& joint, size_t angle) {
    std::string_view name = joint;
    const bool is_right = name.starts_with("Right");
    if (is_right || name.starts_with("Left"))
        name.remove_prefix(is_right ? 5 : 4);
    for (const AngleWords& words : kAngleWords)
        if (words.joint == name)
            return std::string((is_right ? words.right : words.left)[angle]);
    return "";
}

}  // namespace noctule
