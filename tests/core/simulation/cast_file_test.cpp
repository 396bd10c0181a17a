// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/cast_file.h"

#include "tests/core/simulation/simulated_body.h"

namespace noctule::simulation {
namespace {

TEST(CastFile, DefaultsAreEnough) {
    const auto file = castFromJson(
        nlohmann::json::parse(R"({"subjects":[{"motion":"a.bvh"},{"motion":"b.bvh"}]})"), "c.json");
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(file->subjects[0].name, "A");
    EXPECT_EQ(file->subjects[1].name, "B");
    EXPECT_EQ(file->subjects[1].motion, "b.bvh");
    EXPECT_FALSE(file->subjects[0].place);
    EXPECT_FALSE(file->shared_clock);
}

TEST(CastFile, MistakesNameTheSubjectAndTheMember) {
    const std::pair<const char*, const char*> cases[] = {
        {R"([])", "is not an object"},
        {R"({"subjects":{}})", "no list of performers"},
        {R"({"subjects":[]})", "no list of performers"},
        {R"({"subjects":[7]})", "subject 1: is not an object"},
        {R"({"subjects":[{"name":"Eva"}]})", "subject Eva: has no motion"},
        {R"({"subjects":[{"motion":"a","motion_scale":0}]})", "subject A: motion_scale must be"},
        {R"({"subjects":[{"motion":"a","start_s":1e300}]})", "start_s must be"},
        {R"({"subjects":[{"motion":"a","motion_skip":1.5}]})", "motion_skip must be a whole number"},
        {R"({"subjects":[{"motion":"a","carrier_hz":"high"}]})", "carrier_hz must be"},
        {R"({"subjects":[{"motion":"a","place":{"x_m":1e9}}]})", "place: x_m must be"},
        {R"({"subjects":[{"motion":"a","place":[1]}]})", "place: is not an object"},
        {R"({"subjects":[{"motion":"a"},{"name":"A","motion":"a"}]})", "two subjects are called \"A\""},
        {R"({"subjects":[{"motion":"a"}],"shared_clock":1})", "shared_clock must be true or false"},
    };
    for (const auto& [json, expected] : cases) {
        const auto file = castFromJson(nlohmann::json::parse(json), "c.json");
        ASSERT_FALSE(file.ok()) << json;
        EXPECT_NE(file.error().message.find(expected), std::string::npos) << file.error().message;
        EXPECT_FALSE(file.error().remedy.empty());
    }
}

TEST(CastFile, MotionsAreAdjusted) {
    CastFileSubject subject;
    subject.motion_scale = 1.4;
    subject.motion_rate_hz = 60;
    subject.motion_skip = 10;
    const MotionClip clip = madeMotion(1), adjusted = adjustedMotion(clip, subject).value();
    EXPECT_EQ(adjusted.frames.size(), clip.frames.size() - 10);
    EXPECT_DOUBLE_EQ(adjusted.frame_time_s, 1 / 60.0);
    EXPECT_LT((globalPose(adjusted, 0).p_world_joint[5] - 1.4 * globalPose(clip, 10).p_world_joint[5]).norm(),
              1e-12);
    subject.motion_skip = 1000;
    EXPECT_FALSE(adjustedMotion(clip, subject).ok());
}

}  // namespace
}  // namespace noctule::simulation
