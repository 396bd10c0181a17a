// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_model.h"

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kLeastModelDistance_m = 1e-4;

Matrix3d inverseRight(const Vector3d& turn) {
    return rightJacobian(turn).inverse();
}

Vector3d logOf(const Matrix3d& R) {
    return logQuaternion(Quaterniond(R));
}

Matrix3d expOf(const Vector3d& turn) {
    return expQuaternion(turn).toRotationMatrix();
}

}  // namespace

MotionModel::MotionModel(const MotionBody& body, const Observations& take, const MotionLayout& layout,
                         double step_s)
    : body_(body), layout_(layout), step_s_(step_s), g_m_per_s2_(take.g_m_per_s2) {
    const auto part = [&](const std::string& segment) {
        const int joint = take.actor.skeleton.find(segment);
        require(joint >= 0, "a part of the suit that is not on the body");
        return Part{body.segmentOfJoint(joint), body.chain(joint)};
    };
    for (const Board& board : take.suit.boards) {
        boards_.push_back(part(board.segment));
        boards_.back().p_board_mic_m = board.p_board_mic_m;
    }
    for (const Source& source : take.suit.sources)
        sources_.push_back(part(source.segment));
}

void MotionModel::freezeFlesh(const MotionUnknowns& unknowns, const std::vector<int>& rest_of_node) {
    features_.assign(unknowns.nodes.size(), std::vector<Vector6>(boards_.size(), Vector6::Zero()));
    if (!layout_.flesh)
        return;
    for (size_t b = 0; b < boards_.size(); ++b) {
        const int segment = boards_[b].segment;
        for (size_t k = 0; k < unknowns.nodes.size(); ++k)
            features_[k][b] =
                jointFeatures(body_, unknowns.nodes[k], segment) -
                jointFeatures(body_, unknowns.nodes[static_cast<size_t>(rest_of_node[k])], segment);
    }
}

Matrix3d MotionModel::fleshTilt(const MotionUnknowns& unknowns, int board, int node) const {
    return expOf(constants(unknowns, board).tilt_rad * features(node, board));
}

Vector3d MotionModel::placeOnSegment(const MotionUnknowns& unknowns, int board, int node) const {
    const BoardConstants& b = constants(unknowns, board);
    return b.p_segment_board_m + b.shift_m * features(node, board);
}

Matrix3d MotionModel::boardOrientation(const MotionUnknowns& unknowns, int board, int node) const {
    return unknowns.nodes[static_cast<size_t>(node)]
               .R_world_segment[static_cast<size_t>(boardSegment(board))] *
           fleshTilt(unknowns, board, node) * constants(unknowns, board).q_segment_board.toRotationMatrix();
}

/// Derivatives by all that turns the board at one node; `by_turn`: by a turn of the board in its own frame.
void MotionModel::addGyroEnd(const MotionUnknowns& unknowns, int board, int node, int slot,
                             const Matrix3d& by_turn, ResidualBlock& block) const {
    const BoardConstants& b = constants(unknowns, board);
    const Matrix3d R_board_flesh = b.q_segment_board.toRotationMatrix().transpose();
    const Matrix3d R_board_segment = R_board_flesh * fleshTilt(unknowns, board, node).transpose();
    block.addNode(slot * layout_.nodeSize() + MotionLayout::segment(boardSegment(board)),
                  by_turn * R_board_segment);
    block.addBorder(layout_.mounting(board), by_turn);
    const Vector6& f = features(node, board);
    if (!layout_.flesh || f.isZero())
        return;
    const Matrix3d by_tilt = by_turn * R_board_flesh * rightJacobian(b.tilt_rad * f);
    for (int i = 0; i < 6; ++i)
        block.addBorder(layout_.tilt(board, i), Matrix3d(by_tilt * f[i]));
}

