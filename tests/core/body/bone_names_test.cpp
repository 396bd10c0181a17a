// SPDX-License-Identifier: Apache-2.0
// Every family of bone names: each canonical joint finds its bone on both sides, helpers are left out.
#include "core/body/bone_names.h"

#include <gtest/gtest.h>

#include <array>

namespace noctule {
namespace {

/// "Hips(Spine(Head) LeftUpLeg)": in brackets the bones that hang on the one before; "~" is a blank.
std::vector<NamedBone> bonesOf(const std::string& text) {
    std::vector<NamedBone> bones;
    std::vector<int> above = {-1};
    std::string name;
    const auto end = [&] {
        std::replace(name.begin(), name.end(), '~', ' ');
        if (!name.empty())
            bones.push_back({name, above.back()});
        name.clear();
    };
    for (const char c : text) {
        if (c != '(' && c != ')' && c != ' ') {
            name += c;
            continue;
        }
        end();
        if (c == '(')
            above.push_back(static_cast<int>(bones.size()) - 1);
        if (c == ')')
            above.pop_back();
    }
    end();
    return bones;
}

std::string with(std::string text, const std::string& what, const std::string& by) {
    for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

/// As jointsByName() found them: "Hips=Pelvis", with "%" for what both sides have alike.
std::map<std::string, std::string> namesOf(const std::vector<NamedBone>& bones) {
    std::map<std::string, std::string> names;
    for (const auto& [joint, bone] : jointsByName(bones).bone_of_joint)
        names[joint] = bones[static_cast<size_t>(bone)].name;
    return names;
}

constexpr std::array kJointsOfFamilies = {"Hips",     "Spine", "Chest",  "Neck", "Head",  "%Shoulder", "%Arm",
                                          "%ForeArm", "%Hand", "%UpLeg", "%Leg", "%Foot", "%ToeBase"};

struct Family {
    const char *program, *left, *right;
    const char *trunk, *arm, *leg;  ///< ARMS and LEGS stand where the limbs hang; "%" is the side
    /// In the order of kJointsOfFamilies; "" for none.
    std::array<const char*, kJointsOfFamilies.size()> names;
};

constexpr Family kFamilies[] = {
    {"HumanIK",
     "Left",
     "Right",
     "Reference(Hips(LEGS Spine(Spine1(Spine2(Neck(Head) ARMS)))))",
     "%Shoulder(%Arm(%ArmRoll %ForeArm(%ForeArmRoll %Hand(%HandThumb1 %HandIndex1))))",
     "%UpLeg(%UpLegRoll %Leg(%Foot(%ToeBase(%Toe_End))))",
     {"Hips", "Spine", "Spine2", "Neck", "Head", "%Shoulder", "%Arm", "%ForeArm", "%Hand", "%UpLeg", "%Leg",
      "%Foot", "%ToeBase"}},
    {"HumanIK with a character's name",
     "Left",
     "Right",
     "Character1_Reference(Character1_Hips(LEGS Character1_Spine(Character1_Neck(Character1_Head) ARMS)))",
     "Character1_%Shoulder(Character1_%Arm(Character1_%ForeArm(Character1_%Hand)))",
     "Character1_%UpLeg(Character1_%Leg(Character1_%Foot(Character1_%ToeBase)))",
     {"Character1_Hips", "Character1_Spine", "", "Character1_Neck", "Character1_Head", "Character1_%Shoulder",
      "Character1_%Arm", "Character1_%ForeArm", "Character1_%Hand", "Character1_%UpLeg", "Character1_%Leg",
      "Character1_%Foot", "Character1_%ToeBase"}},
    {"Mixamo without its colon",
     "Left",
     "Right",
     "mixamorigHips(LEGS mixamorigSpine(mixamorigSpine1(mixamorigSpine2(mixamorigNeck(mixamorigHead("
     "mixamorigHeadTop_End)) ARMS))))",
     "mixamorig%Shoulder(mixamorig%Arm(mixamorig%ForeArm(mixamorig%Hand(mixamorig%HandThumb1))))",
     "mixamorig%UpLeg(mixamorig%Leg(mixamorig%Foot(mixamorig%ToeBase(mixamorig%Toe_End))))",
     {"mixamorigHips", "mixamorigSpine", "mixamorigSpine2", "mixamorigNeck", "mixamorigHead",
      "mixamorig%Shoulder", "mixamorig%Arm", "mixamorig%ForeArm", "mixamorig%Hand", "mixamorig%UpLeg",
      "mixamorig%Leg", "mixamorig%Foot", "mixamorig%ToeBase"}},
    {"Mixamo, numbered by a shop",
     "Left",
     "Right",
     "_rootJoint(mixamorig:Hips_01(LEGS mixamorig:Spine_02(mixamorig:Spine1_03(mixamorig:Neck_04("
     "mixamorig:Head_05(mixamorig:HeadTop_End_06)) ARMS))))",
     "mixamorig:%Shoulder_07(mixamorig:%Arm_08(mixamorig:%ForeArm_09(mixamorig:%Hand_010)))",
     "mixamorig:%UpLeg_055(mixamorig:%Leg_056(mixamorig:%Foot_057(mixamorig:%ToeBase_058)))",
     {"mixamorig:Hips_01", "mixamorig:Spine_02", "mixamorig:Spine1_03", "mixamorig:Neck_04",
      "mixamorig:Head_05", "mixamorig:%Shoulder_07", "mixamorig:%Arm_08", "mixamorig:%ForeArm_09",
      "mixamorig:%Hand_010", "mixamorig:%UpLeg_055", "mixamorig:%Leg_056", "mixamorig:%Foot_057",
      "mixamorig:%ToeBase_058"}},
    {"3ds Max's Biped",
     "L",
     "R",
     "Bip01(Bip01~Footsteps Bip01~Pelvis(LEGS Bip01~Spine(Bip01~Spine1(Bip01~Spine2(Bip01~Neck(Bip01~Head("
     "Bip01~HeadNub)) ARMS)))))",
     "Bip01~%~Clavicle(Bip01~%~UpperArm(Bip01~%~UpArmTwist Bip01~%~Forearm(Bip01~%~ForeTwist Bip01~%~Hand("
     "Bip01~%~Finger0(Bip01~%~Finger0Nub)))))",
     "Bip01~%~Thigh(Bip01~%~Calf(Bip01~%~Foot(Bip01~%~Toe0(Bip01~%~Toe0Nub))))",
     {"Bip01 Pelvis", "Bip01 Spine", "Bip01 Spine2", "Bip01 Neck", "Bip01 Head", "Bip01 % Clavicle",
      "Bip01 % UpperArm", "Bip01 % Forearm", "Bip01 % Hand", "Bip01 % Thigh", "Bip01 % Calf", "Bip01 % Foot",
      "Bip01 % Toe0"}},
    {"Valve's Biped",
     "L",
     "R",
     "ValveBiped.Bip01_Pelvis(LEGS ValveBiped.Bip01_Spine(ValveBiped.Bip01_Spine4(ValveBiped.Bip01_Neck1("
     "ValveBiped.Bip01_Head1) ARMS)))",
     "ValveBiped.Bip01_%_Clavicle(ValveBiped.Bip01_%_UpperArm(ValveBiped.Bip01_%_Forearm("
     "ValveBiped.Bip01_%_Hand)))",
     "ValveBiped.Bip01_%_Thigh(ValveBiped.Bip01_%_Calf(ValveBiped.Bip01_%_Foot(ValveBiped.Bip01_%_Toe0)))",
     {"ValveBiped.Bip01_Pelvis", "ValveBiped.Bip01_Spine", "ValveBiped.Bip01_Spine4",
      "ValveBiped.Bip01_Neck1", "ValveBiped.Bip01_Head1", "ValveBiped.Bip01_%_Clavicle",
      "ValveBiped.Bip01_%_UpperArm", "ValveBiped.Bip01_%_Forearm", "ValveBiped.Bip01_%_Hand",
      "ValveBiped.Bip01_%_Thigh", "ValveBiped.Bip01_%_Calf", "ValveBiped.Bip01_%_Foot",
      "ValveBiped.Bip01_%_Toe0"}},
    {"Poser",
     "l",
     "r",
     "hip(LEGS abdomen(chest(neck(head(leftEye rightEye)) ARMS)))",
     "%Collar(%Shldr(%ForeArm(%Hand(%Thumb1 %Index1))))",
     "%Buttock(%Thigh(%Shin(%Foot(%Toe))))",
     {"hip", "abdomen", "chest", "neck", "head", "%Collar", "%Shldr", "%ForeArm", "%Hand", "%Thigh", "%Shin",
      "%Foot", "%Toe"}},
    {"Poser in small letters, arms on the neck",
     "l",
     "r",
     "hip(LEGS abdomen(chest(neck(neck1(head(jaw)) ARMS))))",
     "%collar(%shldr(%forearm(%hand(%thumb))))",
     "%buttock(%thigh(%shin(%foot(%toe))))",
     {"hip", "abdomen", "chest", "neck", "head", "%collar", "%shldr", "%forearm", "%hand", "%thigh", "%shin",
      "%foot", "%toe"}},
    {"Daz",
     "l",
     "r",
     "hip(pelvis(LEGS) abdomenLower(abdomenUpper(chestLower(chestUpper(neckLower(neckUpper(head)) ARMS "
     "lPectoral rPectoral)))))",
     "%Collar(%ShldrBend(%ShldrTwist(%ForearmBend(%ForearmTwist(%Hand(%Carpal1))))))",
     "%ThighBend(%ThighTwist(%Shin(%Foot(%Metatarsals(%Toe(%BigToe))))))",
     {"hip", "abdomenLower", "chestUpper", "neckLower", "head", "%Collar", "%ShldrBend", "%ForearmBend",
      "%Hand", "%ThighBend", "%Shin", "%Foot", "%Toe"}},
    {"CMU's ASF",
     "l",
     "r",
     "root(LEGS lowerback(upperback(thorax(lowerneck(upperneck(head)) ARMS))))",
     "%clavicle(%humerus(%radius(%wrist(%hand(%fingers) %thumb))))",
     "%hipjoint(%femur(%tibia(%foot(%toes))))",
     {"root", "lowerback", "thorax", "lowerneck", "head", "%clavicle", "%humerus", "%radius", "%wrist",
      "%femur", "%tibia", "%foot", "%toes"}},
    {"VRoid and VRM 0",
     "L",
     "R",
     "Root(J_Bip_C_Hips(LEGS J_Sec_L_SkirtFront0_01 J_Bip_C_Spine(J_Bip_C_Chest(J_Bip_C_UpperChest("
     "J_Bip_C_Neck(J_Bip_C_Head(J_Sec_Hair1_01)) ARMS)))))",
     "J_Bip_%_Shoulder(J_Bip_%_UpperArm(J_Sec_%_TopsUpperArm "
     "J_Bip_%_LowerArm(J_Bip_%_Hand(J_Bip_%_Index1))))",
     "J_Bip_%_UpperLeg(J_Bip_%_LowerLeg(J_Bip_%_Foot(J_Bip_%_ToeBase)))",
     {"J_Bip_C_Hips", "J_Bip_C_Spine", "J_Bip_C_UpperChest", "J_Bip_C_Neck", "J_Bip_C_Head",
      "J_Bip_%_Shoulder", "J_Bip_%_UpperArm", "J_Bip_%_LowerArm", "J_Bip_%_Hand", "J_Bip_%_UpperLeg",
      "J_Bip_%_LowerLeg", "J_Bip_%_Foot", "J_Bip_%_ToeBase"}},
    {"VRM's humanoid",
     "left",
     "right",
     "hips(LEGS spine(chest(upperChest(neck(head) ARMS))))",
     "%Shoulder(%UpperArm(%LowerArm(%Hand)))",
     "%UpperLeg(%LowerLeg(%Foot(%Toes)))",
     {"hips", "spine", "upperChest", "neck", "head", "%Shoulder", "%UpperArm", "%LowerArm", "%Hand",
      "%UpperLeg", "%LowerLeg", "%Foot", "%Toes"}},
    {"VRChat, mixed with Rigify",
     "L",
     "R",
     "hips(LEGS skirt_0_0(skirt_1_0) spine(belly(chest(neck(head(hair.L hair.R)) ARMS))))",
     "shoulder.%(upper_arm.%(upper_arm_twist.% forearm.%(hand.%(f_index.01.%))))",
     "thigh.%(skirt_leg.% shin.%(foot.%(toe.% heel.02.%)))",
     {"hips", "spine", "chest", "neck", "head", "shoulder.%", "upper_arm.%", "forearm.%", "hand.%", "thigh.%",
      "shin.%", "foot.%", "toe.%"}},
    {"CATS",
     "Left",
     "Right",
     "Armature(Hips(LEGS Spine(Chest(Neck(Head) ARMS))))",
     "%~shoulder(%~arm(%~elbow(%~wrist(%~Thumb1))))",
     "%~leg(%~knee(%~ankle(%~toe)))",
     {"Hips", "Spine", "Chest", "Neck", "Head", "% shoulder", "% arm", "% elbow", "% wrist", "% leg",
      "% knee", "% ankle", "% toe"}},
    {"Rigify's deform bones",
     "L",
     "R",
     "DEF-spine(LEGS DEF-pelvis.L DEF-spine.001(DEF-spine.002(DEF-spine.003(DEF-spine.004(DEF-spine.005("
     "DEF-spine.006)) ARMS))))",
     "DEF-shoulder.%(DEF-upper_arm.%(DEF-upper_arm.%.001(DEF-forearm.%(DEF-forearm.%.001(DEF-hand.%)))))",
     "DEF-thigh.%(DEF-thigh.%.001(DEF-shin.%(DEF-shin.%.001(DEF-foot.%(DEF-toe.%)))))",
     {"DEF-spine", "DEF-spine.001", "DEF-spine.003", "DEF-spine.004", "DEF-spine.006", "DEF-shoulder.%",
      "DEF-upper_arm.%", "DEF-forearm.%", "DEF-hand.%", "DEF-thigh.%", "DEF-shin.%", "DEF-foot.%",
      "DEF-toe.%"}},
    {"Unreal",
     "l",
     "r",
     "root(pelvis(LEGS spine_01(spine_02(spine_03(spine_04(spine_05(neck_01(neck_02(head)) ARMS))))))"
     " ik_foot_root(ik_foot_l ik_foot_r) ik_hand_root(ik_hand_l ik_hand_r))",
     "clavicle_%(upperarm_%(upperarm_twist_01_% lowerarm_%(lowerarm_twist_01_% hand_%)))",
     "thigh_%(thigh_twist_01_% calf_%(foot_%(ball_%)))",
     {"pelvis", "spine_01", "spine_05", "neck_01", "head", "clavicle_%", "upperarm_%", "lowerarm_%", "hand_%",
      "thigh_%", "calf_%", "foot_%", "ball_%"}},
    {"Xsens' segments",
     "Left",
     "Right",
     "Pelvis(L5(L3(T12(T8(Neck(Head) ARMS)))) LEGS)",
     "%Shoulder(%UpperArm(%ForeArm(%Hand)))",
     "%UpperLeg(%LowerLeg(%Foot(%Toe)))",
     {"Pelvis", "L5", "T8", "Neck", "Head", "%Shoulder", "%UpperArm", "%ForeArm", "%Hand", "%UpperLeg",
      "%LowerLeg", "%Foot", "%Toe"}},
    {"Xsens' BVH",
     "Left",
     "Right",
     "Hips(Chest(Chest2(Chest3(Chest4(Neck(Head) ARMS)))) LEGS)",
     "%Collar(%Shoulder(%Elbow(%Wrist)))",
     "%Hip(%Knee(%Ankle(%Toe)))",
     {"Hips", "Chest", "Chest4", "Neck", "Head", "%Collar", "%Shoulder", "%Elbow", "%Wrist", "%Hip", "%Knee",
      "%Ankle", "%Toe"}},
    {"Motive",
     "L",
     "R",
     "Hip(LEGS Ab(Chest(Neck(Head) ARMS)))",
     "%Shoulder(%UArm(%FArm(%Hand(%Thumb1))))",
     "%Thigh(%Shin(%Foot(%Toe)))",
     {"Hip", "Ab", "Chest", "Neck", "Head", "%Shoulder", "%UArm", "%FArm", "%Hand", "%Thigh", "%Shin",
      "%Foot", "%Toe"}},
    {"Axis Neuron",
     "Left",
     "Right",
     "Robot_Hips(LEGS Robot_Spine(Robot_Spine1(Robot_Neck(Robot_Head) ARMS)))",
     "Robot_%Shoulder(Robot_%Arm(Robot_%ForeArm(Robot_%Hand)))",
     "Robot_%UpLeg(Robot_%Leg(Robot_%Foot))",
     {"Robot_Hips", "Robot_Spine", "Robot_Spine1", "Robot_Neck", "Robot_Head", "Robot_%Shoulder",
      "Robot_%Arm", "Robot_%ForeArm", "Robot_%Hand", "Robot_%UpLeg", "Robot_%Leg", "Robot_%Foot", ""}},
    {"Rokoko with an actor's namespace",
     "Left",
     "Right",
     "Actor~01:Hips(LEGS Actor~01:Spine1(Actor~01:Spine2(Actor~01:Spine3(Actor~01:Spine4(Actor~01:Neck("
     "Actor~01:Head) ARMS)))))",
     "Actor~01:%Shoulder(Actor~01:%Arm(Actor~01:%ForeArm(Actor~01:%Hand)))",
     "Actor~01:%Thigh(Actor~01:%Shin(Actor~01:%Foot(Actor~01:%Toe(Actor~01:%ToeTip))))",
     {"Actor 01:Hips", "Actor 01:Spine1", "Actor 01:Spine4", "Actor 01:Neck", "Actor 01:Head",
      "Actor 01:%Shoulder", "Actor 01:%Arm", "Actor 01:%ForeArm", "Actor 01:%Hand", "Actor 01:%Thigh",
      "Actor 01:%Shin", "Actor 01:%Foot", "Actor 01:%Toe"}},
    {"SMPL",
     "L",
     "R",
     "Pelvis(LEGS Spine1(Spine2(Spine3(Neck(Head(Jaw)) ARMS))))",
     "%_Collar(%_Shoulder(%_Elbow(%_Wrist(%_Hand))))",
     "%_Hip(%_Knee(%_Ankle(%_Foot)))",
     {"Pelvis", "Spine1", "Spine3", "Neck", "Head", "%_Collar", "%_Shoulder", "%_Elbow", "%_Wrist", "%_Hip",
      "%_Knee", "%_Ankle", "%_Foot"}},
    {"SMPL in its FBX",
     "L",
     "R",
     "m_avg_root(m_avg_Pelvis(LEGS m_avg_Spine1(m_avg_Spine2(m_avg_Spine3(m_avg_Neck(m_avg_Head) ARMS)))))",
     "m_avg_%_Collar(m_avg_%_Shoulder(m_avg_%_Elbow(m_avg_%_Wrist(m_avg_%_Hand))))",
     "m_avg_%_Hip(m_avg_%_Knee(m_avg_%_Ankle(m_avg_%_Foot)))",
     {"m_avg_Pelvis", "m_avg_Spine1", "m_avg_Spine3", "m_avg_Neck", "m_avg_Head", "m_avg_%_Collar",
      "m_avg_%_Shoulder", "m_avg_%_Elbow", "m_avg_%_Wrist", "m_avg_%_Hip", "m_avg_%_Knee", "m_avg_%_Ankle",
      "m_avg_%_Foot"}},
    {"SMPL-X",
     "left",
     "right",
     "pelvis(LEGS spine1(spine2(spine3(neck(head(jaw)) ARMS))))",
     "%_collar(%_shoulder(%_elbow(%_wrist(%_index1))))",
     "%_hip(%_knee(%_ankle(%_foot)))",
     {"pelvis", "spine1", "spine3", "neck", "head", "%_collar", "%_shoulder", "%_elbow", "%_wrist", "%_hip",
      "%_knee", "%_ankle", "%_foot"}},
    {"MakeHuman",
     "L",
     "R",
     "root(spine05(spine04(spine03(spine02(spine01(neck01(neck02(neck03(head))) ARMS))))) pelvis.L(LEFTLEG)"
     " pelvis.R(RIGHTLEG))",
     "clavicle.%(shoulder01.%(upperarm01.%(upperarm02.%(lowerarm01.%(lowerarm02.%(wrist.%(metacarpal1.%))))))"
     ")",
     "upperleg01.%(upperleg02.%(lowerleg01.%(lowerleg02.%(foot.%(toe1-1.%(toe1-2.%))))))",
     {"root", "spine05", "spine01", "neck01", "head", "clavicle.%", "upperarm01.%", "lowerarm01.%", "wrist.%",
      "upperleg01.%", "lowerleg01.%", "foot.%", "toe1-1.%"}},
    {"Kinect",
     "Left",
     "Right",
     "SpineBase(LEGS SpineMid(SpineShoulder(Neck(Head) ARMS)))",
     "Shoulder%(Elbow%(Wrist%(Hand%(HandTip%) Thumb%)))",
     "Hip%(Knee%(Ankle%(Foot%)))",
     {"SpineBase", "SpineMid", "SpineShoulder", "Neck", "Head", "", "Shoulder%", "Elbow%", "Wrist%", "Hip%",
      "Knee%", "Ankle%", "Foot%"}},
    {"Capitals",
     "LEFT",
     "RIGHT",
     "PELVIS(LEGS SPINE_NAVEL(SPINE_CHEST(NECK(HEAD) ARMS)))",
     "CLAVICLE_%(SHOULDER_%(ELBOW_%(WRIST_%(HAND_%(HANDTIP_%)))))",
     "HIP_%(KNEE_%(ANKLE_%(FOOT_%)))",
     {"PELVIS", "SPINE_NAVEL", "SPINE_CHEST", "NECK", "HEAD", "CLAVICLE_%", "SHOULDER_%", "ELBOW_%",
      "WRIST_%", "HIP_%", "KNEE_%", "ANKLE_%", "FOOT_%"}},
    {"MMD",
     "左",
     "右",
     "全ての親(センター(グルーブ(腰(下半身(LEGS) 上半身(上半身2(首(頭(左目 右目)) ARMS)))))) ",
     "%肩(%腕(%腕捩 %ひじ(%手捩 %手首(%親指１))))",
     "%足(%ひざ(%足首(%つま先)) %足ＩＫ)",
     {"腰", "上半身", "上半身2", "首", "頭", "%肩", "%腕", "%ひじ", "%手首", "%足", "%ひざ", "%足首",
      "%つま先"}},
    {"MMD in Blender",
     "L",
     "R",
     "センター(下半身(LEGS) 上半身(上半身２(首(頭) ARMS)))",
     "肩.%(腕.%(ひじ.%(手首.%)))",
     "足.%(ひざ.%(足首.%(足先EX.%)))",
     {"センター", "上半身", "上半身２", "首", "頭", "肩.%", "腕.%", "ひじ.%", "手首.%", "足.%", "ひざ.%",
      "足首.%", "足先EX.%"}},
    {"MMD in English",
     "L",
     "R",
     "center(lower~body(LEGS) upper~body(upper~body2(neck(head) ARMS)))",
     "shoulder_%(arm_%(elbow_%(wrist_%)))",
     "leg_%(knee_%(ankle_%(toe_%)))",
     {"center", "upper body", "upper body2", "neck", "head", "shoulder_%", "arm_%", "elbow_%", "wrist_%",
      "leg_%", "knee_%", "ankle_%", "toe_%"}},
    {"joints with a word behind their names",
     "Left",
     "Right",
     "Root_jnt(Hips_jnt(LEGS Spine_jnt(Chest_jnt(Neck_jnt(Head_jnt) ARMS))))",
     "%Arm_jnt(%ForeArm_jnt(%Hand_jnt(%Hand_end)))",
     "%UpLeg_jnt(%Leg_jnt(%Foot_jnt(%Foot_ik)))",
     {"Hips_jnt", "Spine_jnt", "Chest_jnt", "Neck_jnt", "Head_jnt", "", "%Arm_jnt", "%ForeArm_jnt",
      "%Hand_jnt", "%UpLeg_jnt", "%Leg_jnt", "%Foot_jnt", ""}},
    {"a spine of one bone",
     "Left",
     "Right",
     "Hips(LEGS Spine(Neck(Head) ARMS))",
     "%Arm(%ForeArm(%Hand))",
     "%UpLeg(%Leg(%Foot))",
     {"Hips", "Spine", "", "Neck", "Head", "", "%Arm", "%ForeArm", "%Hand", "%UpLeg", "%Leg", "%Foot", ""}},
    {"hips between thighs and spine that are called hip joints",
     "Left",
     "Right",
     "Hips(LHipJoint(LEFTLEG) RHipJoint(RIGHTLEG) LowerBack(Spine(Spine1(Neck(Neck1(Head)) ARMS))))",
     "%Shoulder(%Arm(%ForeArm(%Hand(%FingerBase))))",
     "%UpLeg(%Leg(%Foot(%ToeBase)))",
     {"Hips", "LowerBack", "Spine1", "Neck", "Head", "%Shoulder", "%Arm", "%ForeArm", "%Hand", "%UpLeg",
      "%Leg", "%Foot", "%ToeBase"}},
};

std::string treeOf(const Family& family) {
    const auto sided = [](const char* limb, const char* side) { return with(limb, "%", side); };
    std::string text =
        with(family.trunk, "ARMS", sided(family.arm, family.left) + " " + sided(family.arm, family.right));
    text = with(text, "LEFTLEG", sided(family.leg, family.left));
    text = with(text, "RIGHTLEG", sided(family.leg, family.right));
    return with(text, "LEGS", sided(family.leg, family.left) + " " + sided(family.leg, family.right));
}

std::map<std::string, std::string> expectedOf(const Family& family) {
    std::map<std::string, std::string> expected;
    for (size_t j = 0; j < family.names.size(); ++j)
        for (const auto& [side, called] : {std::pair{"Left", family.left}, {"Right", family.right}})
            if (*family.names[j])
                expected[with(kJointsOfFamilies[j], "%", side)] = with(family.names[j], "%", called);
    return expected;
}

TEST(BoneNames, EveryFamilyOnBothSides) {
    for (const Family& family : kFamilies)
        EXPECT_EQ(namesOf(bonesOf(treeOf(family))), expectedOf(family)) << family.program;
}

/// Columns of a table have names and no tree, in whatever order.
TEST(BoneNames, ListsWithoutATreeInAnyOrder) {
    for (const Family& family : kFamilies) {
        const std::string program = family.program;
        if (program != "HumanIK" && program != "Xsens' segments" && program != "SMPL" &&
            program != "Motive" && program != "CATS" && program != "Axis Neuron")
            continue;
        std::vector<NamedBone> bones = bonesOf(treeOf(family));
        for (NamedBone& bone : bones)
            bone.parent = -1;
        std::sort(bones.begin(), bones.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
        EXPECT_EQ(namesOf(bones), expectedOf(family)) << program;
    }
}

TEST(BoneNames, TrunkAndNeckAreGivenWhole) {
    const auto bones = bonesOf(
        "Hips(LeftUpLeg(LeftLeg) RightUpLeg(RightLeg) Spine(Spine1(Spine2(Spine3(Spine4("
        "Neck(Neck1(Head)) LeftArm(LeftForeArm) RightArm(RightForeArm)))))))");
    const NamedJoints joints = jointsByName(bones);
    const auto named = [&](const std::vector<int>& chain) {
        std::string text;
        for (const int bone : chain)
            text += bones[static_cast<size_t>(bone)].name + " ";
        return text;
    };
    EXPECT_EQ(named(joints.trunk), "Spine Spine1 Spine2 Spine3 Spine4 ");
    EXPECT_EQ(named(joints.neck), "Neck Neck1 Head ");
}

TEST(BoneNames, OfTwoBodiesTheFirstWholeOne) {
    const std::string body =
        "#Hips(#LeftUpLeg(#LeftLeg(#LeftFoot)) #RightUpLeg(#RightLeg(#RightFoot)) #Spine("
        "#Neck(#Head) #LeftArm(#LeftForeArm(#LeftHand)) #RightArm(#RightForeArm("
        "#RightHand))))";
    for (const auto& [first, second] : {std::pair{"", "B:"}, {"B:", ""}, {"A_", "B_"}, {"", "B_"}}) {
        const auto names =
            namesOf(bonesOf("Root(" + with(body, "#", first) + " " + with(body, "#", second) + ")"));
        EXPECT_EQ(names.size(), 16U) << first << second;
        for (const auto& [joint, name] : names)
            EXPECT_EQ(name, first + joint);
    }
}

TEST(BoneNames, BonesThatMoveTheSkinComeBeforeControls) {
    auto bones = bonesOf(
        "rig(DEF-spine(DEF-thigh.L(DEF-shin.L(DEF-foot.L)) DEF-thigh.R(DEF-shin.R(DEF-foot.R))"
        " DEF-spine.001(DEF-spine.002(DEF-spine.004(DEF-spine.006) DEF-upper_arm.L(DEF-forearm.L("
        "DEF-hand.L)) DEF-upper_arm.R(DEF-forearm.R(DEF-hand.R)))))"
        " root(hips(thigh.L(shin.L(foot.L)) thigh.R(shin.R(foot.R)) chest(neck(head) upper_arm.L("
        "forearm.L(hand.L)) upper_arm.R(forearm.R(hand.R))))))");
    for (NamedBone& bone : bones)
        bone.moves_skin = bone.name.starts_with("DEF-");
    const auto names = namesOf(bones);
    EXPECT_EQ(names.size(), 17U);
    for (const auto& [joint, name] : names)
        EXPECT_TRUE(name.starts_with("DEF-")) << joint << " is " << name;
}

TEST(BoneNames, HelpersAndStrangersAreNothing) {
    for (const char* name : {"",
                             ":",
                             "LeftHandThumb1",
                             "Bip01 L ForeTwist",
                             "ik_foot_l",
                             "upperarm_twist_01_l",
                             "skirt_L_leg",
                             "HeadTop_End",
                             "LeftToeBase_end",
                             "__LeftArm",
                             "J_Sec_L_Hand",
                             "f_index.01.L",
                             "leg",
                             "arm",
                             "左足ＩＫ",
                             "左腕捩",
                             "MCH-foot.L",
                             "lever",
                             "rod",
                             "ring",
                             "LArmHair"}) {
        const BoneSpelling spelling = spellingOf(name);
        EXPECT_FALSE(spelling.isKnown()) << name << ": " << spelling.prefix << "|" << spelling.base;
    }
    EXPECT_TRUE(jointsByName({}).bone_of_joint.empty());
    // Two bones of a hat do not make its prefix that of a body.
    EXPECT_TRUE(jointsByName(bonesOf("hat(hat_head(hat_neck))")).bone_of_joint.empty());
}

TEST(BoneNames, MissingMainJointsAreNamed) {
    const auto found = jointsByName(bonesOf("hip(rarm larm)")).bone_of_joint;
    const auto missing = missingMainJoints(found);
    EXPECT_NE(std::find(missing.begin(), missing.end(), "LeftForeArm"), missing.end());
    EXPECT_EQ(missing.size() + found.size(), mainJoints().size());
}

}  // namespace
}  // namespace noctule
