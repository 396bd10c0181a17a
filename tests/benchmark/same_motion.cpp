// SPDX-License-Identifier: Apache-2.0
// same_motion A B STEP: how far the motions of two files are apart in every STEPth frame, as the studio
// understands both (unit, up axis, names), as JSON: joint_mm, and turn_deg since the first frame, in the
// world. Joints go by name. For files that another program opened and wrote again.
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "core/figure/understood_motion.h"
#include "core/formats/motion_document.h"
#include "core/math/rotation.h"

namespace {

using namespace noctule;

std::optional<figure::UnderstoodMotion> understood(const char* path) {
    auto document = readMotionDocument(path);
    auto motion = document ? figure::understandMotion(std::move(*document))
                           : Result<figure::UnderstoodMotion>(document.error());
    if (motion)
        return std::move(*motion);
    std::fprintf(stderr, "same_motion: %s\n", motion.error().text().c_str());
    return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs("usage: same_motion A B STEP\n", stderr);
        return 2;
    }
    const auto a = understood(argv[1]), b = understood(argv[2]);
    const int step = std::atoi(argv[3]);
    if (!a || !b || step < 1)
        return 1;
    const GlobalPose first_a = globalPose(a->clip, 0), first_b = globalPose(b->clip, 0);
    double joint_m = 0, turn_rad = 0;
    int joints = 0;
    const size_t frames = std::min(a->clip.frames.size(), b->clip.frames.size());
    for (size_t f = 0; f < frames; f += static_cast<size_t>(step)) {
        const GlobalPose pose_a = globalPose(a->clip, f), pose_b = globalPose(b->clip, f);
        joints = 0;
        for (size_t i = 0; i < a->clip.skeleton.joints().size(); ++i) {
            const int other = b->clip.skeleton.find(a->clip.skeleton.joints()[i].name);
            if (other < 0)
                continue;
            const auto o = static_cast<size_t>(other);
            ++joints;
            joint_m = std::max(joint_m, (pose_a.p_world_joint[i] - pose_b.p_world_joint[o]).norm());
            const Quaterniond turn_a = pose_a.q_world_joint[i] * first_a.q_world_joint[i].conjugate();
            const Quaterniond turn_b = pose_b.q_world_joint[o] * first_b.q_world_joint[o].conjugate();
            turn_rad = std::max(turn_rad, turn_a.angularDistance(turn_b));
        }
    }
    std::printf(
        "{\"frames\": [%zu, %zu], \"frame_time_s\": [%.7f, %.7f], \"joints\": %d, \"joint_mm\": %.5f, "
        "\"turn_deg\": "
        "%.5f}\n",
        a->clip.frames.size(), b->clip.frames.size(), a->clip.frame_time_s, b->clip.frame_time_s, joints,
        1e3 * joint_m, degrees(turn_rad));
    return 0;
}
