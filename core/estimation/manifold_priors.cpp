// SPDX-License-Identifier: Apache-2.0
// What the filter believes of a body without readings.
#include <algorithm>
#include <cmath>

#include "core/estimation/manifold_filter.h"
#include "core/inertial/reading.h"

namespace noctule {
namespace {

constexpr double kSilent_s = 0.25;  ///< without readings of a board

}  // namespace

/// A gap of the whole link ends board by board and axis by axis. Until most are back, distances alone would
/// drive the limbs.
std::vector<bool> ManifoldFilter::silentLinks() const {
    size_t worn = 0, heard = 0;
    std::vector<bool> has_board(tree_.links().size()), is_heard(tree_.links().size());
    for (size_t board = 0; board < suit_.boards.size(); ++board) {
        if (suit_.boards[board].link < 0)
            continue;  // on nobody, as an anchor's
        const auto link = static_cast<size_t>(suit_.boards[board].link);
        const bool speaks = seconds() - now_.heard_s[board] <= kSilent_s;
        ++worn;
        heard += speaks;
        has_board[link] = true;
        is_heard[link] = is_heard[link] || speaks;
    }
    std::vector<bool> silent(tree_.links().size(), worn > 0 && heard == 0);
    if (heard > 0 && 2 * heard < worn)
        for (size_t link = 0; link < silent.size(); ++link)
            silent[link] = has_board[link] && !is_heard[link];
    return silent;
}

void ManifoldFilter::updatePriors() {
    for (const int link : now_.give.lostLinks(now_.state.motion))
        beginAnew(link);
    std::vector<ObservationBlock> blocks =
        now_.give.observe(now_.state.motion, now_.P, parameters_.prior_interval_s);
    if (isFree()) {
        const Vector3d still = -now_.state.motion.rate.head<3>();
        const double sigma = parameters_.root_velocity_prior_m_per_s;
        blocks.push_back(
            velocityOfRoot(layout_, now_.state.motion, still, Vector3d::Constant(sigma * sigma)));
    }
    if (isSilent()) {
        observe(std::move(blocks));
        return holdInSilence();
    }
    const std::vector<bool> silent = silentLinks();
    const Eigen::VectorXd away = coordinateError(tree_, usual_, now_.state.motion);
    for (size_t i = 0; i < tree_.links().size(); ++i) {
        const Link& link = tree_.links()[i];
        if ((!silent[i] && !isBlind(link)) || (i == 0 && parameters_.root_given))
            continue;
        const int rotation = link.type == LinkType::kFree ? 3 : 0;
        for (int index = link.first + rotation; index < link.first + link.count; ++index) {
            if (i > 0)
                blocks.push_back(pull(layout_.theta(index), -away[index], usual_variance_[index]));
            blocks.push_back(pull(layout_.rate(index), -now_.state.motion.rate[index],
                                  std::pow(blindness().rate_prior_rad_per_s, 2)));
        }
    }
    observe(std::move(blocks));
}

/// Once per frame of readings.
void ManifoldFilter::holdUnseenRates(const std::vector<bool>& clipped_links) {
    const auto& p = parameters_.unseen;
    constexpr double kFrame_s = 1.0 / kInertialFramesPerSecond;
    std::vector<ObservationBlock> blocks;
    for (size_t i = 1; i < tree_.links().size(); ++i) {
        const Link& link = tree_.links()[i];
        if (link.count == 0)
            continue;
        double& usual = now_.mean_square_rates[i];
        const auto rate = now_.state.motion.rate.segment(link.first, link.count);
        if (!clipped_links[i] && !clipped_links[static_cast<size_t>(tree_.movingLink(link.parent))]) {
            usual += kFrame_s / p.memory_s * (rate.squaredNorm() / link.count - usual);
            continue;
        }
        const double variance = std::pow(p.least_rad_per_s, 2) + std::pow(p.times_usual, 2) * usual;
        for (int k = 0; k < link.count; ++k)
            blocks.push_back(pull(layout_.rate(link.first + k), -rate[k], variance * p.alike_s / kFrame_s));
    }
    observe(std::move(blocks));
}

}  // namespace noctule
