// SPDX-License-Identifier: Apache-2.0
#include "core/body/joint_names.h"

namespace noctule {
namespace {

constexpr const char* kSegmentSides[] = {"Left", "Right"};

}  // namespace

int findByAnyName(const Skeleton& skeleton, const std::string& name) {
    if (const int joint = skeleton.find(name); joint >= 0)
        return joint;
    for (int j = 0; j < skeleton.size(); ++j)
        for (const auto& [program, alias] : skeleton.joint(j).aliases)
            if (alias == name)
                return j;
    return -1;
}

std::string mirroredSegment(const std::string& segment) {
    for (const int side : {0, 1})
        if (segment.starts_with(kSegmentSides[side]))
            return kSegmentSides[1 - side] + segment.substr(std::string(kSegmentSides[side]).size());
    return segment;
}

}  // namespace noctule
