// SPDX-License-Identifier: Apache-2.0
// Skeletons of other programs with all their bones, fingers, face, twist bones and what else could be taken
// for a joint: each joint finds its own.
#include <gtest/gtest.h>

#include "core/mesh/rig/bone_map.h"

namespace noctule {
namespace {

/// "Hips(Spine(Head) LeftUpLeg)": in brackets the bones that hang on the one before.
RiggedMesh rigOf(const std::string& text) {
    RiggedMesh rig;
    std::vector<int> above = {-1};
    std::string name;
    const auto end = [&] {
        if (!name.empty())
            rig.nodes.push_back({name, above.back()});
        name.clear();
    };
    for (const char c : text) {
        if (c != '(' && c != ')' && c != ' ') {
            name += c;
            continue;
        }
        const bool is_new = !name.empty();
        end();
        if (c == '(' && is_new)
            above.push_back(static_cast<int>(rig.nodes.size()) - 1);
        if (c == ')')
            above.pop_back();
    }
    end();
    return rig;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

struct BoneList {
    const char *program, *left, *right;
    const char* trunk;  ///< with ARMS and LEGS where limbs hang
    const char *arm, *leg;
    /// Hips, Spine, Chest, Neck, Head; Shoulder, Arm, ForeArm, Hand, UpLeg, Leg, Foot, ToeBase; "" for none.
    std::array<const char*, 13> names;
};

constexpr const char* kJoints[] = {"Hips",     "Spine", "Chest",  "Neck", "Head",  "%Shoulder", "%Arm",
                                   "%ForeArm", "%Hand", "%UpLeg", "%Leg", "%Foot", "%ToeBase"};

constexpr BoneList kBoneLists[] = {
    {"Mixamo",
     "Left",
     "Right",
     "Armature(mixamorig:Hips(mixamorig:Spine(mixamorig:Spine1(mixamorig:Spine2(mixamorig:Neck(mixamorig:"
     "Head("
     "mixamorig:HeadTop_End mixamorig:LeftEye mixamorig:RightEye)) ARMS))) LEGS) Beta_Surface Beta_Joints)",
     "mixamorig:%Shoulder(mixamorig:%Arm(mixamorig:%ForeArm(mixamorig:%Hand(mixamorig:%HandThumb1("
     "mixamorig:%HandThumb2(mixamorig:%HandThumb3(mixamorig:%HandThumb4))) mixamorig:%HandIndex1("
     "mixamorig:%HandIndex2(mixamorig:%HandIndex3(mixamorig:%HandIndex4))) mixamorig:%HandMiddle1("
     "mixamorig:%HandMiddle2(mixamorig:%HandMiddle3(mixamorig:%HandMiddle4))) mixamorig:%HandRing1("
     "mixamorig:%HandRing2(mixamorig:%HandRing3(mixamorig:%HandRing4))) mixamorig:%HandPinky1("
     "mixamorig:%HandPinky2(mixamorig:%HandPinky3(mixamorig:%HandPinky4)))))))",
     "mixamorig:%UpLeg(mixamorig:%Leg(mixamorig:%Foot(mixamorig:%ToeBase(mixamorig:%Toe_End))))",
     {"mixamorig:Hips", "mixamorig:Spine", "mixamorig:Spine2", "mixamorig:Neck", "mixamorig:Head",
      "mixamorig:%Shoulder", "mixamorig:%Arm", "mixamorig:%ForeArm", "mixamorig:%Hand", "mixamorig:%UpLeg",
      "mixamorig:%Leg", "mixamorig:%Foot", "mixamorig:%ToeBase"}},
    {"HumanIK, all of a character's definition",
     "Left",
     "Right",
     "Reference(Hips(HipsTranslation LEGS Spine(Spine1(Spine2(Spine3(Spine4(Spine5(Neck(Neck1(Neck2(Head)))"
     " ARMS)))))))",
     "%Shoulder(%ShoulderExtra %Arm(%ArmRoll %LeafArmRoll1 %ForeArm(%ForeArmRoll %LeafForeArmRoll1 %Hand("
     "%FingerBase(%HandThumb1(%HandThumb2(%HandThumb3(%HandThumb4))) %InHandIndex(%HandIndex1(%HandIndex2("
     "%HandIndex3(%HandIndex4)))) %InHandMiddle(%HandMiddle1(%HandMiddle2)) %InHandRing(%HandRing1)"
     " %InHandPinky(%HandPinky1) %HandExtraFinger1)))))",
     "%UpLeg(%UpLegRoll %LeafUpLegRoll1 %Leg(%LegRoll %LeafLegRoll1 %Foot(%ToeBase(%FootThumb1 %FootIndex1"
     " %FootMiddle1 %FootRing1 %FootPinky1 %FootExtraFinger1))))",
     {"Hips", "Spine", "Spine5", "Neck", "Head", "%Shoulder", "%Arm", "%ForeArm", "%Hand", "%UpLeg", "%Leg",
      "%Foot", "%ToeBase"}},
    {"VRM 1.0's humanoid",
     "left",
     "right",
     "root(hips(spine(chest(upperChest(neck(head(leftEye rightEye jaw)) ARMS))) LEGS))",
     "%Shoulder(%UpperArm(%LowerArm(%Hand(%ThumbMetacarpal(%ThumbProximal(%ThumbDistal)) %IndexProximal("
     "%IndexIntermediate(%IndexDistal)) %MiddleProximal(%MiddleIntermediate(%MiddleDistal)) %RingProximal("
     "%RingIntermediate(%RingDistal)) %LittleProximal(%LittleIntermediate(%LittleDistal))))))",
     "%UpperLeg(%LowerLeg(%Foot(%Toes)))",
     {"hips", "spine", "upperChest", "neck", "head", "%Shoulder", "%UpperArm", "%LowerArm", "%Hand",
      "%UpperLeg", "%LowerLeg", "%Foot", "%Toes"}},
    {"VRoid Studio",
     "L",
     "R",
     "Root(J_Bip_C_Hips(J_Bip_C_Spine(J_Bip_C_Chest(J_Sec_L_Bust1(J_Sec_L_Bust2) J_Sec_R_Bust1(J_Sec_R_Bust2)"
     " J_Bip_C_UpperChest(J_Bip_C_Neck(J_Bip_C_Head(J_Adj_L_FaceEye J_Adj_R_FaceEye J_Sec_Hair1_01("
     "J_Sec_Hair2_01))) ARMS))) LEGS)) Face Body Hair",
     "J_Bip_%_Shoulder(J_Bip_%_UpperArm(J_Bip_%_LowerArm(J_Bip_%_Hand(J_Bip_%_Index1(J_Bip_%_Index2("
     "J_Bip_%_Index3)) J_Bip_%_Little1(J_Bip_%_Little2(J_Bip_%_Little3)) J_Bip_%_Middle1 J_Bip_%_Ring1"
     " J_Bip_%_Thumb1)) J_Sec_%_TopsUpperArmInside(J_Sec_%_TopsUpperArmInside_end)))",
     "J_Bip_%_UpperLeg(J_Sec_%_SkirtFront0_01 J_Bip_%_LowerLeg(J_Bip_%_Foot(J_Bip_%_ToeBase)))",
     {"J_Bip_C_Hips", "J_Bip_C_Spine", "J_Bip_C_UpperChest", "J_Bip_C_Neck", "J_Bip_C_Head",
      "J_Bip_%_Shoulder", "J_Bip_%_UpperArm", "J_Bip_%_LowerArm", "J_Bip_%_Hand", "J_Bip_%_UpperLeg",
      "J_Bip_%_LowerLeg", "J_Bip_%_Foot", "J_Bip_%_ToeBase"}},
    {"Rigify's human metarig",
     "L",
     "R",
     "metarig(spine(spine.001(spine.002(spine.003(spine.004(spine.005(spine.006(face(nose(nose.001) lip.T.L"
     " lip.B.L jaw(chin) ear.L(ear.L.001) ear.R lid.T.L forehead.L temple.L brow.T.L eye.L eye.R cheek.T.L"
     " teeth.T tongue(tongue.001))))) ARMS breast.L breast.R))) pelvis.L pelvis.R LEGS))",
     "shoulder.%(upper_arm.%(forearm.%(hand.%(palm.01.%(f_index.01.%(f_index.02.%(f_index.03.%)) thumb.01.%("
     "thumb.02.%(thumb.03.%))) palm.02.%(f_middle.01.%) palm.03.%(f_ring.01.%) palm.04.%(f_pinky.01.%)))))",
     "thigh.%(shin.%(foot.%(toe.% heel.02.%)))",
     {"spine", "spine.001", "spine.003", "spine.004", "spine.006", "shoulder.%", "upper_arm.%", "forearm.%",
      "hand.%", "thigh.%", "shin.%", "foot.%", "toe.%"}},
    {"Rigify's deform bones in one tree",
     "L",
     "R",
     "rig(DEF-spine(DEF-pelvis.L DEF-pelvis.R LEGS DEF-spine.001(DEF-spine.002(DEF-spine.003(DEF-breast.L"
     " DEF-breast.R DEF-spine.004(DEF-spine.005(DEF-spine.006(DEF-forehead.L DEF-jaw DEF-chin DEF-ear.L)))"
     " ARMS)))))",
     "DEF-shoulder.%(DEF-upper_arm.%(DEF-upper_arm.%.001(DEF-forearm.%(DEF-forearm.%.001(DEF-hand.%("
     "DEF-palm.01.%(DEF-f_index.01.% DEF-thumb.01.%)))))))",
     "DEF-thigh.%(DEF-thigh.%.001(DEF-shin.%(DEF-shin.%.001(DEF-foot.%(DEF-toe.%)))))",
     {"DEF-spine", "DEF-spine.001", "DEF-spine.003", "DEF-spine.004", "DEF-spine.006", "DEF-shoulder.%",
      "DEF-upper_arm.%", "DEF-forearm.%", "DEF-hand.%", "DEF-thigh.%", "DEF-shin.%", "DEF-foot.%",
      "DEF-toe.%"}},
    {"CMU's BVH",
     "Left",
     "Right",
     "Hips(LHipJoint(LEFTLEG) RHipJoint(RIGHTLEG) LowerBack(Spine(Spine1(Neck(Neck1(Head)) ARMS))))",
     "%Shoulder(%Arm(%ForeArm(%Hand(%FingerBase(%HandIndex1) %Thumb))))",
     "%UpLeg(%Leg(%Foot(%ToeBase)))",
     {"Hips", "LowerBack", "Spine1", "Neck", "Head", "%Shoulder", "%Arm", "%ForeArm", "%Hand", "%UpLeg",
      "%Leg", "%Foot", "%ToeBase"}},
    {"CMU's ASF",
     "l",
     "r",
     "root(LEGS lowerback(upperback(thorax(lowerneck(upperneck(head)) ARMS))))",
     "%clavicle(%humerus(%radius(%wrist(%hand(%fingers) %thumb))))",
     "%hipjoint(%femur(%tibia(%foot(%toes))))",
     {"root", "lowerback", "thorax", "lowerneck", "head", "%clavicle", "%humerus", "%radius", "%wrist",
      "%femur", "%tibia", "%foot", "%toes"}},
    {"MakeHuman's rig for games, and Unreal's",
     "l",
     "r",
     "Root(pelvis(spine_01(spine_02(spine_03(neck_01(head) ARMS))) LEGS) ik_foot_root(ik_foot_l ik_foot_r)"
     " ik_hand_root(ik_hand_gun(ik_hand_l ik_hand_r)))",
     "clavicle_%(upperarm_%(upperarm_twist_01_% lowerarm_%(lowerarm_twist_01_% hand_%(index_01_%(index_02_%("
     "index_03_%)) middle_01_% pinky_01_% ring_01_% thumb_01_%(thumb_02_%(thumb_03_%))))))",
     "thigh_%(thigh_twist_01_% calf_%(calf_twist_01_% foot_%(ball_%)))",
     {"pelvis", "spine_01", "spine_03", "neck_01", "head", "clavicle_%", "upperarm_%", "lowerarm_%", "hand_%",
      "thigh_%", "calf_%", "foot_%", "ball_%"}},
    {"Xsens MVN's segments",
     "Left",
     "Right",
     "Pelvis(L5(L3(T12(T8(Neck(Head) ARMS)))) LEGS)",
     "%Shoulder(%UpperArm(%ForeArm(%Hand(%Carpus %FirstMC(%FirstPP(%FirstDP)) %SecondMC(%SecondPP("
     "%SecondMP(%SecondDP)))))))",
     "%UpperLeg(%LowerLeg(%Foot(%Toe)))",
     {"Pelvis", "L5", "T8", "Neck", "Head", "%Shoulder", "%UpperArm", "%ForeArm", "%Hand", "%UpperLeg",
      "%LowerLeg", "%Foot", "%Toe"}},
    {"Xsens MVN's BVH",
     "Left",
     "Right",
     "Hips(Chest(Chest2(Chest3(Chest4(Neck(Head) ARMS)))) LEGS)",
     "%Collar(%Shoulder(%Elbow(%Wrist)))",
     "%Hip(%Knee(%Ankle(%Toe)))",
     {"Hips", "Chest", "Chest4", "Neck", "Head", "%Collar", "%Shoulder", "%Elbow", "%Wrist", "%Hip", "%Knee",
      "%Ankle", "%Toe"}},
};

std::string treeOf(const BoneList& list) {
    const auto sided = [](const char* limb, const char* side) { return replaced(limb, "%", side); };
    std::string text =
        replaced(list.trunk, "ARMS", sided(list.arm, list.left) + " " + sided(list.arm, list.right));
    text = replaced(text, "LEFTLEG", sided(list.leg, list.left));
    text = replaced(text, "RIGHTLEG", sided(list.leg, list.right));
    return replaced(text, "LEGS", sided(list.leg, list.left) + " " + sided(list.leg, list.right));
}

TEST(BoneLists, EveryJointFindsItsBoneAmongAllOthers) {
    for (const BoneList& list : kBoneLists) {
        const RiggedMesh rig = rigOf(treeOf(list));
        BoneMap expected;
        for (size_t j = 0; j < list.names.size(); ++j)
            for (const auto& [side, called] : {std::pair{"Left", list.left}, {"Right", list.right}})
                expected.node_of_joint[replaced(kJoints[j], "%", side)] =
                    replaced(list.names[j], "%", called);
        EXPECT_EQ(findBoneMap(rig).node_of_joint, expected.node_of_joint) << list.program;
        EXPECT_TRUE(checkBoneMap(expected, rig, list.program)) << list.program;
    }
}

}  // namespace
}  // namespace noctule
