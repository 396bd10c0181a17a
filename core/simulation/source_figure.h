// SPDX-License-Identifier: Apache-2.0
// The figure in a motion file seen as a canonical body: where each canonical segment points in a frame.
#pragma once

#include <optional>
#include <vector>

#include "core/figure/alignment.h"

namespace noctule::simulation {

class SourceFigure {
public:
    SourceFigure(const MotionClip& clip, const figure::JointMapping& mapping, const Skeleton& target);

    /// q_world_joint wanted of a target joint in a frame of the file; nothing when the file has no such
    /// joint.
    std::optional<Quaterniond> target(int joint, const GlobalPose& source) const;
    /// Middle between the thighs.
    Vector3d hipCentre(const GlobalPose& source) const;
    double legLength_m() const { return leg_length_m_; }

private:
    figure::JointMapping mapping_;
    std::vector<int> source_of_;                ///< per target joint, -1 when absent
    std::vector<Quaterniond> q_source_target_;  ///< per target joint
    double leg_length_m_ = 0;
};

}  // namespace noctule::simulation
