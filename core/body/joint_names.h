// SPDX-License-Identifier: Apache-2.0
// Joints of skeletons that other programs named, and of the other side.
#pragma once

#include <string>

#include "core/body/skeleton.h"

namespace noctule {

/// The joint of that name, else the one to which another program gives it (Joint::aliases); -1 without.
int findByAnyName(const Skeleton& skeleton, const std::string& name);

/// "LeftLeg" <-> "RightLeg"; others stay.
std::string mirroredSegment(const std::string& segment);

}  // namespace noctule
