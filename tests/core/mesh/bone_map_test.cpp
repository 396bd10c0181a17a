// SPDX-License-Identifier: Apache-2.0
// Bones of other programs find their joints by name, by shape where names say nothing, and by hand.
#include "core/mesh/rig/bone_map.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"
#include "tests/support/files.h"
#include "tests/support/named_rig.h"
#include "tests/support/shared_meshes.h"

namespace noctule {
namespace {

using test::namedRig;

constexpr std::array kTableJoints = {"Hips",    "Spine", "Chest", "Neck", "Head", "Shoulder", "Arm",
                                     "ForeArm", "Hand",  "UpLeg", "Leg",  "Foot", "ToeBase"};

/// What a program calls the joints of the table, with %s for the side of a limb.
struct NamedConvention {
    const char *program, *left, *right;
    std::array<const char*, kTableJoints.size()> names;
};

constexpr NamedConvention kNamedConventions[] = {
    {"HumanIK",
     "Left",
     "Right",
     {"Hips", "Spine", "Spine2", "Neck", "Head", "%sShoulder", "%sArm", "%sForeArm", "%sHand", "%sUpLeg",
      "%sLeg", "%sFoot", "%sToeBase"}},
    {"HumanIK with its character's name",
     "Left",
     "Right",
     {"Character1_Hips", "Character1_Spine", "Character1_Spine2", "Character1_Neck", "Character1_Head",
      "Character1_%sShoulder", "Character1_%sArm", "Character1_%sForeArm", "Character1_%sHand",
      "Character1_%sUpLeg", "Character1_%sLeg", "Character1_%sFoot", "Character1_%sToeBase"}},
    {"Mixamo",
     "Left",
     "Right",
     {"mixamorig:Hips", "mixamorig:Spine", "mixamorig:Spine2", "mixamorig:Neck", "mixamorig:Head",
      "mixamorig:%sShoulder", "mixamorig:%sArm", "mixamorig:%sForeArm", "mixamorig:%sHand",
      "mixamorig:%sUpLeg", "mixamorig:%sLeg", "mixamorig:%sFoot", "mixamorig:%sToeBase"}},
    {"VRM",
     "left",
     "right",
     {"hips", "spine", "upperChest", "neck", "head", "%sShoulder", "%sUpperArm", "%sLowerArm", "%sHand",
      "%sUpperLeg", "%sLowerLeg", "%sFoot", "%sToes"}},
    {"VRoid",
     "L",
     "R",
     {"J_Bip_C_Hips", "J_Bip_C_Spine", "J_Bip_C_UpperChest", "J_Bip_C_Neck", "J_Bip_C_Head",
      "J_Bip_%s_Shoulder", "J_Bip_%s_UpperArm", "J_Bip_%s_LowerArm", "J_Bip_%s_Hand", "J_Bip_%s_UpperLeg",
      "J_Bip_%s_LowerLeg", "J_Bip_%s_Foot", "J_Bip_%s_ToeBase"}},
    {"Rigify",
     "L",
     "R",
     {"spine", "spine.001", "spine.003", "spine.004", "spine.006", "shoulder.%s", "upper_arm.%s",
      "forearm.%s", "hand.%s", "thigh.%s", "shin.%s", "foot.%s", "toe.%s"}},
    {"Rigify's deform bones",
     "L",
     "R",
     {"DEF-spine", "DEF-spine.001", "DEF-spine.003", "DEF-spine.004", "DEF-spine.006", "DEF-shoulder.%s",
      "DEF-upper_arm.%s", "DEF-forearm.%s", "DEF-hand.%s", "DEF-thigh.%s", "DEF-shin.%s", "DEF-foot.%s",
      "DEF-toe.%s"}},
    {"CMU's BVH",
     "Left",
     "Right",
     {"Hips", "LowerBack", "Spine1", "Neck", "Head", "%sShoulder", "%sArm", "%sForeArm", "%sHand", "%sUpLeg",
      "%sLeg", "%sFoot", "%sToeBase"}},
    {"CMU's ASF",
     "l",
     "r",
     {"root", "lowerback", "thorax", "lowerneck", "head", "%sclavicle", "%shumerus", "%sradius", "%shand",
      "%sfemur", "%stibia", "%sfoot", "%stoes"}},
    {"MakeHuman",
     "L",
     "R",
     {"root", "spine05", "spine01", "neck01", "head", "clavicle.%s", "upperarm01.%s", "lowerarm01.%s",
      "wrist.%s", "upperleg01.%s", "lowerleg01.%s", "foot.%s", ""}},
    {"Xsens",
     "Left",
     "Right",
     {"Pelvis", "L5", "T8", "Neck", "Head", "%sShoulder", "%sUpperArm", "%sForeArm", "%sHand", "%sUpperLeg",
      "%sLowerLeg", "%sFoot", "%sToe"}},
    {"Unreal",
     "l",
     "r",
     {"pelvis", "spine_01", "spine_03", "neck_01", "head", "clavicle_%s", "upperarm_%s", "lowerarm_%s",
      "hand_%s", "thigh_%s", "calf_%s", "foot_%s", "ball_%s"}},
    {"Biped",
     "L",
     "R",
     {"Bip01 Pelvis", "Bip01 Spine", "Bip01 Spine2", "Bip01 Neck", "Bip01 Head", "Bip01 %s Clavicle",
      "Bip01 %s UpperArm", "Bip01 %s Forearm", "Bip01 %s Hand", "Bip01 %s Thigh", "Bip01 %s Calf",
      "Bip01 %s Foot", "Bip01 %s Toe0"}},
};

std::string inConvention(const NamedConvention& convention, std::string joint) {
    std::string side;
    for (const auto& [word, called] : {std::pair{"Left", convention.left}, {"Right", convention.right}})
        if (joint.starts_with(word)) {
            side = called;
            joint.erase(0, std::string(word).size());
        }
    const auto row = std::find(kTableJoints.begin(), kTableJoints.end(), joint) - kTableJoints.begin();
    std::string name = convention.names.at(static_cast<size_t>(row));
    const size_t at = name.find("%s");
    return at == std::string::npos ? name : name.replace(at, 2, side);
}

TEST(BoneMap, NamesOfOtherProgramsFindAllJoints) {
    for (const NamedConvention& convention : kNamedConventions) {
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