ResidualBlock MotionModel::gyro(const MotionUnknowns& unknowns, int board, int node, const BoardTurn& turn,
                                double since_middle_s) const {
    const BoardConstants& b = constants(unknowns, board);
    const Matrix3d R_begin_end =
        boardOrientation(unknowns, board, node).transpose() * boardOrientation(unknowns, board, node + 1);
    const Vector3d missed = logOf(turn.q_begin_end.toRotationMatrix().transpose() * R_begin_end);
    ResidualBlock block;
    block.first_node = node;
    block.residual = missed + step_s_ * (b.gyro_zero_rad_per_s + since_middle_s * b.gyro_drift_rad_per_s2);
    const Matrix3d by_end = inverseRight(missed);
    addGyroEnd(unknowns, board, node + 1, 1, by_end, block);
    addGyroEnd(unknowns, board, node, 0, -by_end * R_begin_end.transpose(), block);
    block.addBorder(layout_.gyroZero(board), Matrix3d(step_s_ * Matrix3d::Identity()));
    block.addBorder(layout_.gyroDrift(board), Matrix3d(step_s_ * since_middle_s * Matrix3d::Identity()));
    return block;
}

Vector3d MotionModel::place(const MotionUnknowns& unknowns, int board, int index) const {
    const MotionNode& node = unknowns.nodes[static_cast<size_t>(index)];
    Vector3d p = node.p_world_root_m;
    for (const ChainBone& link : boards_[static_cast<size_t>(board)].chain)
        p += node.R_world_segment[static_cast<size_t>(link.segment)] *
             (unknowns.bone_scale[static_cast<size_t>(link.bone)] * link.offset_m);
    return p + node.R_world_segment[static_cast<size_t>(boardSegment(board))] *
                   placeOnSegment(unknowns, board, index);
}

/// Gravity and acceleration seen from a board that turns.
void MotionModel::addAccelTurns(const MotionUnknowns& unknowns, int board, int node, const Vector3d& a_world,
                                ResidualBlock& block) const {
    const BoardConstants& b = constants(unknowns, board);
    const int segment = boardSegment(board);
    const Matrix3d R_board_flesh = b.q_segment_board.toRotationMatrix().transpose();
    const Matrix3d E = fleshTilt(unknowns, board, node);
    const Vector3d a_segment =
        unknowns.nodes[static_cast<size_t>(node)].R_world_segment[static_cast<size_t>(segment)].transpose() *
        a_world;
    const Vector3d a_flesh = E.transpose() * a_segment;
    block.addNode(layout_.nodeSize() + MotionLayout::segment(segment),
                  R_board_flesh * E.transpose() * skew(a_segment));
    block.addBorder(layout_.mounting(board), skew(R_board_flesh * a_flesh));
    const Vector6& f = features(node, board);
    if (!layout_.flesh || f.isZero())
        return;
    const Matrix3d by_tilt = R_board_flesh * skew(a_flesh) * rightJacobian(b.tilt_rad * f);
    for (int i = 0; i < 6; ++i)
        block.addBorder(layout_.tilt(board, i), Matrix3d(by_tilt * f[i]));
}

/// What moves the board's place at the three nodes.
void MotionModel::addAccelPlaces(const MotionUnknowns& unknowns, int board, int node,
                                 const Matrix3d& R_board_world, ResidualBlock& block) const {
    const Part& part = boards_[static_cast<size_t>(board)];
    Matrix3d by_place = Matrix3d::Zero();
    std::vector<Vector3d> by_bone(part.chain.size(), Vector3d::Zero());
    std::array<Matrix3d, 6> by_shift;
    by_shift.fill(Matrix3d::Zero());
    for (int slot = 0; slot < 3; ++slot) {
        const Matrix3d J = R_board_world * ((slot == 1 ? -2 : 1) / (step_s_ * step_s_));
        const MotionNode& at = unknowns.nodes[static_cast<size_t>(node - 1 + slot)];
        const int first = slot * layout_.nodeSize();
        block.addNode(first, J);
        for (size_t i = 0; i < part.chain.size(); ++i) {
            const ChainBone& link = part.chain[i];
            const Matrix3d& R = at.R_world_segment[static_cast<size_t>(link.segment)];
            const double scale = unknowns.bone_scale[static_cast<size_t>(link.bone)];
            block.addNode(first + MotionLayout::segment(link.segment), -J * R * skew(scale * link.offset_m));
            by_bone[i] += J * R * link.offset_m;
        }
        const Matrix3d J_R = J * at.R_world_segment[static_cast<size_t>(part.segment)];
        block.addNode(first + MotionLayout::segment(part.segment),
                      -J_R * skew(placeOnSegment(unknowns, board, node - 1 + slot)));
        by_place += J_R;
        for (int f = 0; f < 6; ++f)
            by_shift[static_cast<size_t>(f)] += J_R * features(node - 1 + slot, board)[f];
    }
    block.addBorder(layout_.place(board), by_place);
    for (size_t i = 0; i < part.chain.size(); ++i)
        block.addBorder(layout_.bone(part.chain[i].bone), by_bone[i]);
    for (int f = 0; layout_.flesh && f < 6; ++f)
        block.addBorder(layout_.shift(board, f), by_shift[static_cast<size_t>(f)]);
}

