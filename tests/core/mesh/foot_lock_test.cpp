// SPDX-License-Identifier: Apache-2.0
// Feet that stand keep their place on bodies of other proportions, and knees do not snap for it.
#include <gtest/gtest.h>

#include "core/formats/bvh.h"
#include "core/math/rotation.h"
#include "core/mesh/retarget/moving_body.h"
#include "core/mesh/rig/bone_map.h"
#include "core/mesh/rig/wearable.h"
#include "core/motion/foot_contacts.h"
#include "tests/support/named_rig.h"
#include "tests/support/shared_meshes.h"

namespace noctule {
namespace {

/// Frames of a motion and when its feet stand.
struct Walk {
    Skeleton skeleton;
    StandingFeet feet;
    FeetAtRest at_rest;
};

Walk walkOf(const std::string& path, BvhUnit unit) {
    const MotionClip clip = toClip(readBvh(path).value(), unit).value();
    TimedMotion timed{clip.skeleton, {}};
    for (size_t f = 0; f < clip.frames.size(); ++f)
        timed.frames.push_back(
            {std::llround(static_cast<double>(f) * clip.frame_time_s * 1e9), clip.frames[f], {}});
    Walk walk{clip.skeleton, {clip.frames, clip.frame_time_s, {}}, {}};
    for (const FootContacts& foot : findFootContacts(timed))
        for (const FootContact& contact : foot.contacts)
            walk.feet.plants[foot.foot == "LeftFoot" ? 0 : 1].push_back({contact.from_s, contact.to_s});
    walk.at_rest = feetAtRest(walk.skeleton, walk.feet.plants, [&](double t_s) {
        return poseAt(timed, std::llround(t_s * 1e9), bridgeableGap_ns(timed));
    });
    return walk;
}

const Walk& sampleWalk() {
    static const Walk walk = walkOf(NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh", BvhUnit::kCentimetre);
    return walk;
}

/// What feet and knees do over a whole motion.
struct Steps {
    double slide_m = 0;         ///< of the point that stood longest, from its mean, at most; mean over stands
    double height_m = 0;        ///< of the lower point above where it should be, at most, within stands
    double knee_rad_per_s = 0;  ///< fastest
    double faster_rad_per_s = 0;  ///< by which a knee turns otherwise than without corrections, at most
};

/// The middle three fifths of a stand, as in FootContact::slide_m.
std::pair<size_t, size_t> middleOf(const FootPlant& plant, double frame_time_s, size_t frames) {
    const double fifth = (plant.to_s - plant.from_s) / 5;
    const auto at = [&](double t_s) {
        return std::min(frames - 1, static_cast<size_t>(std::lround(std::max(0.0, t_s) / frame_time_s)));
    };
    return {at(plant.from_s + fifth), at(plant.to_s - fifth)};
}

double kneeAngle(const LegPlaces& leg) {
    const Vector3d thigh = leg.knee - leg.hip, shin = leg.ankle - leg.knee;
    return std::atan2(thigh.cross(shin).norm(), thigh.dot(shin));
}

/// How far heel or toes, the better of them, wandered along the ground.
double slideOf(const std::vector<std::array<LegPlaces, 2>>& legs, size_t side, size_t first, size_t last) {
    double least = 1e9;
    for (size_t point = 0; point < 2; ++point) {
        Vector3d mean = Vector3d::Zero();
        double far = 0;
        for (size_t f = first; f <= last; ++f)
            mean += legs[f][side].sole[point] / static_cast<double>(last - first + 1);
        for (size_t f = first; f <= last; ++f) {
            const Vector3d off = legs[f][side].sole[point] - mean;
            far = std::max(far, std::hypot(off.x(), off.z()));
        }
        least = std::min(least, far);
    }
    return least;
}

Steps stepsOf(const Retargeter& retargeter, const StandingFeet& feet,
              const std::vector<FootCorrections>& corrections) {
    std::vector<std::array<LegPlaces, 2>> legs;
    for (size_t f = 0; f < feet.frames.size(); ++f)
        legs.push_back(
            retargeter.legs(feet.frames[f], corrections.empty() ? FootCorrections() : corrections[f]));
    Steps steps;
    size_t stands = 0;
    for (size_t side = 0; side < 2; ++side) {
        for (const FootPlant& plant : feet.plants[side]) {
            const auto [first, last] = middleOf(plant, feet.frame_time_s, legs.size());
            steps.slide_m += slideOf(legs, side, first, last);
            ++stands;
            for (size_t f = first; f <= last; ++f) {
                const LegPlaces& leg = legs[f][side];
                const double ours = std::min(leg.sole_ours[0].y(), leg.sole_ours[1].y());
                const double theirs = std::min(leg.sole[0].y(), leg.sole[1].y());
                steps.height_m = std::max(steps.height_m, std::abs(theirs - retargeter.scale() * ours));
            }
        }
        for (size_t f = 1; f < legs.size(); ++f)
            steps.knee_rad_per_s = std::max(
                steps.knee_rad_per_s,
                std::abs(kneeAngle(legs[f][side]) - kneeAngle(legs[f - 1][side])) / feet.frame_time_s);
        for (size_t f = 1; f < corrections.size(); ++f)
            steps.faster_rad_per_s =
                std::max(steps.faster_rad_per_s,
                         std::abs(corrections[f][side].knee_rad - corrections[f - 1][side].knee_rad) /
                             feet.frame_time_s);
    }
    steps.slide_m /= static_cast<double>(std::max<size_t>(1, stands));
    return steps;
}

/// Where skin is over a whole motion, above what our own lower sole stands on; metres of the target.
struct SkinOnFloor {
    double lowest_m = 0;                    ///< of all skin
    double off_mean_m = 0, off_most_m = 0;  ///< from their place at rest, of soles that lie flat
};

/// A vertex of a sole, and how high it is when the body stands at rest.
struct SoleVertex {
    size_t vertex;
    double height_m;
};

std::vector<SoleVertex> soleOf(const RiggedMesh& rig, const std::string& foot) {
    const int node = rig.find(findBoneMap(rig).node_of_joint.at(foot));
    std::vector<bool> below(rig.nodes.size(), false);
    for (size_t n = 0; n < rig.nodes.size(); ++n) {
        const int parent = rig.nodes[n].parent;
        below[n] = static_cast<int>(n) == node || (parent >= 0 && below[static_cast<size_t>(parent)]);
    }
    const auto rest = skinned(rig.skin, skinMatrices(rig, restPose(rig))).points_m;
    const float ground =
        std::ranges::min_element(rest, {}, [](const Eigen::Vector3f& p) { return p.y(); })->y();
    std::vector<SoleVertex> sole;
    for (size_t v = 0; v < rest.size(); ++v) {
        const SkinnedVertex& vertex = rig.skin.vertices[v];
        const double height_m = rest[v].y() - ground;
        if (height_m < 0.01 && below[static_cast<size_t>(rig.node_of_bone[vertex.bones[0]])] &&
            vertex.weights[0] > 0.9F)
            sole.push_back({v, height_m});
    }
    return sole;
}

SkinOnFloor skinOnFloor(const RiggedMesh& rig, const Retargeter& retargeter, const Walk& walk,
                        const std::vector<FootCorrections>& corrections) {
    SkinOnFloor seen;
    const std::array soles{soleOf(rig, "LeftFoot"), soleOf(rig, "RightFoot")};
    double count = 0;
    for (size_t f = 0; f < walk.feet.frames.size(); ++f) {
        const Pose& pose = walk.feet.frames[f];
        const auto legs = retargeter.legs(pose, corrections[f]);
        double floor_m = 1e9;
        for (const LegPlaces& leg : legs)
            for (const Vector3d& p : leg.sole_ours)
                floor_m = std::min(floor_m, retargeter.scale() * p.y());
        const auto skin =
            skinned(rig.skin, skinMatrices(rig, retargeter.pose(pose, corrections[f]))).points_m;
        for (const Eigen::Vector3f& p : skin)
            seen.lowest_m = std::min(seen.lowest_m, p.y() - floor_m);
        for (size_t side = 0; side < 2; ++side) {
            const auto [low, high] = std::minmax(legs[side].sole_ours[0].y(), legs[side].sole_ours[1].y());
            if (retargeter.scale() * low > floor_m + 0.005 || high - low > 0.005)
                continue;
            for (const SoleVertex& sole : soles[side]) {
                const double off_m = std::abs(skin[sole.vertex].y() - floor_m - sole.height_m);
                seen.off_most_m = std::max(seen.off_most_m, off_m);
                seen.off_mean_m += off_m;
                ++count;
            }
        }
    }
    EXPECT_GT(count, 1000) << "soles that lie flat";
    seen.off_mean_m /= count;
    return seen;
}

/// Shins a third longer, thighs shorter, hips wider and feet longer than ours.
RiggedMesh oddLegs() {
    RiggedMesh rig = test::namedRig([](const std::string& joint) { return joint; });
    for (RigNode& node : rig.nodes) {
        auto p = node.T_world_rest.translation();
        const bool left = node.name.starts_with("Left");
        if (node.name.ends_with("UpLeg") || node.name.ends_with("Leg") || node.name.ends_with("Foot") ||
            node.name.ends_with("ToeBase"))
            p.x() += left ? 0.06 : -0.06;
        if (node.name == "LeftLeg" || node.name == "RightLeg")
            p.y() += 0.10;
        if (node.name.ends_with("Foot") || node.name.ends_with("ToeBase"))
            p.y() -= 0.05;
        if (node.name.ends_with("ToeBase"))
            p.z() += 0.05;
    }
    return rig;
}

class FootLock : public testing::Test {
protected:
    static Retargeter retargeterFor(const RiggedMesh& rig, const Walk& walk) {
        auto made = Retargeter::make(rig, bonesFor(findBoneMap(rig), walk.skeleton), walk.skeleton,
                                     walk.at_rest, "rig");
        EXPECT_TRUE(made) << made.error().text();
        return made.value();
    }
};

TEST_F(FootLock, StandingFeetStopSliding) {
    const Walk& walk = sampleWalk();
    ASSERT_GT(walk.feet.plants[0].size() + walk.feet.plants[1].size(), 3U);
    const Retargeter retargeter = retargeterFor(oddLegs(), walk);
    const auto locked = lockFeet(retargeter, walk.feet);
    const Steps before = stepsOf(retargeter, walk.feet, {}), after = stepsOf(retargeter, walk.feet, locked);
    std::printf("odd legs: %.1f -> %.1f mm, height %.1f -> %.1f mm, knee %.1f -> %.1f rad/s\n",
                1e3 * before.slide_m, 1e3 * after.slide_m, 1e3 * before.height_m, 1e3 * after.height_m,
                before.knee_rad_per_s, after.knee_rad_per_s);
    EXPECT_GT(before.slide_m, 0.005) << "else there is nothing to show";
    EXPECT_LT(after.slide_m, 0.2 * before.slide_m);
    EXPECT_LT(after.height_m, 0.005);
    EXPECT_LT(after.faster_rad_per_s, kMostKnee_rad_per_s * (1 + 1e-9));
}

TEST_F(FootLock, WhatIsNotHeldIsLeftAlone) {
    const Walk& walk = sampleWalk();
    const Retargeter retargeter = retargeterFor(oddLegs(), walk);
    StandingFeet flying = walk.feet;
    flying.plants = {};
    for (const FootCorrections& corrections : lockFeet(retargeter, flying))
        for (const FootCorrection& foot : corrections) {
            EXPECT_EQ(foot.p_root.norm(), 0);
            EXPECT_EQ(foot.knee_rad, 0);
        }
    EXPECT_TRUE(lockFeet(retargeter, {}).empty());
    const auto locked = lockFeet(retargeter, walk.feet);
    const RiggedMesh rig = oddLegs();
    for (size_t f = 0; f < walk.feet.frames.size(); f += 50) {
        const RigPose free = retargeter.pose(walk.feet.frames[f]);
        const RigPose held = retargeter.pose(walk.feet.frames[f], locked[f]);
        for (size_t n = 0; n < free.size(); ++n) {
            const std::string& name = rig.nodes[n].name;
            const bool is_leg = name.ends_with("Leg") || name.ends_with("Foot") || name.ends_with("ToeBase");
            const double moved = (free[n].translation() - held[n].translation()).norm();
            EXPECT_LT(moved, is_leg ? 0.12 : 1e-12) << name;
            if (name.ends_with("Foot")) {
                EXPECT_LT((free[n].linear() - held[n].linear()).norm(), 1e-12) << "keeps its direction";
            }
        }
    }
}

/// A pose is turned and carried about the vertical: what was found serves it, for it is told in the root's
/// frame.
TEST_F(FootLock, AHeldRootKeepsItsLegs) {
    const Walk& walk = sampleWalk();
    const Retargeter retargeter = retargeterFor(oddLegs(), walk);
    const auto locked = lockFeet(retargeter, walk.feet);
    const size_t frame = walk.feet.frames.size() / 2;
    Pose held = walk.feet.frames[frame];
    const Quaterniond turn = axisAngle(Vector3d::UnitY(), 1.2);
    held.q_parent_joint[0] = turn * held.q_parent_joint[0];
    held.p_world_root = turn * held.p_world_root + Vector3d(0.7, 0, -3);
    const RigPose a = retargeter.pose(walk.feet.frames[frame], locked[frame]);
    const RigPose b = retargeter.pose(held, locked[frame]);
    const Vector3d moved = retargeter.scale() * Vector3d(0.7, 0, -3);
    for (size_t n = 1; n < a.size(); ++n)
        EXPECT_LT((turn * a[n].translation() + moved - b[n].translation()).norm(), 1e-9) << n;
}

TEST_F(FootLock, TheKneeTurnsSoThatTheLegReaches) {
    LegPlaces leg;
    leg.hip = {0, 0.9, 0};
    leg.knee = {0, 0.5, 0.05};
    leg.ankle = {0, 0.1, 0};
    leg.knee_axis = Vector3d::UnitX();
    for (const Vector3d& shift : {Vector3d(0.02, 0.03, 0.01), Vector3d(0, 0.1, -0.05), Vector3d(0, 0, 0)}) {
        const Vector3d bent =
            leg.knee + axisAngle(leg.knee_axis, leg.kneeTurn(shift)) * (leg.ankle - leg.knee);
        EXPECT_NEAR((bent - leg.hip).norm(), (leg.ankle + shift - leg.hip).norm(), 1e-9);
    }
    EXPECT_GT(leg.kneeTurn({0, 0.1, 0}), 0.1) << "bends as knees do, the heel to the back";
    EXPECT_NEAR(leg.kneeTurn({0, -1, 0}), -2 * std::atan2(0.05, 0.4), 1e-6) << "no further than straight";
}

/// The bodies of others, on a walk of a real person.
TEST_F(FootLock, OtherProgramsFigures) {
    const std::string path = test::sharedPath("bvh/cmu/02_01.bvh");
    if (!test::isShared("bvh/cmu/02_01.bvh") || !test::isShared(test::kKenney))
        GTEST_SKIP() << path << " or " << test::sayMissing(test::kKenney);
    const auto document = readBvh(path).value();
    const Walk walk = walkOf(path, chooseUnit(document).unit);
    const std::pair<const char*, RiggedMesh> bodies[] = {{"CesiumMan", test::sharedMesh(test::kCesiumMan)},
                                                         {"Kenney", test::sharedMesh(test::kKenney)},
                                                         {"MakeHuman", test::MakeHuman().mesh()}};
    for (const auto& [name, rig] : bodies) {
        const Retargeter retargeter = retargeterFor(rig, walk);
        const auto locked = lockFeet(retargeter, walk.feet);
        const Steps before = stepsOf(retargeter, walk.feet, {});
        const Steps after = stepsOf(retargeter, walk.feet, locked);
        const double mm = 1e3 / retargeter.scale();  // as large as the performer
        std::printf("%s: slide %.1f -> %.1f mm, height %.1f -> %.1f mm, knee %.1f -> %.1f rad/s\n", name,
                    mm * before.slide_m, mm * after.slide_m, mm * before.height_m, mm * after.height_m,
                    before.knee_rad_per_s, after.knee_rad_per_s);
        const SkinOnFloor skin = skinOnFloor(rig, retargeter, walk, locked);
        std::printf("%s: skin %.1f mm above the floor at least, flat soles off by %.1f, at most %.1f mm\n",
                    name, mm * skin.lowest_m, mm * skin.off_mean_m, mm * skin.off_most_m);
        EXPECT_GT(mm * skin.lowest_m, -10) << name;
        EXPECT_LT(mm * skin.off_mean_m, 4) << name;
        EXPECT_LT(after.slide_m, before.slide_m) << name;
        EXPECT_LT(mm * after.slide_m, 3) << name;
        EXPECT_LT(after.knee_rad_per_s, before.knee_rad_per_s + kMostKnee_rad_per_s) << name;
    }
}

}  // namespace
}  // namespace noctule
