// SPDX-License-Identifier: Apache-2.0
// Which bone of a motion, a reference or a mesh is which canonical joint, by the names of all its bones
// (bone_spelling.h) and the tree in which they hang. The tree decides what a name leaves open: limbs are the
// chains that explain most bones, the hips are where legs and trunk part, the chest is where the arms part.
// Knows HumanIK, Mixamo, 3ds Max's Biped, Poser, Daz, CMU (BVH and ASF), VRM, VRoid, CATS, Rigify, Unreal,
// Xsens, Motive, Axis Neuron, Rokoko, SMPL, MocapNET, MakeHuman, Kinect and MMD in Japanese and English.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/body/bone_spelling.h"

namespace noctule {

struct NamedBone {
    std::string name;
    int parent = -1;         ///< comes before it; all -1: a list without a tree, such as a table's columns
    bool moves_skin = true;  ///< false: taken only where no other bone of that name moves the skin
};

struct NamedJoints {
    std::map<std::string, int> bone_of_joint;  ///< canonical joint -> index of its bone
    std::vector<int> trunk;                    ///< from just above the hips up to the chest
    std::vector<int> neck;                     ///< from just above the chest up to the head
};

/// What the names say; joints that they do not name are absent. Of several bodies the first whole one.
/// Every bone plays one joint at most, and hangs below that of the joint's parent.
NamedJoints jointsByName(const std::vector<NamedBone>& bones);

/// The joints without which a body cannot move as ours: hips, spine, head and the three joints of each limb.
const std::vector<std::string>& mainJoints();
/// Those of mainJoints() that are not in the map.
std::vector<std::string> missingMainJoints(const std::map<std::string, int>& bone_of_joint);

}  // namespace noctule