ResidualBlock MotionModel::accel(const MotionUnknowns& unknowns, int board, int node,
                                 const BoardForce& force) const {
    const Vector3d a_world = (place(unknowns, board, node - 1) - 2 * place(unknowns, board, node) +
                              place(unknowns, board, node + 1)) /
                                 (step_s_ * step_s_) +
                             g_m_per_s2_ * Vector3d::UnitY();
    const Matrix3d R_board_world = boardOrientation(unknowns, board, node).transpose();
    ResidualBlock block;
    block.first_node = node - 1;
    block.residual =
        R_board_world * a_world + constants(unknowns, board).accel_zero_m_per_s2 - force.mean_m_per_s2;
    addAccelTurns(unknowns, board, node, a_world, block);
    addAccelPlaces(unknowns, board, node, R_board_world, block);
    block.addBorder(layout_.accelZero(board), Matrix3d(Matrix3d::Identity()));
    return block;
}

MotionModel::Between MotionModel::between(const MotionUnknowns& unknowns, int node, int segment, double at) {
    const auto s = static_cast<size_t>(segment);
    const auto k = static_cast<size_t>(node);
    const Matrix3d& R = unknowns.nodes[k].R_world_segment[s];
    const Vector3d before = logOf(R.transpose() * unknowns.nodes[k - 1].R_world_segment[s]);
    const Vector3d after = logOf(R.transpose() * unknowns.nodes[k + 1].R_world_segment[s]);
    const double w_before = at * (at - 1) / 2, w_after = at * (at + 1) / 2;
    const Vector3d turn = w_before * before + w_after * after;
    const Matrix3d E = expOf(turn), right = rightJacobian(turn);
    return {R * E,
            {right * inverseRight(before) * w_before,
             E.transpose() - right * (w_before * inverseRight(-before) + w_after * inverseRight(-after)),
             right * inverseRight(after) * w_after}};
}

struct MotionModel::PartAt {
    Vector3d p_world_m;
    std::array<double, 3> root_weight;
    std::vector<Between> links;   ///< as the chain, then the segment itself
    std::vector<Vector3d> arm_m;  ///< in the segments' frames
};

MotionModel::PartAt MotionModel::partAt(const MotionUnknowns& unknowns, const Part& part,
                                        const Vector3d& p_segment_m, int node, double at) const {
    PartAt result{Vector3d::Zero(), {at * (at - 1) / 2, 1 - at * at, at * (at + 1) / 2}, {}, {}};
    for (size_t slot = 0; slot < 3; ++slot)
        result.p_world_m +=
            result.root_weight[slot] * unknowns.nodes[static_cast<size_t>(node) - 1 + slot].p_world_root_m;
    for (const ChainBone& link : part.chain) {
        const bool same =
            !result.links.empty() && &link != part.chain.data() &&
            part.chain[static_cast<size_t>(&link - part.chain.data()) - 1].segment == link.segment;
        result.links.push_back(same ? result.links.back() : between(unknowns, node, link.segment, at));
        result.arm_m.push_back(unknowns.bone_scale[static_cast<size_t>(link.bone)] * link.offset_m);
        result.p_world_m += result.links.back().R * result.arm_m.back();
    }
    result.links.push_back(between(unknowns, node, part.segment, at));
    result.arm_m.push_back(p_segment_m);
    result.p_world_m += result.links.back().R * p_segment_m;
    return result;
}

