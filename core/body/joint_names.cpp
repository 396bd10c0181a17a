// SPDX-License-Identifier: Apache-2.0
#include "core/body/joint_names.h"

namespace noctule {

int findByAnyName(const Skeleton& skeleton, const std::string& name) {
    if (const int joint = skeleton.find(name); joint >= 0)
        return joint;
    for (int j = 0; j < skeleton.size(); ++j)
        for (const auto& [program, alias] : skeleton.joint(j).aliases)
            if (alias == name)
                return j;
    return -1;
}

}  // namespace noctule
