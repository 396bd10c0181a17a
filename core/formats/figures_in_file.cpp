// SPDX-License-Identifier: Apache-2.0
#include "core/formats/figures_in_file.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

constexpr double kSameJoint_m = 1e-6;

bool areSameJoints(const Skeleton& a, const Skeleton& b) {
    return std::equal(a.joints().begin(), a.joints().end(), b.joints().begin(), b.joints().end(),
                      [](const Joint& joint, const Joint& other) {
                          return joint.name == other.name && joint.parent == other.parent &&
                                 (joint.offset_m - other.offset_m).norm() < kSameJoint_m;
                      });
}

}  // namespace

Status FiguresInFile::add(const Figure& figure) {
    const MotionClip& clip = figure.clip;
    if (names_.empty()) {
        first_.name = clip.name;
        first_.skeleton = clip.skeleton;
        first_.frame_time_s = clip.frame_time_s;
    }
    const bool is_character = !figure.character.empty();
    const std::string& name = is_character ? figure.character : clip.name;
    const auto refuse = [&](const std::string& why) {
        return Error{ErrorKind::kUnusable, where_ + ": " + name + why, "Write it to a file of its own"};
    };
    if (!names_.insert(name).second)
        return refuse(is_character ? " is the name of two performers" : " is the name of two motions");
    if (!is_character && !areSameJoints(clip.skeleton, first_.skeleton))
        return refuse(" has other bones than " + first_.name);
    if (std::abs(clip.frame_time_s / first_.frame_time_s - 1) > 1e-9)
        return refuse(" has another frame rate than " + first_.name);
    return Done{};
}

}  // namespace noctule
