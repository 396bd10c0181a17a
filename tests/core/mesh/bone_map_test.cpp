// SPDX-License-Identifier: Apache-2.0
// Bones of other programs find their joints by name, by shape where names say nothing, and by hand.
#include "core/mesh/bone_map.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"
#include "tests/support/files.h"
#include "tests/support/named_rig.h"
#include "tests/support/shared_meshes.h"

namespace noctule {
namespace {

using test::namedRig;

/// A convention: what the trunk is called, and a limb's bone with %s for the side.
struct NamedConvention {
    const char* program;
    std::map<std::string, std::string> names;
    std::string left, right;
};

std::string inConvention(const NamedConvention& convention, const std::string& joint) {
    for (const auto& [word, side] : {std::pair{"Left", convention.left}, {"Right", convention.right}}) {
        if (!joint.starts_with(word))
            continue;
        std::string name = convention.names.at(joint.substr(std::string(word).size()));
        const size_t at = name.find("%s");
        return at == std::string::npos ? name : name.replace(at, 2, side);
    }
    return convention.names.at(joint);
}

const std::vector<NamedConvention>& namedConventions() {
    static const std::vector<NamedConvention> known = {{"HumanIK",
                                                        {{"Hips", "Hips"},
                                                         {"Spine", "Spine"},
                                                         {"Chest", "Spine2"},
                                                         {"Neck", "Neck"},
                                                         {"Head", "Head"},
                                                         {"Shoulder", "%sShoulder"},
                                                         {"Arm", "%sArm"},
                                                         {"ForeArm", "%sForeArm"},
                                                         {"Hand", "%sHand"},
                                                         {"UpLeg", "%sUpLeg"},
                                                         {"Leg", "%sLeg"},
                                                         {"Foot", "%sFoot"},
                                                         {"ToeBase", "%sToeBase"}},
                                                        "Left",
                                                        "Right"},
                                                       {"HumanIK with its character's name",
                                                        {{"Hips", "Character1_Hips"},
                                                         {"Spine", "Character1_Spine"},
                                                         {"Chest", "Character1_Spine2"},
                                                         {"Neck", "Character1_Neck"},
                                                         {"Head", "Character1_Head"},
                                                         {"Shoulder", "Character1_%sShoulder"},
                                                         {"Arm", "Character1_%sArm"},
                                                         {"ForeArm", "Character1_%sForeArm"},
                                                         {"Hand", "Character1_%sHand"},
                                                         {"UpLeg", "Character1_%sUpLeg"},
                                                         {"Leg", "Character1_%sLeg"},
                                                         {"Foot", "Character1_%sFoot"},
                                                         {"ToeBase", "Character1_%sToeBase"}},
                                                        "Left",
                                                        "Right"},
                                                       {"Mixamo",
                                                        {{"Hips", "mixamorig:Hips"},
                                                         {"Spine", "mixamorig:Spine"},
                                                         {"Chest", "mixamorig:Spine2"},
                                                         {"Neck", "mixamorig:Neck"},
                                                         {"Head", "mixamorig:Head"},
                                                         {"Shoulder", "mixamorig:%sShoulder"},
                                                         {"Arm", "mixamorig:%sArm"},
                                                         {"ForeArm", "mixamorig:%sForeArm"},
                                                         {"Hand", "mixamorig:%sHand"},
                                                         {"UpLeg", "mixamorig:%sUpLeg"},
                                                         {"Leg", "mixamorig:%sLeg"},
                                                         {"Foot", "mixamorig:%sFoot"},
                                                         {"ToeBase", "mixamorig:%sToeBase"}},
                                                        "Left",
                                                        "Right"},
                                                       {"VRM",
                                                        {{"Hips", "hips"},
                                                         {"Spine", "spine"},
                                                         {"Chest", "upperChest"},
                                                         {"Neck", "neck"},
                                                         {"Head", "head"},
                                                         {"Shoulder", "%sShoulder"},
                                                         {"Arm", "%sUpperArm"},
                                                         {"ForeArm", "%sLowerArm"},
                                                         {"Hand", "%sHand"},
                                                         {"UpLeg", "%sUpperLeg"},
                                                         {"Leg", "%sLowerLeg"},
                                                         {"Foot", "%sFoot"},
                                                         {"ToeBase", "%sToes"}},
                                                        "left",
                                                        "right"},
                                                       {"VRoid",
                                                        {{"Hips", "J_Bip_C_Hips"},
                                                         {"Spine", "J_Bip_C_Spine"},
                                                         {"Chest", "J_Bip_C_UpperChest"},
                                                         {"Neck", "J_Bip_C_Neck"},
                                                         {"Head", "J_Bip_C_Head"},
                                                         {"Shoulder", "J_Bip_%s_Shoulder"},
                                                         {"Arm", "J_Bip_%s_UpperArm"},
                                                         {"ForeArm", "J_Bip_%s_LowerArm"},
                                                         {"Hand", "J_Bip_%s_Hand"},
                                                         {"UpLeg", "J_Bip_%s_UpperLeg"},
                                                         {"Leg", "J_Bip_%s_LowerLeg"},
                                                         {"Foot", "J_Bip_%s_Foot"},
                                                         {"ToeBase", "J_Bip_%s_ToeBase"}},
                                                        "L",
                                                        "R"},
                                                       {"Rigify",
                                                        {{"Hips", "spine"},
                                                         {"Spine", "spine.001"},
                                                         {"Chest", "spine.003"},
                                                         {"Neck", "spine.004"},
                                                         {"Head", "spine.006"},
                                                         {"Shoulder", "shoulder.%s"},
                                                         {"Arm", "upper_arm.%s"},
                                                         {"ForeArm", "forearm.%s"},
                                                         {"Hand", "hand.%s"},
                                                         {"UpLeg", "thigh.%s"},
                                                         {"Leg", "shin.%s"},
                                                         {"Foot", "foot.%s"},
                                                         {"ToeBase", "toe.%s"}},
                                                        "L",
                                                        "R"},
                                                       {"Rigify's deform bones",
                                                        {{"Hips", "DEF-spine"},
                                                         {"Spine", "DEF-spine.001"},
                                                         {"Chest", "DEF-spine.003"},
                                                         {"Neck", "DEF-spine.004"},
                                                         {"Head", "DEF-spine.006"},
                                                         {"Shoulder", "DEF-shoulder.%s"},
                                                         {"Arm", "DEF-upper_arm.%s"},
                                                         {"ForeArm", "DEF-forearm.%s"},
                                                         {"Hand", "DEF-hand.%s"},
                                                         {"UpLeg", "DEF-thigh.%s"},
                                                         {"Leg", "DEF-shin.%s"},
                                                         {"Foot", "DEF-foot.%s"},
                                                         {"ToeBase", "DEF-toe.%s"}},
                                                        "L",
                                                        "R"},
                                                       {"CMU's BVH",
                                                        {{"Hips", "Hips"},
                                                         {"Spine", "LowerBack"},
                                                         {"Chest", "Spine1"},
                                                         {"Neck", "Neck"},
                                                         {"Head", "Head"},
                                                         {"Shoulder", "%sShoulder"},
                                                         {"Arm", "%sArm"},
                                                         {"ForeArm", "%sForeArm"},
                                                         {"Hand", "%sHand"},
                                                         {"UpLeg", "%sUpLeg"},
                                                         {"Leg", "%sLeg"},
                                                         {"Foot", "%sFoot"},
                                                         {"ToeBase", "%sToeBase"}},
                                                        "Left",
                                                        "Right"},
                                                       {"CMU's ASF",
                                                        {{"Hips", "root"},
                                                         {"Spine", "lowerback"},
                                                         {"Chest", "thorax"},
                                                         {"Neck", "lowerneck"},
                                                         {"Head", "head"},
                                                         {"Shoulder", "%sclavicle"},
                                                         {"Arm", "%shumerus"},
                                                         {"ForeArm", "%sradius"},
                                                         {"Hand", "%shand"},
                                                         {"UpLeg", "%sfemur"},
                                                         {"Leg", "%stibia"},
                                                         {"Foot", "%sfoot"},
                                                         {"ToeBase", "%stoes"}},
                                                        "l",
                                                        "r"},
                                                       {"MakeHuman",
                                                        {{"Hips", "root"},
                                                         {"Spine", "spine05"},
                                                         {"Chest", "spine01"},
                                                         {"Neck", "neck01"},
                                                         {"Head", "head"},
                                                         {"Shoulder", "clavicle.%s"},
                                                         {"Arm", "upperarm01.%s"},
                                                         {"ForeArm", "lowerarm01.%s"},
                                                         {"Hand", "wrist.%s"},
                                                         {"UpLeg", "upperleg01.%s"},
                                                         {"Leg", "lowerleg01.%s"},
                                                         {"Foot", "foot.%s"},
                                                         {"ToeBase", ""}},
                                                        "L",
                                                        "R"},
                                                       {"Xsens",
                                                        {{"Hips", "Pelvis"},
                                                         {"Spine", "L5"},
                                                         {"Chest", "T8"},
                                                         {"Neck", "Neck"},
                                                         {"Head", "Head"},
                                                         {"Shoulder", "%sShoulder"},
                                                         {"Arm", "%sUpperArm"},
                                                         {"ForeArm", "%sForeArm"},
                                                         {"Hand", "%sHand"},
                                                         {"UpLeg", "%sUpperLeg"},
                                                         {"Leg", "%sLowerLeg"},
                                                         {"Foot", "%sFoot"},
                                                         {"ToeBase", "%sToe"}},
                                                        "Left",
                                                        "Right"},
                                                       {"Unreal",
                                                        {{"Hips", "pelvis"},
                                                         {"Spine", "spine_01"},
                                                         {"Chest", "spine_03"},
                                                         {"Neck", "neck_01"},
                                                         {"Head", "head"},
                                                         {"Shoulder", "clavicle_%s"},
                                                         {"Arm", "upperarm_%s"},
                                                         {"ForeArm", "lowerarm_%s"},
                                                         {"Hand", "hand_%s"},
                                                         {"UpLeg", "thigh_%s"},
                                                         {"Leg", "calf_%s"},
                                                         {"Foot", "foot_%s"},
                                                         {"ToeBase", "ball_%s"}},
                                                        "l",
                                                        "r"},
                                                       {"Biped",
                                                        {{"Hips", "Bip01 Pelvis"},
                                                         {"Spine", "Bip01 Spine"},
                                                         {"Chest", "Bip01 Spine2"},
                                                         {"Neck", "Bip01 Neck"},
                                                         {"Head", "Bip01 Head"},
                                                         {"Shoulder", "Bip01 %s Clavicle"},
                                                         {"Arm", "Bip01 %s UpperArm"},
                                                         {"ForeArm", "Bip01 %s Forearm"},
                                                         {"Hand", "Bip01 %s Hand"},
                                                         {"UpLeg", "Bip01 %s Thigh"},
                                                         {"Leg", "Bip01 %s Calf"},
                                                         {"Foot", "Bip01 %s Foot"},
                                                         {"ToeBase", "Bip01 %s Toe0"}},
                                                        "L",
                                                        "R"}};
    return known;
}

TEST(BoneMap, NamesOfOtherProgramsFindAllJoints) {
    for (const NamedConvention& convention : namedConventions()) {
        const auto called = [&](const std::string& joint) { return inConvention(convention, joint); };
        const RiggedMesh rig = namedRig(called);
        const BoneMap map = mapByNames(rig);
        for (const std::string& joint : canonicalJointNames()) {
            const auto found = map.node_of_joint.find(joint);
            EXPECT_EQ(found == map.node_of_joint.end() ? "" : found->second, called(joint))
                << convention.program << ": " << joint;
        }
        EXPECT_TRUE(checkBoneMap(map, rig, "rig")) << convention.program;
        EXPECT_EQ(findBoneMap(rig), map) << convention.program;
    }
}

TEST(BoneMap, NamesThatSayNothingFindNothingByName) {
    const RiggedMesh rig =
        namedRig([](const std::string& joint) { return "x" + std::to_string(joint.size()) + joint; });
    EXPECT_FALSE(missingMainJoints(mapByNames(rig)).empty());
}

TEST(BoneMap, ShapeFindsTheJointsOfNamelessBonesInTAndAPose) {
    int number = 0;
    std::map<std::string, std::string> names;
    const auto called = [&](const std::string& joint) {
        return names.try_emplace(joint, "bone_" + std::to_string(number++)).first->second;
    };
    for (const double lowered_deg : {0.0, 50.0}) {
        const RiggedMesh rig = namedRig(called, [&](const std::string& joint) {
            const double side = joint.starts_with("Left") ? -1 : 1;
            return joint.ends_with("Arm") && !joint.ends_with("ForeArm")
                       ? axisAngle(Vector3d::UnitZ(), side * radians(lowered_deg))
                       : Quaterniond::Identity();
        });
        const BoneMap map = findBoneMap(rig);
        EXPECT_TRUE(checkBoneMap(map, rig, "rig"));
        for (const std::string& joint : mainJoints())
            EXPECT_EQ(map.node_of_joint.contains(joint) ? map.node_of_joint.at(joint) : "", names[joint])
                << joint << " " << lowered_deg;
    }
}

TEST(BoneMap, CesiumManIsFoundByShape) {
    if (!test::isShared(test::kCesiumMan))
        GTEST_SKIP() << test::sayMissing(test::kCesiumMan);
    const BoneMap map = findBoneMap(test::sharedMesh(test::kCesiumMan));
    const std::map<std::string, std::string> expected = {{"Hips", "Skeleton_torso_joint_1"},
                                                         {"Spine", "Skeleton_torso_joint_2"},
                                                         {"Chest", "torso_joint_3"},
                                                         {"Neck", "Skeleton_neck_joint_1"},
                                                         {"Head", "Skeleton_neck_joint_2"},
                                                         {"LeftArm", "Skeleton_arm_joint_L__4_"},
                                                         {"LeftForeArm", "Skeleton_arm_joint_L__3_"},
                                                         {"LeftHand", "Skeleton_arm_joint_L__2_"},
                                                         {"RightArm", "Skeleton_arm_joint_R"},
                                                         {"RightForeArm", "Skeleton_arm_joint_R__2_"},
                                                         {"RightHand", "Skeleton_arm_joint_R__3_"},
                                                         {"LeftUpLeg", "leg_joint_L_1"},
                                                         {"LeftLeg", "leg_joint_L_2"},
                                                         {"LeftFoot", "leg_joint_L_3"},
                                                         {"LeftToeBase", "leg_joint_L_5"},
                                                         {"RightUpLeg", "leg_joint_R_1"},
                                                         {"RightLeg", "leg_joint_R_2"},
                                                         {"RightFoot", "leg_joint_R_3"},
                                                         {"RightToeBase", "leg_joint_R_5"}};
    EXPECT_EQ(map.node_of_joint, expected);
}

TEST(BoneMap, KenneyAndMakeHumanAreFoundByName) {
    if (!test::isShared(test::kKenney))
        GTEST_SKIP() << test::sayMissing(test::kKenney);
    const RiggedMesh kenney = test::sharedMesh(test::kKenney);
    BoneMap map = mapByNames(kenney);
    EXPECT_TRUE(checkBoneMap(map, kenney, "kenney"));
    EXPECT_EQ(map.node_of_joint.size(), 21U);
    EXPECT_EQ(map.node_of_joint["Chest"], "UpperChest");
    EXPECT_EQ(map.node_of_joint["LeftToeBase"], "LeftToes");
    const test::MakeHuman human;
    map = mapByNames(human.mesh());
    EXPECT_TRUE(checkBoneMap(map, human.mesh(), "MakeHuman"));
    EXPECT_EQ(map.node_of_joint.size(), 19U);  // its toes are ten
    EXPECT_EQ(map.node_of_joint["Chest"], "spine01");
    EXPECT_EQ(map.node_of_joint["RightHand"], "wrist.R");
}

TEST(BoneMap, WrongMapsAreRefusedByName) {
    const RiggedMesh rig = namedRig([](const std::string& joint) { return joint; });
    const BoneMap good = findBoneMap(rig);
    ASSERT_TRUE(checkBoneMap(good, rig, "rig"));
    const auto complaint = [&](const std::string& joint, const std::string& node) {
        BoneMap map = good;
        if (node.empty())
            map.node_of_joint.erase(joint);
        else
            map.node_of_joint[joint] = node;
        const Status checked = checkBoneMap(map, rig, "rig");
        return checked ? std::string() : checked.error().message;
    };
    EXPECT_EQ(complaint("Head", "Head"), "");
    EXPECT_NE(complaint("Head", "").find("no bone is Head"), std::string::npos);
    EXPECT_NE(complaint("Tail", "Head").find("no joint Tail"), std::string::npos);
    EXPECT_NE(complaint("Head", "Skull").find("no bone Skull"), std::string::npos);
    EXPECT_NE(complaint("Neck", "Head").find("both"), std::string::npos);
    EXPECT_NE(complaint("LeftHand", "Armature").find("does not hang"), std::string::npos);
}

TEST(BoneMap, IsKeptInAFile) {
    const test::Folder folder;
    const BoneMap map = findBoneMap(namedRig([](const std::string& joint) { return "mixamorig:" + joint; }));
    ASSERT_TRUE(writeBoneMap(folder.file("map.json"), map, false));
    EXPECT_FALSE(writeBoneMap(folder.file("map.json"), map, false));
    const auto again = readBoneMap(folder.file("map.json"));
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, map);
    for (const char* text : {"", "[]", "{}", R"({"format":"noctule-bone-map","version":2,"bones":{}})",
                             R"({"format":"noctule-bone-map","version":1,"bones":{"Hips":3}})"}) {
        test::writeBytes(folder.file("bad.json"), text);
        EXPECT_FALSE(readBoneMap(folder.file("bad.json"))) << text;
    }
}

}  // namespace
}  // namespace noctule
