// SPDX-License-Identifier: Apache-2.0
// The joints that two skeletons share, for comparing them. Joints are the same when their names are, when
// the table of bone names (body/bone_names.h) says so, or when one's name is an alias of the other's. A
// shared joint moves when it has freedom in both; its rotation is taken against the nearest ancestor that
// moves in both, so that a joint that only one of them can move (a neck, a twist bone) is composed into the
// joint below it instead of being charged to nobody.
#pragma once

#include <string>
#include <vector>

#include "core/body/skeleton.h"

namespace noctule {

struct CommonJoint {
    std::string name;       ///< as the first skeleton calls it
    int first = -1;         ///< index in the first skeleton
    int second = -1;        ///< index in the second
    bool moves = false;     ///< has freedom in both; the root always
    int ancestor = -1;      ///< index into the list: nearest moving common ancestor; -1 for the root
    bool composed = false;  ///< rotations of joints in between, in either skeleton, are included
};

/// The first skeleton's root first (with the joint of that name in the second, else with its root), then the
/// shared joints in the order of the first skeleton.
std::vector<CommonJoint> commonJoints(const Skeleton& first, const Skeleton& second);

}  // namespace noctule
