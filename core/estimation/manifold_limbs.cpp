// SPDX-License-Identifier: Apache-2.0
// How the filter finds limbs again that it has lost, most often while a gyroscope was at the end of its
// range.
#include "core/estimation/manifold_filter.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kUnknownTurn_rad = 1.5, kLostHinge_rad = 0.5;

}  // namespace

void ManifoldFilter::alignLimbs(const std::vector<InertialMeasurement>& measurements) {
    ChainMotion chain;
    for (const InertialMeasurement& measurement : measurements) {
        const auto b = static_cast<size_t>(measurement.board);
        const MountedBoard& board = suit_.boards[b];
        if (board.link <= 0 || tree_.link(board.link).type != LinkType::kBall)
            continue;
        LimbAlignment& alignment = now_.alignments[b];
        if (measurement.gyro.isClipped()) {
            alignment.breakOff(seconds());
            continue;
        }
        const auto rate = sensedVector(measurement.gyro), force = sensedVector(measurement.accel);
        if (!rate || !force)
            continue;
        chain.evaluate(tree_, now_.state.motion, board.link, 0);
        const PlacedBoard placed = placeBoard(board, tree_, now_.state.motion, 0);
        alignment.add({seconds(), placed.R * (*rate - now_.state.gyro_bias[b]),
                       placed.R * (*force - now_.state.accel_bias[b]), placed.p_m},
                      chain.end().a_m_per_s2 + parameters_.g_m_per_s2 * Vector3d::UnitY());
        if (const auto found = alignment.contradict(chain.end().R_world_link)) {
            turnLimb(board.link, *found);
            alignment.breakOff(seconds());
        }
    }
}

void ManifoldFilter::turnLimb(int link, const LimbAlignment::Found& found) {
    ++now_.resets;
    widen(tree_.link(link).first, 3, kUnknownTurn_rad);
    const Quaterniond q_parent_limb =
        now_.state.motion.q_parent_link[static_cast<size_t>(link)] * found.q_believed_limb;
    ObservationBlock block = turnOf(link, q_parent_limb, now_.state.motion);
    block.variance = found.variance_rad2;
    observe({block});
}

ObservationBlock ManifoldFilter::turnOf(int link, const Quaterniond& q_parent_limb,
                                        const MotionState& motion) const {
    const int first = layout_.theta(tree_.link(link).first);
    const Quaterniond& q = motion.q_parent_link[static_cast<size_t>(link)];
    return {{first, first + 1, first + 2},
            Matrix3d::Identity(),
            logQuaternion(q.conjugate() * q_parent_limb),
            Vector3d::Zero(),
            {ObservationOrigin::Kind::kTurn, link, q_parent_limb.coeffs()}};
}

/// A hinge that stands where none can has been lost.
void ManifoldFilter::beginAnew(const Link& link) {
    ++now_.resets;
    const int turning = std::min(link.count, 3);
    widen(link.first + link.count - turning, turning, kLostHinge_rad);
}

}  // namespace noctule
