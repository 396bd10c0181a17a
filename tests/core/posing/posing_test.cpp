// SPDX-License-Identifier: Apache-2.0
// Sensors without magnetometers on a made walk: mounted anyhow, headings random and drifting.
#include <gtest/gtest.h>

#include "tests/core/posing/made_walk.h"

namespace noctule::posing {
namespace {

using test::kWhole;
using test::madeSuit;
using test::MadeSuit;

const std::vector<std::string> kLegs = {"Hips",       "LeftUpLeg", "LeftLeg",  "LeftFoot",
                                        "RightUpLeg", "RightLeg",  "RightFoot"};

BodyMotion posed(const Actor& actor, const SensorTracks& tracks) {
    auto motion = poseBody(actor, tracks, std::nullopt, {}, {});
    EXPECT_TRUE(motion) << motion.error().text();
    return motion ? *motion : BodyMotion{};
}

/// Root mean square error of a segment's attitude against that of another one, degrees.
double segmentError_deg(const Actor& actor, const BodyMotion& motion, const MadeSuit& suit,
                        const std::string& segment, const std::string& against) {
    const auto a = size_t(actor.skeleton.find(against)), b = size_t(actor.skeleton.find(segment));
    double sum = 0;
    for (size_t i = 0; i < motion.poses.size(); ++i) {
        const GlobalPose is = globalPose(actor.skeleton, *motion.poses[i].pose);
        const GlobalPose should = globalPose(actor.skeleton, suit.truth[i]);
        sum += std::pow(angleBetween(is.q_world_joint[a].conjugate() * is.q_world_joint[b],
                                     should.q_world_joint[a].conjugate() * should.q_world_joint[b]),
                        2);
    }
    return degrees(std::sqrt(sum / double(motion.poses.size())));
}

/// The same of one joint.
double jointError_deg(const Actor& actor, const BodyMotion& motion, const MadeSuit& suit,
                      const std::string& name) {
    const int parent = actor.skeleton.joint(actor.skeleton.find(name)).parent;
    return segmentError_deg(actor, motion, suit, name, actor.skeleton.joint(parent).name);
}

TEST(PoseBody, SixteenSensorsWithoutMagnetometersFindTheWalk) {
    const Actor actor = defaultActor();
    for (unsigned seed = 1; seed <= 2; ++seed) {
        const MadeSuit suit = madeSuit(actor, kWhole, seed);
        const BodyMotion motion = posed(actor, suit.tracks);
        ASSERT_EQ(motion.poses.size(), suit.truth.size());
        EXPECT_TRUE(motion.standing.walks);
        for (const std::string& warning : motion.warnings)
            ADD_FAILURE() << warning;
        for (const std::string& segment : kWhole) {
            const double error = segmentError_deg(actor, motion, suit, segment, "Hips");
            EXPECT_LT(error, 5) << segment << ", seed " << seed;
        }
    }
}

TEST(PoseBody, LegsAndASingleLegAreEnough) {
    const Actor actor = defaultActor();
    const MadeSuit legs = madeSuit(actor, kLegs, 3);
    const BodyMotion both = posed(actor, legs.tracks);
    const MadeSuit leg = madeSuit(actor, {"RightUpLeg", "RightLeg", "RightFoot"}, 4);
    const BodyMotion one = posed(actor, leg.tracks);
    ASSERT_FALSE(both.poses.empty() || one.poses.empty());
    for (const char* joint : {"LeftLeg", "RightLeg", "LeftUpLeg", "RightFoot"})
        EXPECT_LT(jointError_deg(actor, both, legs, joint), 3) << joint;
    EXPECT_LT(jointError_deg(actor, one, leg, "RightLeg"), 3);
    EXPECT_LT(jointError_deg(actor, one, leg, "RightFoot"), 3);
}

TEST(PoseBody, SensorsThatLeaveAndReturnMakeNoJump) {
    const Actor actor = defaultActor();
    MadeSuit suit = madeSuit(actor, kWhole, 5);
    const BodyMotion whole = posed(actor, suit.tracks);
    for (SensorTrack& track : suit.tracks.sensors)
        if (track.segment == "LeftForeArm" || track.segment == "LeftHand" || track.segment == "RightLeg")
            for (size_t i = 900; i < 1300; ++i)
                track.q_world_sensor[i].coeffs().setConstant(std::nan(""));
    const BodyMotion motion = posed(actor, suit.tracks);
    ASSERT_EQ(motion.poses.size(), suit.truth.size());
    const auto quickest = [](const BodyMotion& of) {
        double most = 0;
        for (size_t i = 1; i < of.poses.size(); ++i)
            for (size_t j = 0; j < of.poses[i].pose->q_parent_joint.size(); ++j)
                most = std::max(most, angleBetween(of.poses[i].pose->q_parent_joint[j],
                                                   of.poses[i - 1].pose->q_parent_joint[j]));
        return degrees(most);
    };
    EXPECT_LT(quickest(motion), 1.6 * quickest(whole));
    // Nothing is known of a joint while its sensor is away, and that is said.
    const auto knee = size_t(3 * actor.skeleton.find("RightLeg"));
    EXPECT_GT(motion.poses[1100].sigma_rad[knee], 4 * motion.poses[700].sigma_rad[knee]);
    // The others go on as before.
    EXPECT_LT(jointError_deg(actor, motion, suit, "LeftLeg"), 3);
}

/// An actor whose rest pose is that in which the made walk begins.
Actor actorWhoRestsStanding() {
    Actor actor = defaultActor();
    actor.rest_q_parent_joint = standingPose(actor, false).q_parent_joint;
    return actor;
}

/// Mountings as a suit states them: each is off by some degrees about each axis.
void stateMountings(MadeSuit& suit, double off_deg) {
    for (size_t s = 0; s < suit.tracks.sensors.size(); ++s) {
        const double sign = s % 2 == 0 ? 1 : -1;
        suit.tracks.sensors[s].mounting = StatedMounting{
            expQuaternion(radians(off_deg) * Vector3d(sign, -sign, 0.5)) * suit.q_segment_sensor[s], 0.15};
    }
}

double worstSegment_deg(const Actor& actor, const MadeSuit& suit) {
    const auto motion = poseBody(actor, suit.tracks, std::pair<size_t, size_t>{25, 75}, {}, {});
    if (!motion)
        return ADD_FAILURE() << motion.error().text(), 180;
    double worst = 0;
    for (const std::string& segment : kWhole)
        worst = std::max(worst, segmentError_deg(actor, *motion, suit, segment, "Hips"));
    return worst;
}

TEST(PoseBody, AMarkedRestPoseAndStatedMountingsGiveHeadingsThatNoMovementTells) {
    const Actor actor = actorWhoRestsStanding();
    for (unsigned seed = 7; seed <= 8; ++seed) {
        MadeSuit suit = madeSuit(actor, kWhole, seed);
        for (SensorTrack& track : suit.tracks.sensors)
            for (Vector3d& accel : track.accel_m_per_s2)
                accel.setConstant(std::nan(""));
        EXPECT_GT(worstSegment_deg(actor, suit), 30) << "seed " << seed;
        stateMountings(suit, 4);
        EXPECT_LT(worstSegment_deg(actor, suit), 12) << "seed " << seed;
    }
}

TEST(PoseBody, AMountingThatIsStatedWrongIsOutvotedByTheMovement) {
    const Actor actor = actorWhoRestsStanding();
    MadeSuit suit = madeSuit(actor, kWhole, 9);
    stateMountings(suit, 4);
    const double right = worstSegment_deg(actor, suit);
    for (SensorTrack& track : suit.tracks.sensors)
        if (track.segment == "LeftLeg")
            track.mounting->q_segment_sensor =
                axisAngle(Vector3d::UnitY(), radians(70)) * track.mounting->q_segment_sensor;
        else if (track.segment == "RightForeArm")
            track.mounting->q_segment_sensor =
                axisAngle(Vector3d::UnitZ(), radians(170)) * track.mounting->q_segment_sensor;
    EXPECT_LT(right, 5);
    EXPECT_LT(worstSegment_deg(actor, suit), 6);
}

TEST(PoseBody, ErrorsNameWhatIsMissing) {
    const Actor actor = defaultActor();
    SensorTracks tracks = madeSuit(actor, {"Hips"}, 6).tracks;
    tracks.sensors[0].segment.clear();
    const auto nowhere = poseBody(actor, tracks, std::nullopt, {}, {});
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().kind, ErrorKind::kUnusable);
}

}  // namespace
}  // namespace noctule::posing
