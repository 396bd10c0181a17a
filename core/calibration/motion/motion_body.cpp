// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_body.h"

namespace noctule {
namespace {

constexpr double kShortestBone_m = 1e-3;

}  // namespace

MotionBody::MotionBody(const Actor& actor) {
    const Skeleton& skeleton = actor.skeleton;
    for (int j = 0; j < skeleton.size(); ++j) {
        const Joint& joint = skeleton.joint(j);
        const int parent = joint.parent < 0 ? -1 : segmentOfJoint(joint.parent);
        chains_.emplace_back();
        if (joint.parent >= 0) {
            chains_.back() = chain(joint.parent);
            chains_.back().push_back({parent, static_cast<int>(bones_.size()), joint.offset_m});
            bones_.push_back(j);
            BodySegment& above = segments_[static_cast<size_t>(parent)];
            if (above.along.isZero() && joint.offset_m.norm() > kShortestBone_m)
                above.along = joint.offset_m.normalized();
        }
        if (joint.type == JointType::kFixed && parent >= 0) {
            segment_of_joint_.push_back(parent);
            continue;
        }
        segment_of_joint_.push_back(size());
        if (parent >= 0 && segment(parent).first_child < 0)
            segments_[static_cast<size_t>(parent)].first_child = size();
        segments_.push_back({joint.name, j, parent, -1, joint.type, joint.dof,
                             actor.rest_q_parent_joint[static_cast<size_t>(j)]});
        if (joint.end_m && joint.end_m->norm() > kShortestBone_m)
            segments_.back().along = joint.end_m->normalized();
    }
}

}  // namespace noctule
