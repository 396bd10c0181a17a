// SPDX-License-Identifier: Apache-2.0
#include "core/body/actor.h"
#include "core/body/bone_names.h"
#include "core/formats/bvh.h"
#include "core/math/rotation.h"
#include "core/robot/arm_follower.h"
#include "core/robot/motion_mapping.h"
#include "tests/core/robot/robots.h"

namespace noctule::robot {
namespace {

const std::string kHandshake = "/../shared/data/bvh/cmu/pair_handshake/18_01.bvh";
const std::string kDance = "/../shared/data/bvh/cmu/pair_salsa/60_05_scaled.bvh";

class RobotMapping : public WithRobots {
protected:
    void SetUp() override {
        WithRobots::SetUp();
        if (!std::filesystem::exists(NOCTULE_SOURCE_DIR + kDance))
            GTEST_SKIP() << "needs ../shared/data/bvh";
    }

    static MotionClip motion(const std::string& file, double frame_time_s = 0) {
        const auto document = readBvh(NOCTULE_SOURCE_DIR + file);
        EXPECT_TRUE(document);
        auto clip = toClip(*document);
        EXPECT_TRUE(clip);
        if (frame_time_s > 0)
            clip->frame_time_s = frame_time_s;
        return std::move(*clip);
    }
    /// Its size does not matter to directions and scaled places. It is declared at 120 Hz, at which its
    /// pelvis spins at 1270 deg/s; it is one of 60 Hz.
    static MotionClip dance() { return motion(kDance, 1.0 / 60); }
};

struct Figures {
    double upper_deg = 0, forearm_deg = 0, wrist_mm = 0;
};

Figures meanOf(const RobotTrajectory& trajectory) {
    Figures mean;
    for (const ArmFigures& arm : trajectory.arms) {
        const double share = 1.0 / static_cast<double>(trajectory.arms.size());
        mean.upper_deg += share * arm.upper_mean_deg;
        mean.forearm_deg += share * arm.forearm_mean_deg;
        mean.wrist_mm += share * arm.wrist_mean_mm;
    }
    return mean;
}

RobotProfile profileFor(const RobotModel& model, double speed) {
    auto profile = makeProfile(model);
    EXPECT_TRUE(profile) << (profile ? "" : profile.error().text());
    for (ArmProfile& arm : profile->arms)
        for (double& one : arm.max_speed)
            one = speed > 0 ? speed : one;
    return std::move(*profile);
}

/// Self-collision is left out where figures are compared with those of a bare arm.
enum class Parts { kWatched, kIgnored };

Figures run(const std::string& robot, const MotionClip& clip, double speed, Mapping mapping, const char* what,
            Parts parts = Parts::kIgnored) {
    const auto model = readUrdf(kRobots + robot);
    EXPECT_TRUE(model);
    RobotProfile profile = profileFor(*model, speed);
    if (parts == Parts::kIgnored)
        profile.clearance_m = 0;
    const auto mapped = mapMotion(clip, *model, profile, {mapping, true, true, false});
    EXPECT_TRUE(mapped) << (mapped ? "" : mapped.error().text());
    if (!mapped)
        return {};
    const auto limits = limitsOf(*model, profile, *mapped);
    EXPECT_TRUE(limits);
    const LimitUse use = limitUse(*mapped, *limits);
    EXPECT_LE(std::max({use.place, use.speed, use.acceleration, use.jerk}), 1 + 1e-6) << what << use.joint;
    const Figures mean = meanOf(*mapped);
    std::printf("%-34s %5.2f %5.2f deg %6.2f mm, held %d", what, mean.upper_deg, mean.forearm_deg,
                mean.wrist_mm, mapped->held_frames);
    for (const ArmFigures& arm : mapped->arms)
        std::printf(" | %s %.1f %.1f %.1f max %.0f %.0f %.0f lim %d", arm.arm.c_str(), arm.upper_mean_deg,
                    arm.forearm_mean_deg, arm.wrist_mean_mm, arm.upper_max_deg, arm.forearm_max_deg,
                    arm.wrist_max_mm, arm.limited_frames);
    std::printf(" of %zu, nearest %.0f mm %s\n", mapped->frames.size(), 1e3 * mapped->nearest_m,
                mapped->nearest_parts.c_str());
    return mean;
}

constexpr const char* kG1 = "unitree_g1/g1_29dof_rev_1_0.urdf";
constexpr const char* kR2 = "robonaut2/r2.urdf";

TEST_F(RobotMapping, FollowsAHandshakeWithinTheTargets) {
    const MotionClip clip = motion(kHandshake);
    const Figures g1 = run(kG1, clip, 6, Mapping::kPosture, "G1 handshake");
    EXPECT_LE(g1.upper_deg, 3);
    EXPECT_LE(g1.forearm_deg, 3);
    EXPECT_LE(g1.wrist_mm, 3);
    const Figures r2 = run(kR2, clip, 2.5, Mapping::kPosture, "R2 handshake");
    EXPECT_LE(r2.upper_deg, 6.5);
    EXPECT_LE(r2.forearm_deg, 6.5);
    EXPECT_LE(r2.wrist_mm, 6);
}

// The targets of place and posture are not reached on the dance; run() proves that no limit is broken.
TEST_F(RobotMapping, FollowsADanceWithinTheLimits) {
    run(kG1, dance(), 6, Mapping::kPosture, "G1 dance");
    run(kR2, dance(), 50, Mapping::kPosture, "R2 dance");
}

TEST_F(RobotMapping, TheBaselineIsFaithfulInPostureOnly) {
    const MotionClip clip = motion(kHandshake);
    for (const char* robot : {kG1, kR2}) {
        const Figures ours = run(robot, clip, 6, Mapping::kPosture, robot);
        const Figures miller = run(robot, clip, 6, Mapping::kMillerTrunk, "  Miller with a trunk sensor");
        run(robot, clip, 6, Mapping::kMiller, "  Miller to the letter");
        EXPECT_LT(ours.wrist_mm, miller.wrist_mm);
    }
}

TEST_F(RobotMapping, EveryRobotGetsAProfileFromItsUrdf) {
    for (const char* file : {kR2, kG1, "unitree_g1/g1_dual_arm.urdf", "unitree_h1/h1.urdf",
                             "baxter/baxter.urdf", "panda/panda.urdf", "ur5/ur5.urdf"}) {
        const RobotModel model = read(file);
        const auto profile = makeProfile(model);
        ASSERT_TRUE(profile) << file << profile.error().text();
        const bool single = std::string(file).starts_with("panda") || std::string(file).starts_with("ur5");
        EXPECT_EQ(profile->arms.size(), single ? 1u : 2u) << file;
        const nlohmann::json saved = toJson(*profile);
        const auto again = profileFromJson(saved, "again");
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(toJson(*again), saved) << file;
        for (const ArmProfile& arm : profile->arms) {
            const auto made = makeArm(model, arm);
            ASSERT_TRUE(made);
            ArmPose pose;
            const Vector3d outwards = Vector3d::UnitX() * (arm.side == Side::kLeft ? 1 : -1);
            pose.upper = PerformerArms::referenceUpper(arm.side) * outwards;
            pose.forearm = PerformerArms::referenceForearm(arm.side) * outwards;
            pose.wrist_m = made->length_m / 2 * (pose.upper + pose.forearm);
            const ArmCommand at = measured(*made, 1, made->reference, pose);
            std::printf("%-34s %-5s %5.1f %5.1f deg reference\n", file, arm.name.c_str(), at.upper_deg,
                        at.forearm_deg);
            // Baxter, Panda and UR5 cannot hang their upper arms: their limits or their mount forbid it.
            const std::string name = file;
            const bool can = name.starts_with("robonaut2") || name.starts_with("unitree");
            EXPECT_LT(at.upper_deg + at.forearm_deg, can ? 20 : 180) << file;
        }
    }
}

TEST_F(RobotMapping, OtherRobotsFollowWithoutBreakingALimit) {
    const MotionClip clip = motion(kHandshake);
    run(kG1, clip, 6, Mapping::kPosture, "G1 handshake, parts watched", Parts::kWatched);
    run(kG1, dance(), 6, Mapping::kPosture, "G1 dance, parts watched", Parts::kWatched);
    for (const char* file : {"unitree_h1/h1.urdf", "baxter/baxter.urdf", "panda/panda.urdf", "ur5/ur5.urdf"})
        run(file, clip, 0, Mapping::kPosture, file);
}

TEST_F(RobotMapping, AccelerationAndJerkStayWithinTheirLimits) {
    const RobotModel model = read(kG1);
    RobotProfile profile = profileFor(model, 6);
    profile.max_acceleration = 60;
    profile.max_jerk = 3000;
    const auto mapped = mapMotion(dance(), model, profile, {Mapping::kPosture, true, true, true});
    ASSERT_TRUE(mapped) << mapped.error().text();
    const LimitUse use = limitUse(*mapped, *limitsOf(model, profile, *mapped));
    EXPECT_LE(use.place, 1 + 1e-9);
    EXPECT_LE(use.speed, 1 + 1e-6) << use.joint;
    EXPECT_LE(use.acceleration, 1 + 1e-6) << use.joint;
    EXPECT_LE(use.jerk, 1 + 1e-6) << use.joint;
    const Figures mean = meanOf(*mapped);
    std::printf("G1 dance, 60 rad/s2, 3000 rad/s3: %.2f %.2f deg %.1f mm\n", mean.upper_deg, mean.forearm_deg,
                mean.wrist_mm);
}

TEST_F(RobotMapping, ALoopMeetsItsBeginningWithinTheLimits) {
    const RobotModel model = read(kG1);
    const RobotProfile profile = profileFor(model, 3);
    auto mapped = mapMotion(motion(kHandshake), model, profile, {});
    ASSERT_TRUE(mapped);
    const auto limits = limitsOf(model, profile, *mapped);
    const size_t before = mapped->frames.size();
    ASSERT_TRUE(closeLoop(*mapped, *limits));
    EXPECT_GT(mapped->frames.size(), before + 10);
    RobotTrajectory twice = *mapped;
    twice.frames.insert(twice.frames.end(), mapped->frames.begin(), mapped->frames.end());
    EXPECT_LE(limitUse(twice, *limits).speed, 1 + 1e-6);
}

/// In the performer's world as the trajectory has it: where the ankle of a side is.
Vector3d ankleOf(const RobotModel& model, const RobotArm& leg, const RobotTrajectory& trajectory,
                 size_t frame) {
    JointVector q(leg.chain.size());
    for (int i = 0; i < leg.chain.size(); ++i) {
        const auto at = std::ranges::find(trajectory.joints, leg.chain.joint(i).name);
        q[i] = trajectory.frames[frame][static_cast<size_t>(at - trajectory.joints.begin())];
    }
    ChainState state;
    leg.chain.forward(q, state);
    return trajectory.root[frame] * placeAtZero(model, 0, model.findLink(leg.profile.base)) *
           leg.points(state).wrist;
}

struct Humanoid {
    const char* file;
    double most_ankle_mm, most_thigh_deg;  ///< in the mean; H1's hips are wider than a person's
};

/// Wherever a performer's foot stands, so does the robot's.
class RobotLegs : public RobotMapping, public ::testing::WithParamInterface<Humanoid> {};

TEST_P(RobotLegs, FeetThatStandKeepTheirPlace) {
    const auto [file, most_ankle_mm, most_thigh_deg] = GetParam();
    const RobotModel model = read(file);
    const RobotProfile profile = profileFor(model, 0);
    ASSERT_EQ(profile.legs.size(), 2U);
    MappingChoice choice;
    choice.legs = choice.trunk = true;
    const MotionClip clip = motion(kHandshake);
    const auto mapped = mapMotion(clip, model, profile, choice);
    ASSERT_TRUE(mapped) << mapped.error().text();
    ASSERT_EQ(mapped->root.size(), clip.frames.size());
    for (const ArmFigures& leg : mapped->legs) {
        std::printf("%s %s: thigh %.1f deg, shank %.1f deg, ankle %.2f mm (at most %.1f)\n", file,
                    leg.arm.c_str(), leg.upper_mean_deg, leg.forearm_mean_deg, leg.wrist_mean_mm,
                    leg.wrist_max_mm);
        EXPECT_LT(leg.wrist_mean_mm, most_ankle_mm);
        EXPECT_LT(leg.upper_mean_deg, most_thigh_deg) << "the knee looks where the performer's does";
    }
    const auto legs = legsOf(model, profile);
    ASSERT_TRUE(legs);
    std::vector<NamedBone> bones;
    for (const Joint& joint : clip.skeleton.joints())
        bones.push_back({joint.name, joint.parent});
    const auto named = jointsByName(bones);
    int standing = 0;
    double slid_m = 0, stood_s = 0;
    for (size_t frame = 1; frame < clip.frames.size(); ++frame)
        for (size_t s = 0; s < 2; ++s) {
            const int foot = named.bone_of_joint.at(s == 0 ? "LeftFoot" : "RightFoot");
            const auto human = [&](size_t f) {
                return globalPose(clip, f).p_world_joint[static_cast<size_t>(foot)];
            };
            const double moved_m = (human(frame) - human(frame - 1)).norm();
            if (moved_m > 0.03 * clip.frame_time_s)
                continue;
            ++standing;
            stood_s += clip.frame_time_s;
            slid_m +=
                (ankleOf(model, (*legs)[s], *mapped, frame) - ankleOf(model, (*legs)[s], *mapped, frame - 1))
                    .norm();
        }
    std::printf("%s: feet stand for %.1f s and slide by %.1f mm a second\n", file, stood_s,
                1e3 * slid_m / stood_s);
    ASSERT_GT(standing, 200);
    EXPECT_LT(slid_m / stood_s, 0.03);
}

TEST_P(RobotLegs, AreSavedWithTheProfile) {
    const RobotProfile made = profileFor(read(GetParam().file), 0);
    const auto back = profileFromJson(toJson(made), "p.json");
    ASSERT_TRUE(back) << back.error().text();
    ASSERT_EQ(back->legs.size(), 2U);
    EXPECT_EQ(back->legs[1].limb, Limb::kLeg);
    EXPECT_EQ(back->legs[1].elbow_joint, made.legs[1].elbow_joint);
    EXPECT_EQ(toJson(*back), toJson(made));
}

INSTANTIATE_TEST_SUITE_P(Humanoids, RobotLegs,
                         ::testing::Values(Humanoid{"unitree_g1/g1_29dof_rev_1_0.urdf", 1, 8},
                                           Humanoid{"unitree_h1/h1.urdf", 1, 10}));

/// The performer stands and swings both legs inwards until they would cross.
TEST_F(RobotMapping, LegsThatWouldTouchBrake) {
    const RobotModel model = read("unitree_g1/g1_29dof_rev_1_0.urdf");
    const RobotProfile profile = profileFor(model, 0);
    const Actor actor = defaultActor();
    MotionClip clip{"crossing", actor.skeleton, 0.01, {}, {}};
    for (int frame = 0; frame < 200; ++frame) {
        const double inwards_rad = radians(20) * std::min(1.0, frame / 100.0);
        clip.frames.push_back(actor.restPose());
        for (const auto& [name, sign] : {std::pair{"LeftUpLeg", -1.0}, std::pair{"RightUpLeg", 1.0}}) {
            Quaterniond& q =
                clip.frames.back().q_parent_joint[static_cast<size_t>(actor.skeleton.find(name))];
            q = axisAngle(Vector3d::UnitZ(), sign * inwards_rad) * q;
        }
    }
    MappingChoice choice;
    choice.legs = true;
    const auto mapped = mapMotion(clip, model, profile, choice);
    ASSERT_TRUE(mapped) << mapped.error().text();
    EXPECT_GT(mapped->held_frames, 0) << "the test brings them together";
    EXPECT_GT(mapped->nearest_m, 0) << mapped->nearest_parts;
}

TEST_F(RobotMapping, ARobotWithoutLegsIsNamed) {
    const RobotModel model = read("robonaut2/r2.urdf");
    RobotProfile profile = profileFor(model, 0);
    EXPECT_TRUE(profile.legs.empty());
    MappingChoice choice;
    choice.legs = true;
    const auto mapped = mapMotion(motion(kHandshake), model, profile, choice);
    ASSERT_FALSE(mapped);
    EXPECT_NE(mapped.error().message.find("has no two legs"), std::string::npos);
}

}  // namespace
}  // namespace noctule::robot
