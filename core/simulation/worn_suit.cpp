// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/worn_suit.h"

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "core/simulation/motion_fit.h"
#include "core/simulation/random.h"

namespace noctule::simulation {
namespace {

PoseShift drawPoseShift(Random& random, double bound) {
    PoseShift shift;
    shift.bound = bound;
    for (int i = 0; i < 3; ++i)
        for (int c = 0; c < 6; ++c)
            shift.slope(i, c) = random.gaussian();
    return shift;
}

void drawFlesh(WornBoard& worn, const Board& board, const SoftTissue& tissue, Random random) {
    worn.wobble_axis = random.direction();
    worn.shift_m = drawPoseShift(random, tissue.pose_displacement_m_max);
    worn.tilt_rad = drawPoseShift(random, tissue.pose_rotation_rad_max);
    const bool twists = board.segment.ends_with("ForeArm") || board.segment.ends_with("UpLeg");
    worn.twist_lag = twists ? tissue.axial_twist_lag : 0;
}

/// A transceiver: its source sits where the board really is, up to the housing's error.
WornSource inHousing(const Source& source, const Board& board, const WornBoard& worn,
                     const Vector3d& housing_error_m) {
    WornSource w;
    w.segment = worn.segment;
    w.p_board_source_m =
        board.q_segment_board.conjugate() * (source.p_segment_source_m - board.p_segment_board_m) +
        housing_error_m;
    w.normal_board = board.q_segment_board.conjugate() * source.normal_segment;
    w.p_segment_source_m = worn.p_segment_board_m + worn.q_segment_board * w.p_board_source_m;
    w.normal_segment = worn.q_segment_board * w.normal_board;
    return w;
}

}  // namespace

Result<WornSuit> wear(const Suit& suit, const Skeleton& skeleton, const Scenario& scenario, uint64_t seed) {
    std::vector<std::string> names;
    for (const Joint& joint : skeleton.joints())
        names.push_back(joint.name);
    Status known = checkSegments(suit, names, "suit " + suit.name);
    if (!known)
        return known.error();

    WornSuit worn;
    for (size_t b = 0; b < suit.boards.size(); ++b) {
        const Board& board = suit.boards[b];
        Random random(seed, "board mounting", b);
        WornBoard w;
        w.segment = board.segment.empty() ? -1 : skeleton.find(board.segment);
        w.p_segment_board_m = board.p_segment_board_m + random.gaussianVector(scenario.mounting_m);
        w.q_segment_board =
            board.q_segment_board * expQuaternion(random.gaussianVector(scenario.mounting_rad));
        w.p_board_mic_m = board.p_board_mic_m;
        if (scenario.soft_tissue && w.segment >= 0)
            drawFlesh(w, board, *scenario.soft_tissue, Random(seed, "soft tissue", b));
        worn.boards.push_back(w);
    }
    for (size_t s = 0; s < suit.sources.size(); ++s) {
        const Source& source = suit.sources[s];
        if (const int b = suit.findBoard(source.board); !source.board.empty() && b >= 0) {
            if (suit.boards[b].segment != source.segment)
                return Error{ErrorKind::kUnusable,
                             "suit " + suit.name + ": source '" + source.id +
                                 "' sits on another segment than board '" + source.board +
                                 "', with which it shares a housing",
                             "Give both the same segment in the suit's description"};
            worn.sources.push_back(
                inHousing(source, suit.boards[b], worn.boards[b],
                          Random(seed, "housing", s).gaussianVector(scenario.cast.housing_m)));
            worn.sources.back().board = b;
            continue;
        }
        Random random(seed, "source mounting", s);
        worn.sources.push_back({source.segment.empty() ? -1 : skeleton.find(source.segment),
                                source.p_segment_source_m + random.gaussianVector(scenario.source_position_m),
                                source.normal_segment});
    }
    return worn;
}

Actor withScaledBones(const Actor& actor, const Scenario& scenario, uint64_t seed) {
    std::vector<Joint> joints = actor.skeleton.joints();
    for (size_t j = 0; j < joints.size(); ++j) {
        const double scale = 1 + Random(seed, "bone", j).gaussian(scenario.bone_scale);
        joints[j].offset_m *= scale;
        if (joints[j].end_m)
            *joints[j].end_m *= scale;
    }
    Actor scaled = actor;
    scaled.skeleton = Skeleton::make(std::move(joints)).value();
    return scaled;
}

std::vector<double> heldRestRow(const Coordinates& coordinates, const Actor& actor, const Scenario& scenario,
                                uint64_t seed) {
    Pose pose{Vector3d::Zero(), actor.rest_q_parent_joint};
    for (int j = 1; j < coordinates.skeleton().size(); ++j) {
        const Joint& joint = coordinates.skeleton().joint(j);
        Random random(seed, "held rest pose", static_cast<uint64_t>(j));
        Eigen::VectorXd angles = projectOntoJoint(joint, pose.q_parent_joint[j], false).angles_rad;
        if (joint.type == JointType::kBall) {
            pose.q_parent_joint[j] =
                pose.q_parent_joint[j] * expQuaternion(random.gaussianVector(scenario.initial_pose_rad));
        } else if (angles.size() > 0) {
            for (double& angle : angles)
                angle += random.gaussian(scenario.initial_pose_rad);
            pose.q_parent_joint[j] = rotationFromAngles(joint, angles);
        }
    }
    std::vector<double> row = coordinates.fromPose(pose);
    row[1] -= lowestPoint(coordinates, row);
    return row;
}

}  // namespace noctule::simulation
