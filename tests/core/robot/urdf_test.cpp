// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "tests/core/robot/robots.h"

namespace noctule::robot {
namespace {

const std::string kLinks = R"(<link name="a"/><link name="b"/><link name="c"/>)";

std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& limit, const std::string& type = "revolute") {
    return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/><axis xyz=\"0 0 1\"/>" + limit + "</joint>";
}

const std::string kLimit = R"(<limit lower="-1" upper="2" velocity="3" effort="4"/>)";

Result<RobotModel> robotOf(const std::string& content) {
    return parseUrdf("<robot name=\"r\">" + content + "</robot>", "r.urdf");
}

std::string errorOf(const std::string& content) {
    const auto model = robotOf(content);
    if (model)
        return "";
    EXPECT_EQ(model.error().kind, ErrorKind::kUnreadable);
    EXPECT_FALSE(model.error().remedy.empty());
    return model.error().message;
}

TEST(Urdf, ReadsLimitsAndTree) {
    const auto model = robotOf(kLinks + joint("j", "a", "b", kLimit) + joint("k", "b", "c", "", "fixed"));
    ASSERT_TRUE(model) << model.error().text();
    ASSERT_EQ(model->joints.size(), 2u);
    EXPECT_EQ(model->links[0].name, "a");
    const RobotJoint& j = model->joints[0];
    EXPECT_EQ(j.lower, -1);
    EXPECT_EQ(j.upper, 2);
    EXPECT_EQ(j.max_speed, 3);
    EXPECT_TRUE(model->notices.empty());
    EXPECT_EQ(model->jointsAbove(model->findLink("c")), (std::vector<int>{0, 1}));
}

TEST(Urdf, NamesWhatIsWrong) {
    const std::string two = kLinks + joint("j", "a", "b", kLimit);
    EXPECT_EQ(errorOf(kLinks + "<link name=\"a\"/>" + joint("j", "a", "b", kLimit)),
              "r.urdf: the link \"a\" stands in it twice");
    EXPECT_EQ(errorOf(two + joint("j", "b", "c", kLimit)), "r.urdf: the joint \"j\" stands in it twice");
    EXPECT_EQ(errorOf(two + joint("k", "a", "c", kLimit) + joint("m", "c", "b", kLimit)),
              "r.urdf: the joints \"j\" and \"m\" both hold link \"b\": the robot has a loop");
    EXPECT_NE(
        errorOf(two + joint("k", "b", "c", kLimit) + joint("m", "c", "a", kLimit)).find("hangs below itself"),
        std::string::npos);
    EXPECT_EQ(errorOf(two + joint("k", "b", "d", kLimit)),
              "r.urdf: joint \"k\" names no child link that is there (\"d\")");
    EXPECT_EQ(errorOf(kLinks + joint("j", "a", "b", R"(<limit lower="nan" upper="2" velocity="3"/>)")),
              "r.urdf: the lower limit of joint \"j\" is no finite number (\"nan\")");
    EXPECT_EQ(errorOf(kLinks + joint("j", "a", "b", R"(<limit lower="3" upper="2" velocity="3"/>)")),
              "r.urdf: the lower limit of joint \"j\" is above its upper limit");
    EXPECT_EQ(errorOf(kLinks + joint("j", "a", "b", R"(<limit lower="1" upper="2" velocity="0"/>)")),
              "r.urdf: the velocity limit of joint \"j\" is not above 0");
    EXPECT_NE(errorOf(two + joint("k", "b", "c", "", "floating")).find("\"k\" is floating"),
              std::string::npos);
    EXPECT_NE(errorOf(two), "");  // link c hangs nowhere: two roots
    EXPECT_NE(errorOf(""), "");
}

TEST(Urdf, SaysWhichLimitItAssumed) {
    const auto model = robotOf(kLinks + joint("j", "a", "b", "") + joint("s", "b", "c", "", "prismatic"));
    ASSERT_TRUE(model) << model.error().text();
    EXPECT_NEAR(model->joints[0].lower, -kAssumedRange_rad, 1e-5);
    EXPECT_EQ(model->joints[0].max_speed, kAssumedSpeed_rad_per_s);
    EXPECT_NEAR(model->joints[1].upper, kAssumedRange_m, 1e-9);
    ASSERT_EQ(model->notices.size(), 6u);
    EXPECT_EQ(model->notices[0], "joint \"j\" states no velocity limit, 1 is assumed");
}

TEST(Urdf, RefusesWhatIsNoUrdf) {
    std::string deep;
    for (int i = 0; i < 5000; ++i)
        deep += "<a>";
    const std::string zero("<robot\0>", 8);
    for (const std::string& text : {std::string(""), std::string("hello"), std::string("<html></html>"),
                                    std::string("<robot name='r'><xacro:macro/></robot>"), deep, zero}) {
        const auto model = parseUrdf(text, "x");
        ASSERT_FALSE(model);
        EXPECT_EQ(model.error().kind, ErrorKind::kUnreadable);
        EXPECT_FALSE(model.error().remedy.empty());
    }
}

class UrdfOfRobots : public WithRobots {};

TEST(Urdf, EveryCutIsRefused) {
    const std::string whole = "<robot name=\"r\">" + kLinks + joint("j", "a", "b", kLimit) +
                              joint("k", "b", "c", kLimit) + "</robot>";
    for (size_t end = 0; end < whole.size(); ++end)
        EXPECT_FALSE(parseUrdf(whole.substr(0, end), "cut"));
}

TEST_F(UrdfOfRobots, ReadsMimicJointsAndShapes) {
    const RobotModel panda = read("panda/panda.urdf");
    int mimics = 0;
    for (const RobotJoint& one : panda.joints)
        mimics += one.mimic.has_value();
    EXPECT_EQ(mimics, 1);
    const RobotModel h1 = read("unitree_h1/h1.urdf");
    size_t shapes = 0;
    for (const RobotLink& link : h1.links)
        shapes += link.shapes.size();
    EXPECT_EQ(shapes, 23u);
    const RobotModel r2 = read("robonaut2/r2.urdf");
    EXPECT_FALSE(r2.notices.empty());  // every velocity limit is 1000
}

}  // namespace
}  // namespace noctule::robot
