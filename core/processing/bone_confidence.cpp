// SPDX-License-Identifier: Apache-2.0
#include "core/processing/bone_confidence.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

constexpr double kHalfTrusted_rad = radians(5);

const TimedPose& nearestFrame(const std::vector<TimedPose>& frames, int64_t time_ns) {
    const auto later = std::lower_bound(frames.begin(), frames.end(), time_ns,
                                        [](const TimedPose& frame, int64_t t) { return frame.time_ns < t; });
    if (later == frames.begin())
        return frames.front();
    const auto before = std::prev(later);
    return later == frames.end() || time_ns - before->time_ns <= later->time_ns - time_ns ? *before : *later;
}

}  // namespace

std::vector<float> boneConfidence(const TimedMotion& motion, int64_t time_ns) {
    if (motion.frames.empty())
        return {};
    const std::vector<double>& sigma_rad = nearestFrame(motion.frames, time_ns).sigma_rad;
    std::vector<float> confidence;
    for (size_t j = 0; 3 * j + 2 < sigma_rad.size(); ++j) {
        const double sigma = std::hypot(sigma_rad[3 * j], sigma_rad[3 * j + 1], sigma_rad[3 * j + 2]);
        const int parent = motion.skeleton.joint(static_cast<int>(j)).parent;
        const double share = sigma / kHalfTrusted_rad;
        confidence.push_back(sigma == 0 && parent >= 0 ? confidence[static_cast<size_t>(parent)]
                                                       : static_cast<float>(1 / (1 + share * share)));
    }
    return confidence;
}

}  // namespace noctule
