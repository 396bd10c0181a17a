// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sound_track.h"

#include <algorithm>
#include <cmath>

#include "core/job/contract.h"

namespace noctule::simulation {

Vector3d MicrophoneTrack::position(int board, double t_s) {
    const double t = std::clamp(t_s, 0.0, world_.duration_s());
    const auto before = static_cast<int64_t>(t / kStep_s);
    // Four nodes around t; at both ends of the world the four nearest inside it.
    const auto last_base = static_cast<int64_t>(world_.duration_s() / kStep_s) - 3;
    const int64_t base = std::max<int64_t>(0, std::min(before - 1, last_base));
    const double x = t / kStep_s - static_cast<double>(base);
    const auto at = static_cast<size_t>(board);
    const double x1 = x - 1, x2 = x - 2, x3 = x - 3;
    return -x1 * x2 * x3 / 6 * node(base)[at] + x * x2 * x3 / 2 * node(base + 1)[at] -
           x * x1 * x3 / 2 * node(base + 2)[at] + x * x1 * x2 / 6 * node(base + 3)[at];
}

void MicrophoneTrack::forgetBefore(double t_s) {
    const auto keep = static_cast<int64_t>(std::min(t_s, world_.duration_s()) / kStep_s) - 4;
    while (first_node_ < keep && !nodes_.empty()) {
        nodes_.pop_front();
        ++first_node_;
    }
}

const std::vector<Vector3d>& MicrophoneTrack::node(int64_t index) {
    require(index >= first_node_, "MicrophoneTrack: asked for what was forgotten");
    while (first_node_ + static_cast<int64_t>(nodes_.size()) <= index) {
        const auto next = first_node_ + static_cast<int64_t>(nodes_.size());
        const double t_s = std::min(static_cast<double>(next) * kStep_s, world_.duration_s());
        std::vector<Vector3d> positions;
        for (int b = 0; b < world_.boardCount(); ++b)
            positions.push_back(world_.microphone(b, t_s));
        nodes_.push_back(std::move(positions));
    }
    return nodes_[static_cast<size_t>(index - first_node_)];
}

}  // namespace noctule::simulation
