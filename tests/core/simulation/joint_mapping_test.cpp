// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/joint_mapping.h"

#include <gtest/gtest.h>

namespace noctule::simulation {
namespace {

/// Joints by name, each below the one whose number is given.
Skeleton skeletonOf(const std::vector<std::pair<std::string, int>>& names) {
    std::vector<Joint> joints;
    for (const auto& [name, parent] : names) {
        Joint joint;
        joint.name = name;
        joint.parent = parent;
        joint.type = parent < 0 ? JointType::kFree : JointType::kFixed;
        joints.push_back(joint);
    }
    return Skeleton::make(std::move(joints)).value();
}

TEST(JointMapping, NamesOfPosersFigures) {
    const Skeleton source = skeletonOf(
        {{"hip", -1},      {"abdomen", 0}, {"chest", 1},    {"neck", 2},    {"head", 3},    {"leftEye", 4},
         {"rCollar", 2},   {"rShldr", 6},  {"rForeArm", 7}, {"rHand", 8},   {"lCollar", 2}, {"lShldr", 10},
         {"lForeArm", 11}, {"lHand", 12},  {"rButtock", 0}, {"rThigh", 14}, {"rShin", 15},  {"rFoot", 16},
         {"lButtock", 0},  {"lThigh", 18}, {"lShin", 19},   {"lFoot", 20}});
    const auto mapping = mapJoints(source, "pair");
    ASSERT_TRUE(mapping) << mapping.error().text();
    const JointMapping expected = {
        {"Hips", 0},       {"Spine", 1},         {"Chest", 2},     {"Neck", 3},
        {"Head", 4},       {"RightShoulder", 6}, {"RightArm", 7},  {"RightForeArm", 8},
        {"RightHand", 9},  {"LeftShoulder", 10}, {"LeftArm", 11},  {"LeftForeArm", 12},
        {"LeftHand", 13},  {"RightUpLeg", 15},   {"RightLeg", 16}, {"RightFoot", 17},
        {"LeftUpLeg", 19}, {"LeftLeg", 20},      {"LeftFoot", 21}};
    EXPECT_EQ(mapping.value(), expected);
}

TEST(JointMapping, ALetterMarksASideOnlyBeforeACapital) {
    const Skeleton source = skeletonOf({{"hip", -1}, {"rarm", 0}, {"larm", 0}});
    const auto mapping = mapJoints(source, "odd");
    ASSERT_FALSE(mapping);
    EXPECT_NE(mapping.error().text().find("LeftArm"), std::string::npos);
}

}  // namespace
}  // namespace noctule::simulation
