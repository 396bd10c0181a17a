// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/retarget/moving_body.h"

#include <algorithm>

#include "core/body/actor.h"
#include "core/body/joint_names.h"
#include "core/mesh/retarget/fit_mesh.h"

namespace noctule {

BoneMap bonesFor(const BoneMap& bones, const Skeleton& performer) {
    BoneMap used = bones;
    const auto& main = mainJoints();
    std::erase_if(used.node_of_joint, [&](const auto& entry) {
        return findByAnyName(performer, entry.first) < 0 &&
               std::find(main.begin(), main.end(), entry.first) == main.end();
    });
    return used;
}

MovingBody MovingBody::ofOurs(const SkinnedMesh& ours, const Skeleton& performer, const FeetAtRest& feet) {
    MovingBody moving;
    moving.performer_ = performer;
    moving.mesh_ =
        std::make_shared<const SkinnedMesh>(fitted(ours, defaultActor().skeleton, performer, feet));
    return moving;
}

Result<MovingBody> MovingBody::of(std::shared_ptr<const WearableBody> body, const Skeleton& performer,
                                  const FeetAtRest& feet) {
    auto retargeter =
        Retargeter::make(body->mesh, bonesFor(body->bones, performer), performer, feet, body->name);
    if (!retargeter)
        return retargeter.error();
    MovingBody moving;
    moving.performer_ = performer;
    moving.mesh_ = {body, &body->mesh.skin};
    moving.body_ = std::move(body);
    moving.retargeter_ = std::move(*retargeter);
    return moving;
}

std::vector<Eigen::Matrix4f> MovingBody::skinMatrices(const Pose& pose, const FootCorrections& feet) const {
    if (!mesh_)
        return {};
    if (!body_)
        return noctule::skinMatrices(*mesh_, performer_, globalPose(performer_, pose));
    std::vector<Eigen::Matrix4f> matrices = noctule::skinMatrices(body_->mesh, retargeter_->pose(pose, feet));
    const auto larger = static_cast<float>(1 / retargeter_->scale());
    for (Eigen::Matrix4f& matrix : matrices)
        matrix.topRows<3>() *= larger;
    return matrices;
}

std::vector<FootCorrections> MovingBody::lockedFeet(const StandingFeet& feet) const {
    return retargeter_ ? lockFeet(*retargeter_, feet) : std::vector<FootCorrections>();
}

}  // namespace noctule
