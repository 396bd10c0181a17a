// SPDX-License-Identifier: Apache-2.0
// How the filter uses what boards felt over whole windows, where they ride on flesh.
#include <algorithm>

#include "core/estimation/manifold_filter.h"

namespace noctule {

void ManifoldFilter::updateVelocityGains(const std::vector<InertialMeasurement>& measurements) {
    for (const InertialMeasurement& measurement : measurements) {
        const auto b = static_cast<size_t>(measurement.board);
        if (measurement.gyro.isClipped() || measurement.accel.isClipped())
            now_.gains[b].breakOff();
        const auto rate = sensedVector(measurement.gyro), force = sensedVector(measurement.accel);
        if (rate && force)
            now_.gains[b].add(seconds(), *rate - now_.state.gyro_bias[b], *force);
    }
    if (now_.step_index % (parameters_.steps_per_frame * parameters_.velocity_gain.frames) != 0)
        return;
    std::vector<ObservationBlock> blocks;
    const int reference = referenceOfGains();
    const bool reference_lasted =
        reference >= 0 && now_.gains[static_cast<size_t>(reference)].window(seconds());
    for (int b = 0; b < std::ssize(suit_.boards) && (!isFree() || reference_lasted); ++b)
        if (b != reference)
            if (ObservationBlock block = observeGainOf(b, reference); block.rows() > 0)
                blocks.push_back(std::move(block));
    observe(std::move(blocks));

    ChainMotion chain;
    for (size_t b = 0; b < suit_.boards.size(); ++b) {
        if (!knowsVelocityOf(suit_.boards[b]))
            continue;
        chain.evaluate(tree_, now_.state.motion, suit_.boards[b].link, 0);
        now_.gains[b].open(velocitiesOf(chain, placeBoard(suit_.boards[b], tree_, now_.state.motion, 0).p_m));
    }
}

/// Against the root's: every joint on the way turns as a gyroscope says.
bool ManifoldFilter::knowsVelocityOf(const MountedBoard& board) const {
    if (board.link < 0)
        return false;
    const std::vector<int>& chain = tree_.chain(board.link);
    return std::none_of(chain.begin(), chain.end(), [this](int index) {
        const Link& link = tree_.link(index);
        return link.count > 0 && isBlind(link) && !(index == 0 && parameters_.root_given);
    });
}

/// Where nobody knows how fast the root goes, boards are compared with one on it; -1: none.
int ManifoldFilter::referenceOfGains() const {
    const auto on_root = [](const MountedBoard& board) { return board.link == 0; };
    const auto found = std::find_if(suit_.boards.begin(), suit_.boards.end(), on_root);
    return isFree() && found != suit_.boards.end() ? static_cast<int>(found - suit_.boards.begin()) : -1;
}

ObservationBlock ManifoldFilter::observeGainOf(int board, int reference) {
    const VelocityGain& gain = now_.gains[static_cast<size_t>(board)];
    const auto window = gain.window(seconds());
    const double share = now_.give.fleshShare();
    if (!window || share < parameters_.velocity_gain.least_flesh_share)
        return {};
    Eigen::VectorXd target = window->packed();
    double variance = gain.variance_m2_per_s2();
    if (reference >= 0) {
        const VelocityGain& other = now_.gains[static_cast<size_t>(reference)];
        const Eigen::VectorXd of_reference = other.window(seconds())->packed();
        target.conservativeResize(target.size() + of_reference.size());
        target.tail(of_reference.size()) = of_reference;
        variance += other.variance_m2_per_s2();
    }
    ObservationBlock block = gainOf(board, target, now_.state);
    block.variance.setConstant(variance / (share * share));
    limitPull(block, now_.P.innovationVariance(block), parameters_.velocity_gain.huber_sigma);
    return block;
}

ObservationBlock ManifoldFilter::gainOf(int board, const Eigen::VectorXd& target,
                                        const BodyState& state) const {
    const auto observed = [&](int index, const VelocityWindow& window) {
        const MountedBoard& mounted = suit_.boards[static_cast<size_t>(index)];
        ChainMotion chain;
        chain.evaluate(tree_, state.motion, mounted.link, 0);
        return observeGain(window, chain, placeBoard(mounted, tree_, state.motion, 0),
                           state.accel_bias[static_cast<size_t>(index)],
                           layout_.accel_bias < 0 ? -1 : layout_.accel_bias + 3 * index, layout_,
                           parameters_.g_m_per_s2);
    };
    const auto [own, rest] = VelocityWindow::unpacked(target);
    ObservationBlock block = observed(board, own);
    if (rest.size() > 0) {
        block = lessTheOther(std::move(block),
                             observed(referenceOfGains(), VelocityWindow::unpacked(rest).first));
        leaveHeadingUntold(block, layout_, state.motion);
    }
    block.origin = {ObservationOrigin::Kind::kGain, board, target};
    return block;
}

}  // namespace noctule
