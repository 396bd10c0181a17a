// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/source_figure.h"

namespace noctule::simulation {

SourceFigure::SourceFigure(const MotionClip& clip, const figure::JointMapping& mapping,
                           const Skeleton& target)
    : mapping_(mapping) {
    const figure::SeenMotion seen(clip);
    const figure::Alignment alignment = figure::alignFigure(clip, seen, mapping_, target);
    for (const Joint& joint : target.joints()) {
        const auto found = mapping_.find(joint.name);
        const auto q = alignment.q_source_canonical.find(joint.name);
        const bool known = found != mapping_.end() && q != alignment.q_source_canonical.end();
        source_of_.push_back(known ? found->second : -1);
        q_source_target_.push_back(known ? q->second : Quaterniond::Identity());
    }
    for (const std::string side : {"Left", "Right"}) {
        const double thigh = seen.distance(mapping_.at(side + "UpLeg"), mapping_.at(side + "Leg"));
        leg_length_m_ += thigh / 2;
        leg_length_m_ += (mapping_.contains(side + "Foot")
                              ? seen.distance(mapping_.at(side + "Leg"), mapping_.at(side + "Foot"))
                              : thigh) /
                         2;
    }
}

std::optional<Quaterniond> SourceFigure::target(int joint, const GlobalPose& source) const {
    const size_t j = static_cast<size_t>(joint);
    if (source_of_[j] < 0)
        return std::nullopt;
    return source.q_world_joint[static_cast<size_t>(source_of_[j])] * q_source_target_[j];
}

Vector3d SourceFigure::hipCentre(const GlobalPose& source) const {
    return (source.p_world_joint[static_cast<size_t>(mapping_.at("LeftUpLeg"))] +
            source.p_world_joint[static_cast<size_t>(mapping_.at("RightUpLeg"))]) /
           2;
}

}  // namespace noctule::simulation
