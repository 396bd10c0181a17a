// SPDX-License-Identifier: Apache-2.0
// Every family of bone names: each canonical joint finds its bone on both sides, helpers are left out.
#include "core/body/bone_names.h"

#include <gtest/gtest.h>

#include "tests/core/body/bone_families.h"

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
