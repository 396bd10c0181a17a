// SPDX-License-Identifier: Apache-2.0
// One walk of our own in dialects that differ from those of ../shared/data/field.
#include "tests/core/figure/dialects.h"

namespace noctule::figure {
namespace {

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

struct Dialect {
    const char* name;
    std::function<MotionClip()> make;
    double worst_deg = 4;
};

/// The collar bones of walk() slope by 4.9 degrees in its T pose. Where no T pose is left, nothing shows
/// that.
constexpr double kCollar_deg = 6;

std::map<std::string, Quaterniond> bothSides(const std::string& joint, const Vector3d& axis, double angle,
                                             bool mirrored) {
    return {{"Left" + joint, axisAngle(axis, angle)},
            {"Right" + joint, axisAngle(axis, mirrored ? -angle : angle)}};
}

std::map<std::string, Quaterniond> together(std::initializer_list<std::map<std::string, Quaterniond>> parts) {
    std::map<std::string, Quaterniond> all;
    for (const auto& part : parts)
        all.insert(part.begin(), part.end());
    return all;
}

std::vector<Dialect> dialects() {
    const auto none = [](int) { return 0.0; };
    return {
        {"arms down", [] { return withZeroPose(walk(), bothSides("Arm", kZ, -1.45, true)); }},
        {"A pose of 45 degrees, elbows bent",
         [] {
             return withZeroPose(
                 walk(), together({bothSides("Arm", kZ, -0.8, true), bothSides("ForeArm", kY, -0.5, true)}));
         }},
        {"arms to the front", [] { return withZeroPose(walk(), bothSides("Arm", kY, -1.5, true)); }},
        {"arms above the head", [] { return withZeroPose(walk(), bothSides("Arm", kZ, 1.4, true)); }},
        {"sitting, hands on the thighs",
         [] {
             return withZeroPose(
                 walk(), together({bothSides("UpLeg", kX, -1.5, false), bothSides("Leg", kX, 1.45, false),
                                   bothSides("Arm", kZ, -1.2, true), bothSides("ForeArm", kY, -1.2, true)}));
         }},
        {"kneeling with pointed feet",
         [] {
             return withZeroPose(
                 walk(), together({bothSides("Leg", kX, 1.5, false), bothSides("Foot", kX, 0.9, false)}));
         }},
        {"on tiptoe", [] { return withZeroPose(walk(), bothSides("Foot", kX, 0.6, false)); }},
        {"toes pulled up", [] { return withZeroPose(walk(), bothSides("Foot", kX, -0.5, false)); }},
        {"bowed by 35 degrees at the chest",
         [] {
             return withZeroPose(walk(), {{"Spine1", axisAngle(kX, 0.6)}});
         }},
        {"bowed along the whole spine",
         [] {
             return withZeroPose(walk(), {{"Spine", axisAngle(kX, 0.25)},
                                          {"Spine1", axisAngle(kX, 0.25)},
                                          {"Spine2", axisAngle(kX, 0.25)},
                                          {"Head", axisAngle(kX, -0.4)}});
         }},
        {"in the middle of a stride",
         [] {
             const MotionClip clip = walk();
             std::map<std::string, Quaterniond> rest;
             for (int j = 1; j < clip.skeleton.size(); ++j)
                 rest[clip.skeleton.joint(j).name] = clip.frames[20].q_parent_joint[static_cast<size_t>(j)];
             return withZeroPose(clip, rest);
         },
         kCollar_deg},
        {"all bones along X", [none] { return alongAxis(walk(), kX, none); }, kCollar_deg},
        {"all bones along Y with tips", [none] { return alongAxis(walk(), kY, none, true); }, kCollar_deg},
        {"all bones along -Z", [none] { return alongAxis(walk(), -kZ, none); }, kCollar_deg},
        {"bones along X, quarter turns about them",
         [] {
             return alongAxis(
                 walk(), kX, [](int j) { return (j % 4) * std::numbers::pi / 2; }, true);
         },
         kCollar_deg},
        {"bones along Y, any turns about them",
         [] {
             return alongAxis(
                 walk(), kY, [](int j) { return 0.7 * j; }, true);
         },
         kCollar_deg},
        {"the whole figure turned in its zero pose",
         [] {
             return withZeroPose(walk(), {{"Hips", axisAngle(Vector3d(1, 2, 3).normalized(), 2)}});
         }},
        {"position channels on every joint", [] { return withPositionChannels(walk()); }},
        {"Z up, T pose along Y", [] { return turnedInWorld(walk(), axisAngle(kX, std::numbers::pi / 2)); }},
        {"Z up with the zero pose",
         [] {
             const Quaterniond up = axisAngle(kX, std::numbers::pi / 2);
             return turnedInWorld(withZeroPose(walk(), {{"Hips", up}}), up);
         }},
        {"X up with the zero pose",
         [] {
             const Quaterniond up = axisAngle(kZ, -std::numbers::pi / 2);
             return turnedInWorld(withZeroPose(walk(), {{"Hips", up}}), up);
         }},
        {"walking to the side of the file", [] { return turnedInWorld(walk(), axisAngle(kY, 2.1)); }},
    };
}

TEST(OwnDialects, AreTheSamePerformance) {
    const UnderstoodMotion plain = understood(walk());
    const Performed base = perform(plain);
    for (const Dialect& dialect : dialects()) {
        const UnderstoodMotion motion = understood(dialect.make());
        const Difference difference = differenceOf(base, perform(motion));
        std::printf("%-42s mean %.3f deg, worst %s %.2f deg, height %.3f, zero pose: %s\n", dialect.name,
                    difference.mean_deg, difference.worst.c_str(), difference.worst_deg,
                    motion.measures.height_m, motion.rest_pose.c_str());
        EXPECT_LT(difference.mean_deg, 1) << dialect.name;
        EXPECT_LT(difference.worst_deg, dialect.worst_deg) << dialect.name << ": " << difference.worst;
        EXPECT_NEAR(motion.measures.height_m, plain.measures.height_m, 0.01) << dialect.name;
        EXPECT_NEAR(motion.measures.shoulder_width_m, 0.33, 0.01) << dialect.name;
        EXPECT_NEAR(motion.measures.forearm_m, 0.24, 0.001) << dialect.name;
        EXPECT_NEAR(motion.measures.shin_m, 0.42, 0.001) << dialect.name;
    }
}

TEST(OwnDialects, EveryUnitIsFoundFromTheBody) {
    for (const auto& [unit, metres] : {std::pair{BvhUnit::kMetre, 1.0},
                                       {BvhUnit::kCentimetre, 0.01},
                                       {BvhUnit::kMillimetre, 0.001},
                                       {BvhUnit::kInch, 0.0254},
                                       {BvhUnit::kCmu, metresPer(BvhUnit::kCmu)},
                                       {BvhUnit::kDecimetre, 0.1}}) {
        MotionClip clip = walk(1);
        for (Pose& pose : clip.frames)
            pose.p_world_root += Vector3d(30, 0, -500);  // far away from the file's origin
        const UnderstoodMotion motion = understood(clip, metres);
        EXPECT_EQ(toText(motion.unit), toText(unit));
        EXPECT_NEAR(motion.measures.forearm_m, 0.24, 1e-4);
    }
}

TEST(OwnDialects, AGivenHeightGoesBeforeTheUnit) {
    MotionHints hints;
    hints.height_m = 1.2;
    const UnderstoodMotion motion = understood(walk(1), 0.0037, hints);
    EXPECT_NEAR(motion.measures.height_m, 1.2, 1e-6);
    EXPECT_NEAR(motion.clip.frames[0].p_world_root.y() / motion.measures.thigh_m, 0.93 / 0.42, 0.05);
}

TEST(OwnDialects, SizesThatNoPersonHasAreTold) {
    for (const double metres : {0.01 / 0.45, 0.01 * 2.2, 0.01 / 1.8}) {
        const UnderstoodMotion motion = understood(walk(1), metres);
        bool told = false;
        for (const std::string& warning : motion.warnings)
            told = told || warning.find("--height M") != std::string::npos;
        EXPECT_TRUE(told) << metres << " " << describe(motion);
    }
}

TEST(OwnDialects, PartsOfAWalkAreUnderstoodToo) {
    const Performed base = perform(understood(walk()));
    for (const size_t frames : {size_t{1}, size_t{2}, size_t{5}, size_t{20}}) {
        MotionClip clip = walk();
        clip.frames.resize(frames);
        const UnderstoodMotion motion = understood(clip);
        EXPECT_NEAR(motion.measures.height_m, base.actor.height_m, 0.01) << frames;
        EXPECT_FALSE(perform(motion).poses.empty());
    }
}

TEST(OwnDialects, ExchangedSidesAreSetRightAndTold) {
    const Performed base = perform(understood(walk()));
    const MotionClip plain = walk();
    for (const std::string what : {"both", "legs", "arms"}) {
        std::map<std::string, std::string> names;
        for (const Joint& joint : plain.skeleton.joints()) {
            const std::string other = mirroredSegment(joint.name);
            if (other != joint.name && (what == "both" || isOfLimbs(joint.name, what)))
                names[joint.name] = other;
        }
        const UnderstoodMotion motion = understood(renamed(plain, names));
        EXPECT_LT(differenceOf(base, perform(motion)).mean_deg, 0.1) << what;
        ASSERT_FALSE(motion.warnings.empty()) << what;
        EXPECT_NE(motion.warnings[0].find("exchanged"), std::string::npos) << motion.warnings[0];
    }
    EXPECT_TRUE(understood(plain).warnings.empty()) << understood(plain).warnings[0];
}

TEST(OwnDialects, WithoutAnyNameTheShapeTells) {
    const Performed base = perform(understood(walk()));
    const MotionClip plain = walk();
    std::map<std::string, std::string> names;
    for (int j = 0; j < plain.skeleton.size(); ++j)
        names[plain.skeleton.joint(j).name] = "b" + std::to_string(j);
    for (const bool along : {false, true}) {
        const MotionClip nameless = renamed(plain, names);
        const UnderstoodMotion motion =
            understood(along ? alongAxis(nameless, kX, [](int) { return 0.0; }) : nameless);
        const Difference difference = differenceOf(base, perform(motion));
        EXPECT_LT(difference.mean_deg, 1) << difference.worst;
        EXPECT_FALSE(motion.by_shape.empty());
        ASSERT_FALSE(motion.warnings.empty());
    }
}

TEST(OwnDialects, AMapByHandGoesBeforeNames) {
    MotionHints hints;
    const MotionClip odd = renamed(walk(1), {{"LeftForeArm", "tentacle"}, {"RightLeg", "pillar"}});
    hints.joints = {{"LeftForeArm", "tentacle"}, {"RightLeg", "pillar"}};
    const UnderstoodMotion motion = understood(odd, 0.01, hints);
    EXPECT_EQ(motion.by_hand.size(), 2u);
    EXPECT_EQ(motion.clip.skeleton.joint(motion.joints.at("LeftForeArm")).name, "tentacle");
    for (const auto& [joint, name] : {std::pair{"LeftForeArm", "feeler"}, std::pair{"Tail", "pillar"}}) {
        hints.joints = {{joint, name}};
        const auto refused = understandMotion(toDocument(odd).value(), hints);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
        EXPECT_NE(refused.error().text().find(joint), std::string::npos) << refused.error().text();
    }
}

TEST(OwnDialects, WhatIsNoPersonIsRefusedWithTheRemedy) {
    MotionClip clip = walk(1);
    std::vector<Joint> joints(clip.skeleton.joints().begin(), clip.skeleton.joints().begin() + 6);
    clip.skeleton = Skeleton::make(std::move(joints)).value();
    for (Pose& pose : clip.frames)
        pose.q_parent_joint.resize(6);
    const auto refused = understandMotion(toDocument(clip).value());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(refused.error().text().find("LeftUpLeg"), std::string::npos);
    EXPECT_NE(refused.error().text().find("--bones"), std::string::npos);
}

TEST(LostTracking, ZerosAreBridgedCutAndCounted) {
    const MotionClip good = walk();
    MotionClip clip = good;
    const auto lose = [&](size_t from, size_t to) {
        for (size_t f = from; f < to; ++f)
            clip.frames[f] = clip.skeleton.zeroPose();
    };
    lose(0, 3);
    lose(30, 36);
    lose(70, 71);
    lose(118, 120);
    const UnderstoodMotion motion = understood(clip);
    EXPECT_EQ(motion.lost.cut_first, 3u);
    EXPECT_EQ(motion.lost.cut_last, 2u);
    EXPECT_EQ(motion.lost.bridged, 7u);
    EXPECT_EQ(motion.lost.longest, 6u);
    ASSERT_EQ(motion.clip.frames.size(), 115u);
    for (size_t f = 0; f < motion.clip.frames.size(); ++f) {
        const bool bridged = (f >= 27 && f < 33) || f == 67;
        EXPECT_LT((motion.clip.frames[f].p_world_root - good.frames[f + 3].p_world_root).norm(),
                  bridged ? 0.05 : 1e-6)
            << f;
    }
}

TEST(LostTracking, OneLimbOutOfSightIsBridged) {
    const MotionClip good = walk();
    MotionClip clip = good;
    const size_t arm = static_cast<size_t>(clip.skeleton.find("RightArm"));
    for (size_t f = 50; f < 55; ++f)
        clip.frames[f].q_parent_joint[arm] = Quaterniond::Identity();
    const UnderstoodMotion motion = understood(clip);
    ASSERT_EQ(motion.lost.joints.size(), 1u);
    EXPECT_EQ(motion.lost.joints[0].first, "RightArm");
    EXPECT_EQ(motion.lost.joints[0].second, 5u);
    for (size_t f = 50; f < 55; ++f)
        EXPECT_LT(angleBetween(motion.clip.frames[f].q_parent_joint[arm], good.frames[f].q_parent_joint[arm]),
                  0.1);
}

TEST(LostTracking, ALostPlaceIsBridged) {
    const MotionClip good = walk();
    MotionClip clip = good;
    for (size_t f = 40; f < 44; ++f)
        clip.frames[f].p_world_root.setZero();
    const UnderstoodMotion motion = understood(clip);
    ASSERT_EQ(motion.lost.joints.size(), 1u);
    EXPECT_EQ(motion.lost.joints[0].second, 4u);
    for (size_t f = 40; f < 44; ++f)
        EXPECT_LT((motion.clip.frames[f].p_world_root - good.frames[f].p_world_root).norm(), 0.05) << f;
}

TEST(LostTracking, AFileThatIsMostlyLostIsRefused) {
    MotionClip clip = walk();
    for (size_t f = 20; f < 100; ++f)
        clip.frames[f] = clip.skeleton.zeroPose();
    const auto refused = understandMotion(toDocument(clip).value());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("80 of 120"), std::string::npos) << refused.error().text();
}

TEST(OwnDialects, AFrameTimeInMillisecondsIsTaken) {
    MotionClip clip = walk(4, 120);
    clip.frame_time_s = 8.333333;
    const UnderstoodMotion motion = understood(clip);
    EXPECT_NEAR(motion.clip.frame_time_s, 0.008333333, 1e-9);
    ASSERT_FALSE(motion.warnings.empty());
    EXPECT_NE(motion.warnings[0].find("milliseconds"), std::string::npos);
}

TEST(OwnDialects, LyingAndCrawlingBodiesAreNotSetUpright) {
    MotionClip lying = walk();
    for (Pose& pose : lying.frames) {
        pose.p_world_root = Vector3d(0, 0.12, 0);
        pose.q_parent_joint[0] = axisAngle(kX, -std::numbers::pi / 2) * pose.q_parent_joint[0];
    }
    MotionHints y;
    y.up = UpAxis::kY;
    const UnderstoodMotion told = understood(lying, 0.01, y);
    EXPECT_EQ(told.up, UpAxis::kY);
    bool says = false;
    for (const std::string& warning : told.warnings)
        says = says || warning.find("--up") != std::string::npos;
    EXPECT_TRUE(says);

    MotionClip crawling = walk();
    for (size_t f = 0; f < crawling.frames.size(); ++f) {
        Pose& pose = crawling.frames[f];
        pose.p_world_root = Vector3d(0, 0.45, 0.01 * static_cast<double>(f));
        pose.q_parent_joint[0] = axisAngle(kX, 1.4);
        for (const char* joint : {"LeftUpLeg", "RightUpLeg"})
            pose.q_parent_joint[static_cast<size_t>(crawling.skeleton.find(joint))] = axisAngle(kX, -1.4);
        for (const char* joint : {"LeftLeg", "RightLeg"})
            pose.q_parent_joint[static_cast<size_t>(crawling.skeleton.find(joint))] = axisAngle(kX, 1.5);
    }
    EXPECT_EQ(understood(crawling).up, UpAxis::kY);
}

}  // namespace
}  // namespace noctule::figure