/// Derivatives of the place along `direction`, but for the place on the segment itself.
void MotionModel::addPart(const PartAt& at, const Part& part, const Vector3d& direction,
                          ResidualBlock& block) const {
    const auto row = [](const Eigen::RowVector3d& values) {
        Matrix3d J = Matrix3d::Zero();
        J.row(0) = values;
        return J;
    };
    const auto addTurns = [&](const Between& link, int segment, const Vector3d& arm_m) {
        const Eigen::RowVector3d by_turn = -direction.transpose() * link.R * skew(arm_m);
        for (int slot = 0; slot < 3; ++slot)
            block.addNode(slot * layout_.nodeSize() + MotionLayout::segment(segment),
                          row(by_turn * link.by[static_cast<size_t>(slot)]));
    };
    for (int slot = 0; slot < 3; ++slot)
        block.addNode(slot * layout_.nodeSize(),
                      row(direction.transpose() * at.root_weight[static_cast<size_t>(slot)]));
    for (size_t i = 0; i < part.chain.size(); ++i) {
        const ChainBone& link = part.chain[i];
        addTurns(at.links[i], link.segment, at.arm_m[i]);
        block.addBorder(layout_.bone(link.bone),
                        Vector3d(direction.dot(at.links[i].R * link.offset_m), 0, 0));
    }
    addTurns(at.links.back(), part.segment, at.arm_m.back());
}

ResidualBlock MotionModel::distance(const MotionUnknowns& unknowns, const HeardDistance& heard,
                                    int first_node) const {
    const int node = first_node + heard.node;
    const Part &board = boards_[static_cast<size_t>(heard.board)],
               &source = sources_[static_cast<size_t>(heard.source)];
    const SourceConstants& from = unknowns.sources[static_cast<size_t>(heard.source)];
    const BoardConstants& to = constants(unknowns, heard.board);
    const Vector3d p_mic =
        placeOnSegment(unknowns, heard.board, node) + to.q_segment_board * board.p_board_mic_m;
    const PartAt mic = partAt(unknowns, board, p_mic, node, heard.arrived);
    const PartAt speaker = partAt(unknowns, source, from.p_segment_source_m, node, heard.emitted);
    const Vector3d apart_m = mic.p_world_m - speaker.p_world_m;
    const double length_m = std::max(apart_m.norm(), kLeastModelDistance_m);
    const Vector3d direction = apart_m / length_m * unknowns.sound_scale;
    ResidualBlock block;
    block.first_node = node - 1;
    block.rows = 1;
    block.residual[0] = length_m * unknowns.sound_scale + from.offset_m - heard.distance_m;
    addPart(mic, board, direction, block);
    addPart(speaker, source, -direction, block);
    const auto onSegment = [&](int first, const Matrix3d& R, double factor) {
        Matrix3d J = Matrix3d::Zero();
        J.row(0) = factor * direction.transpose() * R;
        block.addBorder(first, J);
    };
    const Matrix3d& R_mic = mic.links.back().R;
    onSegment(layout_.place(heard.board), R_mic, 1);
    if (!board.p_board_mic_m.isZero())
        onSegment(layout_.mounting(heard.board),
                  -R_mic * to.q_segment_board.toRotationMatrix() * skew(board.p_board_mic_m), 1);
    for (int f = 0; layout_.flesh && f < 6; ++f)
        onSegment(layout_.shift(heard.board, f), R_mic, features(node, heard.board)[f]);
    onSegment(layout_.source(heard.source), speaker.links.back().R, -1);
    block.addBorder(layout_.offset(heard.source), Vector3d(Vector3d::UnitX()));
    block.addBorder(layout_.soundScale(), Vector3d(length_m, 0, 0));
    return block;
}

}  // namespace noctule
