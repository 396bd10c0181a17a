// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_start.h"

#include <cmath>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kUprightPerSecond = 0.2;
constexpr double kNearG_m_per_s2 = 2;

/// Orientations of the segments in the world in the rest pose.
std::vector<Quaterniond> restOrientations(const MotionBody& body) {
    std::vector<Quaterniond> q_world;
    for (const BodySegment& segment : body.segments())
        q_world.push_back(segment.parent < 0
                              ? segment.q_parent_rest
                              : q_world[static_cast<size_t>(segment.parent)] * segment.q_parent_rest);
    return q_world;
}

Vector3d meanForceAtRest(const MotionEvidence& evidence, size_t board) {
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < evidence.rests.front().count; ++k)
        sum += evidence.forces[board][static_cast<size_t>(k)].mean_m_per_s2;
    return sum;
}

/// Of one board at every node, from its orientation at the first.
std::vector<Quaterniond> carriedOn(const MotionEvidence& evidence, size_t board, Quaterniond q_world_board) {
    std::vector<Quaterniond> orientations{q_world_board};
    for (size_t k = 1; k < static_cast<size_t>(evidence.nodes); ++k) {
        q_world_board = q_world_board * evidence.turns[board][k - 1].q_begin_end;
        const BoardForce& force = evidence.forces[board][k];
        if (force.heard &&
            std::abs(force.mean_m_per_s2.norm() - kStandardGravity_m_per_s2) < kNearG_m_per_s2) {
            const Vector3d lean =
                logQuaternion(smallestRotation(q_world_board * force.mean_m_per_s2, Vector3d::UnitY()));
            q_world_board = expQuaternion(kUprightPerSecond * evidence.step_s * lean) * q_world_board;
        }
        q_world_board.normalize();
        orientations.push_back(q_world_board);
    }
    return orientations;
}

}  // namespace

void appendFirstNodes(const MotionBody& body, const MotionModel& model, const MotionEvidence& evidence,
                      const ExpectedConstants& expected, std::vector<Quaterniond>& q_segment_board,
                      std::vector<MotionNode>& nodes) {
    const std::vector<Quaterniond> q_world_rest = restOrientations(body);
    const bool first_take = q_segment_board.empty();
    const size_t begin = nodes.size();
    MotionNode rest;
    for (const Quaterniond& q : q_world_rest)
        rest.R_world_segment.push_back(q.toRotationMatrix());
    nodes.resize(begin + static_cast<size_t>(evidence.nodes), rest);
    std::vector<bool> carried(static_cast<size_t>(body.size()), false);
    for (size_t b = 0; b < expected.boards.size(); ++b) {
        const auto s = static_cast<size_t>(model.boardSegment(static_cast<int>(b)));
        Quaterniond q_world_board = q_world_rest[s] * expected.boards[b].q_segment_board;
        const Vector3d up_board = meanForceAtRest(evidence, b);
        if (up_board.norm() > 0)
            q_world_board = smallestRotation(q_world_board * up_board, Vector3d::UnitY()) * q_world_board;
        if (first_take)
            q_segment_board.push_back((q_world_rest[s].conjugate() * q_world_board).normalized());
        if (carried[s] || !evidence.isHeard(b))
            continue;
        carried[s] = true;
        const std::vector<Quaterniond> orientations = carriedOn(evidence, b, q_world_board);
        for (size_t k = 0; k < orientations.size(); ++k)
            nodes[begin + k].R_world_segment[s] =
                (orientations[k] * q_segment_board[b].conjugate()).normalized().toRotationMatrix();
    }
    for (size_t s = 0; s < carried.size(); ++s)  // segments without a board go with their parents
        if (const int parent = body.segment(static_cast<int>(s)).parent; !carried[s] && parent >= 0)
            for (size_t k = begin; k < nodes.size(); ++k)
                nodes[k].R_world_segment[s] =
                    nodes[k].R_world_segment[static_cast<size_t>(parent)] *
                    body.segment(static_cast<int>(s)).q_parent_rest.toRotationMatrix();
}

}  // namespace noctule
