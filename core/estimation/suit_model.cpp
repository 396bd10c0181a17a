// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/suit_model.h"

#include <algorithm>

#include "core/math/rotation.h"
#include "core/suit/placed_suit.h"

namespace noctule {
namespace {

/// Link of a segment, -1 for the world.
int linkOf(const std::string& segment, const Actor& actor, const KinematicTree& tree) {
    return segment.empty() ? -1 : tree.linkOfJoint(actor.skeleton.find(segment));
}

int jointOf(const std::string& name, const Skeleton& skeleton) {
    return name.empty() ? -1 : skeleton.find(name);
}

Result<MountedFlesh> mountFlesh(const BoardFlesh& flesh, const std::string& board, const Actor& actor) {
    MountedFlesh mounted{{}, Vector6::Zero(), flesh.tilt_rad, flesh.shift_m};
    for (size_t end = 0; end < 2; ++end) {
        const int joint = jointOf(flesh.joints[end], actor.skeleton);
        if (joint < 0 && !flesh.joints[end].empty())
            return Error{ErrorKind::kUnusable,
                         "calibration of board " + board + ": its soft tissue moves with joint '" +
                             flesh.joints[end] + "', which the performer does not have",
                         "Calibrate from movement with this performer"};
        mounted.joints[end] = joint;
        if (joint >= 0)
            mounted.at_rest.segment<3>(3 * static_cast<Eigen::Index>(end)) =
                halfSines(actor.rest_q_parent_joint[static_cast<size_t>(joint)].toRotationMatrix());
    }
    return mounted;
}

}  // namespace

PlacedBoard placeBoard(const MountedBoard& board, const KinematicTree& tree, const MotionState& state,
                       double offset_s) {
    if (!board.flesh)
        return {board.p_link_board, board.p_link_mic, board.R_link_board, Vector3d::Zero()};
    const MountedFlesh& flesh = *board.flesh;
    Vector6 features = -flesh.at_rest, rates = Vector6::Zero();
    for (size_t end = 0; end < 2; ++end) {
        if (flesh.joints[end] < 0)
            continue;
        const KinematicTree::JointTurn turn = tree.jointTurn(state, flesh.joints[end]);
        const auto at = 3 * static_cast<Eigen::Index>(end);
        rates.segment<3>(at) = halfSines(turn.R_parent_joint * skew(turn.omega_rad_per_s));
        features.segment<3>(at) += halfSines(turn.R_parent_joint);
    }
    features += offset_s * rates;
    const Vector3d tilt = flesh.tilt_rad * features;
    const Matrix3d E = expQuaternion(tilt).toRotationMatrix();
    const Vector3d p = board.p_link_board + flesh.shift_m * features;
    return {p, p + E * (board.p_link_mic - board.p_link_board), E * board.R_link_board,
            E * rightJacobian(tilt) * (flesh.tilt_rad * rates)};
}

std::vector<Matrix3d> mountingCovariances(const SuitModel& suit, const KinematicTree& tree,
                                          double unstated_rad) {
    std::vector<Matrix3d> covariances(tree.links().size(), Matrix3d::Zero());
    std::vector<int> boards(tree.links().size(), 0);
    for (const MountedBoard& board : suit.boards) {
        const Vector3d sigma_rad = board.sigma_mounting_rad.value_or(Vector3d::Constant(unstated_rad));
        if (board.link < 0 || sigma_rad.isZero())
            continue;
        const auto link = static_cast<size_t>(board.link);
        const Matrix3d of_board = sigma_rad.cwiseAbs2().asDiagonal();
        covariances[link] += board.R_link_board * of_board * board.R_link_board.transpose();
        ++boards[link];
    }
    for (size_t link = 0; link < covariances.size(); ++link)
        covariances[link] /= std::max(1, boards[link]);
    return covariances;
}

Result<SuitModel> mountSuit(const Suit& suit, const Calibration& calibration, const Actor& actor,
                            const KinematicTree& tree) {
    std::vector<std::string> names;
    for (const Joint& joint : actor.skeleton.joints())
        names.push_back(joint.name);
    Status checked = checkSegments(suit, names, "suit " + suit.name);
    if (!checked)
        return checked.error();
    SuitModel model;
    const Suit placed = placedSuit(suit, calibration);
    for (const Board& board : placed.boards) {
        const Vector3d p = board.p_segment_board_m;
        const Quaterniond q = board.q_segment_board;
        model.boards.push_back(
            {linkOf(board.segment, actor, tree), p, q.toRotationMatrix(), p + q * board.p_board_mic_m});
        model.boards.back().rate_hz = board.rate_hz;
        const BoardCalibration* known = calibration.findBoard(board.id);
        model.boards.back().sigma_mounting_rad = known ? known->sigma_mounting_rad : std::nullopt;
        if (!known || !known->flesh || model.boards.back().link < 0)
            continue;
        auto flesh = mountFlesh(*known->flesh, board.id, actor);
        if (!flesh)
            return flesh.error();
        model.boards.back().flesh = std::move(*flesh);
    }
    for (const Source& source : placed.sources)
        model.sources.push_back(
            {linkOf(source.segment, actor, tree), source.p_segment_source_m, source.normal_segment});
    return model;
}

}  // namespace noctule
