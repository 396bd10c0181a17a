// SPDX-License-Identifier: Apache-2.0
#include "core/render/body_scene.h"

#include <algorithm>

#include "core/suit/placed_suit.h"

namespace noctule {

namespace {

void addBones(const Skeleton& skeleton, BodyPlaces& places) {
    const GlobalPose& joints = places.joints;
    for (int j = 0; j < skeleton.size(); ++j) {
        const Joint& joint = skeleton.joint(j);
        const auto at = static_cast<size_t>(j);
        const auto parent = static_cast<size_t>(joint.parent);
        if (joint.parent >= 0)
            places.bones.push_back({joint.parent, joints.p_world_joint[parent], joints.p_world_joint[at]});
        if (joint.end_m)
            places.bones.push_back({j, joints.p_world_joint[at],
                                    joints.p_world_joint[at] + joints.q_world_joint[at] * *joint.end_m});
    }
}

}  // namespace

Eigen::AlignedBox3d BodyPlaces::box() const {
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : joints.p_world_joint)
        box.extend(p);
    for (const BonePlace& bone : bones)
        box.extend(bone.to_m);
    return box;
}

SceneDisc softShadow(const Eigen::AlignedBox3d& box, const Rgba& color) {
    const Eigen::Vector3f centre = box.center().cast<float>(), size = box.sizes().cast<float>();
    const float height = std::max(0.0F, static_cast<float>(box.min().y()));
    SceneDisc shadow;
    shadow.centre_m = {centre.x(), 0, centre.z()};
    shadow.radius_x_m = 0.25F + 0.45F * size.x() + height;
    shadow.radius_z_m = 0.25F + 0.45F * size.z() + height;
    shadow.color = color.faded(1 / (1 + 4 * height));
    shadow.softness = 1;
    return shadow;
}

Eigen::Isometry3d segmentFrame(const Skeleton& skeleton, const GlobalPose& joints,
                               const std::string& segment) {
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    if (segment.empty() || joints.p_world_joint.empty())
        return frame;
    const auto joint = static_cast<size_t>(std::max(0, skeleton.find(segment)));
    frame.linear() = joints.q_world_joint[joint].toRotationMatrix();
    frame.translation() = joints.p_world_joint[joint];
    return frame;
}

BodyPlaces placeBody(const Skeleton& skeleton, const Pose& pose, const Suit& suit,
                     const Calibration* calibration) {
    BodyPlaces places;
    places.joints = globalPose(skeleton, pose);
    addBones(skeleton, places);
    const Suit placed = calibration ? placedSuit(suit, *calibration) : suit;
    for (const Board& board : placed.boards) {
        const Eigen::Isometry3d T_world_segment = segmentFrame(skeleton, places.joints, board.segment);
        places.boards.push_back(
            {T_world_segment * board.p_segment_board_m,
             (Quaterniond(T_world_segment.linear()) * board.q_segment_board).normalized()});
    }
    for (const Source& source : placed.sources) {
        const Eigen::Isometry3d T_world_segment = segmentFrame(skeleton, places.joints, source.segment);
        places.sources.push_back(
            {T_world_segment * source.p_segment_source_m, T_world_segment.linear() * source.normal_segment});
    }
    return places;
}

}  // namespace noctule
