// SPDX-License-Identifier: Apache-2.0
// A body that moves as a performer does and is as large as the performer, as views, pictures and films draw
// it: ours in the performer's measures, or that of another program, scaled by the length of its legs.
#pragma once

#include <memory>
#include <optional>

#include "core/mesh/retarget/foot_lock.h"
#include "core/mesh/rig/wearable.h"
#include "core/mesh/skinning.h"

namespace noctule {

class MovingBody {
public:
    MovingBody() = default;  ///< draws nothing

    /// `ours` is in the measures of the default actor.
    static MovingBody ofOurs(const SkinnedMesh& ours, const Skeleton& performer, const FeetAtRest& feet);
    /// kUnusable as Retargeter::make().
    static Result<MovingBody> of(std::shared_ptr<const WearableBody> body, const Skeleton& performer,
                                 const FeetAtRest& feet);

    /// The same pointer as long as the body lives, so that it is uploaded once; null of an empty one.
    const std::shared_ptr<const SkinnedMesh>& mesh() const { return mesh_; }
    /// Per bone of the mesh, mesh -> world.
    std::vector<Eigen::Matrix4f> skinMatrices(const Pose& pose, const FootCorrections& feet = {}) const;
    /// As lockFeet(); nothing for ours, whose legs are the performer's.
    std::vector<FootCorrections> lockedFeet(const StandingFeet& feet) const;

private:
    Skeleton performer_;
    std::shared_ptr<const SkinnedMesh> mesh_;
    std::shared_ptr<const WearableBody> body_;  ///< null: ours
    std::optional<Retargeter> retargeter_;
};

/// Of the map's bones those for joints that the performer has; the main ones stay, so that errors name them.
BoneMap bonesFor(const BoneMap& bones, const Skeleton& performer);

}  // namespace noctule
