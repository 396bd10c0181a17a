// SPDX-License-Identifier: Apache-2.0
// The figure in a motion file seen as a canonical body: its lengths, and where each canonical segment points
// in a frame. A segment's frame in the file may lie in any way to ours; the constant rotation between them is
// found where the file's figure stands in its zero pose: left and up from hips and shoulders, limbs along
// their bones, and the twist of a limb from the plane in which its elbow or knee bends over the motion.
#pragma once

#include <vector>

#include "core/body/actor.h"
#include "core/motion/clip.h"
#include "core/simulation/joint_mapping.h"

namespace noctule::simulation {

/// Measures of the file's figure from its zero pose.
BodyMeasures measure(const MotionClip& clip, const JointMapping& mapping);

class SourceFigure {
public:
    SourceFigure(const MotionClip& clip, JointMapping mapping, const Skeleton& target);

    /// q_world_joint wanted of a target joint in a frame of the file; nothing when the file has no such
    /// joint.
    std::optional<Quaterniond> target(int joint, const GlobalPose& source) const;
    /// Middle between the thighs.
    Vector3d hipCentre(const GlobalPose& source) const;
    double legLength_m() const { return leg_length_m_; }

private:
    void alignSegments(const MotionClip& clip);
    void alignTwist(const MotionClip& clip, const std::string& limb, const std::string& child);
    Vector3d targetBone(const std::string& joint, const std::string& child) const;

    JointMapping mapping_;
    const Skeleton& target_;
    std::vector<int> source_of_;                ///< per target joint, -1 when absent
    std::vector<Quaterniond> q_source_target_;  ///< per target joint
    double leg_length_m_ = 0;
};

}  // namespace noctule::simulation
