// SPDX-License-Identifier: Apache-2.0
#include "core/robot/driven_parts.h"

#include <algorithm>
#include <set>

namespace noctule::robot {

std::vector<const Chain*> DrivenParts::chains() const {
    std::vector<const Chain*> chains;
    for (const RobotArm& arm : arms)
        chains.push_back(&arm.chain);
    if (trunk)
        chains.push_back(&trunk->chain);
    return chains;
}

std::vector<std::string> DrivenParts::joints() const {
    std::vector<std::string> names;
    for (const Chain* chain : chains())
        for (const ChainJoint& joint : chain->joints())
            names.push_back(joint.name);
    return names;
}

std::vector<double> DrivenParts::speeds() const {
    std::vector<double> speeds;
    for (const RobotArm& arm : arms)
        speeds.insert(speeds.end(), arm.profile.max_speed.begin(), arm.profile.max_speed.end());
    if (trunk)
        speeds.insert(speeds.end(), trunk->max_speed.begin(), trunk->max_speed.end());
    return speeds;
}

std::vector<double> DrivenParts::reference() const {
    std::vector<double> values;
    for (const RobotArm& arm : arms)
        values.insert(values.end(), arm.reference.begin(), arm.reference.end());
    if (trunk)
        for (const ChainJoint& joint : trunk->chain.joints())
            values.push_back(std::clamp(0.0, joint.lower, joint.upper));
    return values;
}

Result<DrivenParts> drivenParts(const RobotModel& model, const RobotProfile& profile,
                                const MappingChoice& choice) {
    DrivenParts parts;
    for (const ArmProfile& wanted : profile.arms) {
        if (wanted.side == Side::kLeft ? !choice.left : !choice.right)
            continue;
        auto arm = makeArm(model, wanted);
        if (!arm)
            return arm.error();
        parts.arms.push_back(std::move(*arm));
    }
    if (parts.arms.empty())
        return Error{ErrorKind::kUnusable, "robot " + profile.robot + " has no arm on the side asked for",
                     "Choose another with --arms"};
    if (choice.trunk) {
        auto trunk = makeTrunk(model, profile);
        if (!trunk)
            return trunk.error();
        parts.trunk = std::move(*trunk);
    }
    std::set<std::string> seen;
    for (const std::string& joint : parts.joints())
        if (!seen.insert(joint).second)
            return Error{ErrorKind::kUnusable,
                         "robot " + profile.robot + ": joint \"" + joint + "\" belongs to two driven parts",
                         "Let the base of both arms lie above what they share, or choose one with --arms"};
    return parts;
}

}  // namespace noctule::robot
