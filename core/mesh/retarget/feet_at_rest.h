// SPDX-License-Identifier: Apache-2.0
// How a performer's own feet are turned when their soles lie flat. A skeleton does not say: many have the
// legs apart in their zero pose, and the feet tilted with them. A motion in which feet stand does.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/body/skeleton.h"

namespace noctule {

/// When a foot stands; seconds of the motion's clock.
struct FootPlant {
    double from_s = 0, to_s = 0;
};
using FootPlants = std::array<std::vector<FootPlant>, 2>;  ///< left, right; in time's order

/// Unit vectors in the frames of the left and the right foot that point up when the sole is flat.
struct FeetAtRest {
    std::array<Vector3d, 2> up{Vector3d::UnitY(), Vector3d::UnitY()};

    bool operator==(const FeetAtRest&) const = default;
};

/// From the zero pose alone: feet are taken to be tilted sideways as the shins are.
FeetAtRest feetAtRest(const Skeleton& skeleton);

/// From those stands in which the foot was flattest, while it moved least. `pose` gives the motion at a time,
/// or nothing. A foot that hardly stands is left as feetAtRest(skeleton) says.
FeetAtRest feetAtRest(const Skeleton& skeleton, const FootPlants& plants,
                      const std::function<std::optional<Pose>(double t_s)>& pose);

}  // namespace noctule
