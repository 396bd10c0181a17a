// SPDX-License-Identifier: Apache-2.0
// The table of bone names: what programs, data sets and file formats call our joints. One bone at a time;
// bone_names.h resolves with the hierarchy what a name alone leaves open.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace noctule {

/// What a joint does in a body, without its side. From the hips outwards in every limb.
enum class JointRole {
    kHips,
    kSpine,
    kChest,
    kNeck,
    kHead,
    kShoulder,
    kArm,
    kForeArm,
    kHand,
    kUpLeg,
    kLeg,
    kFoot,
    kToeBase
};

enum class BodySide { kMiddle, kLeft, kRight };

/// The canonical joint: "LeftForeArm".
std::string canonicalJoint(JointRole role, BodySide side);

/// One reading of a name. Score: 0..3.1, how surely the name means the role; larger wins.
struct RoleReading {
    JointRole role;
    double score;
};

/// A name taken apart. Namespaces are dropped ("mixamorig:", "Actor 01:").
struct BoneSpelling {
    std::string
        prefix;  ///< words before the name proper, "character1", or behind it, "...jnt"; empty without
    BodySide side = BodySide::kMiddle;
    std::string base;                   ///< small letters without separators and side: "upperarm"
    std::vector<RoleReading> readings;  ///< empty: the name is not in the table
    /// Place along the spine from the hips up, of a vertebra; larger is higher. Only the order counts.
    std::optional<double> vertebra;

    bool isKnown() const { return !readings.empty() || vertebra.has_value(); }
};

/// Twist, roll, IK, tip, hair, skirt and finger bones are not in the table. A prefix that no program is known
/// for stands in `prefix`; bone_names.h believes it when a whole body carries it.
BoneSpelling spellingOf(const std::string& name);

/// Whether a prefix is one of those that programs put before all their bones: "DEF", "Bip01", "J_Bip_C".
bool isKnownPrefix(const std::string& prefix);

}  // namespace noctule
