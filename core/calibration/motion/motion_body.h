// SPDX-License-Identifier: Apache-2.0
// The body as a calibration from motion sees it: segments whose orientations in the world are the unknowns,
// and chains of bones between them. A joint with no freedom shares its parent's segment. What a joint cannot
// do is a residual, not a missing unknown: people's hinges are not hinges.
#pragma once

#include <string>
#include <vector>

#include "core/body/actor.h"

namespace noctule {

/// A bone on the way from the root to a joint.
struct ChainBone {
    int segment = 0;                       ///< whose orientation turns it
    int bone = 0;                          ///< whose length it is
    Vector3d offset_m = Vector3d::Zero();  ///< in the segment's frame, as the actor's measures say
};

struct BodySegment {
    std::string name;  ///< of the joint that turns it
    int joint = 0;
    int parent = -1;       ///< segment; -1: the root
    int first_child = -1;  ///< segment
    JointType type = JointType::kBall;
    std::vector<DegreeOfFreedom> dof{};
    Quaterniond q_parent_rest = Quaterniond::Identity();  ///< in the rest pose; of the root in the world
    Vector3d along = Vector3d::Zero();                    ///< unit vector of its bone; zero when it has none
};

class MotionBody {
public:
    explicit MotionBody(const Actor& actor);

    int size() const { return static_cast<int>(segments_.size()); }
    const std::vector<BodySegment>& segments() const { return segments_; }
    const BodySegment& segment(int index) const { return segments_[static_cast<size_t>(index)]; }
    /// Of a joint; the parent's for a fixed one. Their frames are parallel.
    int segmentOfJoint(int joint) const { return segment_of_joint_[static_cast<size_t>(joint)]; }
    /// From the root to the joint's origin.
    const std::vector<ChainBone>& chain(int joint) const { return chains_[static_cast<size_t>(joint)]; }
    /// Joints whose offset from their parent is a bone, by index of the bone.
    const std::vector<int>& bones() const { return bones_; }

private:
    std::vector<BodySegment> segments_;
    std::vector<int> segment_of_joint_, bones_;
    std::vector<std::vector<ChainBone>> chains_;
};

}  // namespace noctule
