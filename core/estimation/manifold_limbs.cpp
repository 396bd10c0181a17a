// SPDX-License-Identifier: Apache-2.0
// How the filter finds limbs again that it has lost, most often while a gyroscope was at the end of its
// range.
#include <algorithm>
#include <cmath>

#include "core/estimation/manifold_filter.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

/// No joint turns faster (a pitcher's shoulder: 160).
constexpr double kFastest_rad_per_s = 200, kFast_rad_per_s = 20;
constexpr double kUnknownTurn_rad = 1.5, kLostHinge_rad = 0.5;

/// Some writers leave out the axes that clip.
bool lacksAxes(const TriadReading& reading) {
    return reading.count > 0 && !sensedVector(reading);
}

}  // namespace

/// Per link: the gyroscope that turns with it is at the end of its range.
std::vector<bool> ManifoldFilter::clippedLinks(const std::vector<InertialMeasurement>& measurements) const {
    std::vector<bool> clipped(tree_.links().size(), false);
    for (const InertialMeasurement& measurement : measurements) {
        const int link = suit_.boards[static_cast<size_t>(measurement.board)].link;
        if (link < 0)
            continue;
        // Some writers leave out the axes that clip; a single reading without them is a lost one.
        const bool silent =
            lacksAxes(measurement.gyro) && now_.rangings[static_cast<size_t>(link)].hasBeenSilent(seconds());
        if (measurement.gyro.isClipped() || silent)
            clipped[static_cast<size_t>(tree_.movingLink(link))] = true;
    }
    return clipped;
}

/// What a gyroscope at the end of its range did not see may have been anything a joint does.
void ManifoldFilter::allowForClipping(const std::vector<InertialMeasurement>& measurements) {
    if (measurements.empty())
        return;
    if (!learnsMotion())
        now_.motion_noise.restart();
    if (!parameters_.sensors.gyroscopes)
        return;
    const std::vector<bool> clipped = clippedLinks(measurements);
    for (size_t i = 1; i < clipped.size(); ++i)
        if (clipped[i])
            now_.motion_noise.allowMost(tree_.links()[i]);
    bringBackRunaways();
    holdUnseenRates(clipped);
}

void ManifoldFilter::alignLimbs(const std::vector<InertialMeasurement>& measurements) {
    ChainMotion chain;
    for (const InertialMeasurement& measurement : measurements) {
        const auto b = static_cast<size_t>(measurement.board);
        const MountedBoard& board = suit_.boards[b];
        if (board.link <= 0 || tree_.link(board.link).type != LinkType::kBall)
            continue;
        LimbAlignment& alignment = now_.alignments[b];
        if (measurement.gyro.isClipped() || now_.apart) {
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
            for (LimbRanging& ranging : now_.rangings)
                ranging.forget();
        }
    }
}

/// Which limbs' turns gyroscopes see.
void ManifoldFilter::watchLimbs(const std::vector<InertialMeasurement>& measurements) {
    for (const InertialMeasurement& measurement : measurements) {
        const auto b = static_cast<size_t>(measurement.board);
        const int link = suit_.boards[b].link;
        if (link <= 0 || tree_.link(link).type != LinkType::kBall)
            continue;
        LimbRanging& ranging = now_.rangings[static_cast<size_t>(link)];
        if (measurement.gyro.isClipped())
            ranging.breakOff(seconds());
        else if (const auto rate = sensedVector(measurement.gyro))  // some leave out the axes that clip
            ranging.turnSeen(seconds(), placeBoard(suit_.boards[b], tree_, now_.state.motion, 0).R *
                                            (*rate - now_.state.gyro_bias[b]));
    }
}

/// Both ends of a distance tell of the limbs that wear them.
void ManifoldFilter::noteForLimbs(const DistanceMeasurement& measurement) {
    if (std::ranges::none_of(now_.rangings, &LimbRanging::isSuspected))
        return;
    const double arrival_s = measurement.arrival_s - seconds(),
                 emission_s = measurement.emission_s - seconds();
    const MountedBoard& board = suit_.boards[static_cast<size_t>(measurement.board)];
    const MountedSource& source = suit_.sources[static_cast<size_t>(measurement.source)];
    const Vector3d p_source = observations_.sourceEnd(now_.state, measurement.source, emission_s).p_world_m;
    ChainMotion chain;
    const Vector3d p_mic = observations_.boardEnd(now_.state, measurement.board, arrival_s).p_world_m;
    if (board.link > 0) {
        chain.evaluate(tree_, now_.state.motion, board.link, arrival_s);
        noteEnd(chain, board.link, p_mic, source.link, p_source, measurement);
    }
    if (source.link > 0) {
        chain.evaluate(tree_, now_.state.motion, source.link, emission_s);
        noteEnd(chain, source.link, p_source, board.link, p_mic, measurement);
    }
}

/// For the outermost suspected limb on the way to an end, since what a suspected one carries lies where
/// nobody knows. The other end has to be known.
void ManifoldFilter::noteEnd(const ChainMotion& chain, int link, const Vector3d& p_end_m, int other_link,
                             const Vector3d& p_other_m, const DistanceMeasurement& measurement) {
    const auto isSuspected = [this](int i) { return now_.rangings[static_cast<size_t>(i)].isSuspected(); };
    const std::vector<int>& links = tree_.chain(link);
    size_t k = links.size();
    while (k > 0 && !isSuspected(links[k - 1]))
        --k;
    if (k == 0)
        return;
    const size_t at = k - 1;
    if (other_link >= 0) {
        const std::vector<int>& others = tree_.chain(other_link);
        if (std::ranges::count(others, links[at]) > 0 || std::ranges::any_of(others, isSuspected))
            return;
    }
    const ChainMotion::Frame& limb = chain.frames()[at];
    const bool is_end = at + 1 == links.size();
    const Vector3d p_turning = is_end ? p_end_m : chain.frames()[at + 1].p_m;
    const double sigma_m = measurement.sigma_m / measurement.confidence;
    now_.rangings[static_cast<size_t>(links[at])].add(
        {measurement.arrival_s, measurement.distance_m, sigma_m * sigma_m, p_other_m,
         p_end_m - p_turning + limb.p_m, limb.R_world_link.transpose() * (p_turning - limb.p_m)},
        now_.give.fleshShare());
}

/// By distances, from the trunk outwards; what a limb carries is looked at anew once it has been found.
void ManifoldFilter::searchLimbs() {
    if (now_.apart)
        return;
    ChainMotion chain;
    for (size_t link = 1; link < now_.rangings.size(); ++link) {
        if (!now_.rangings[link].isSuspected())
            continue;
        chain.evaluate(tree_, now_.state.motion, static_cast<int>(link), 0);
        const auto found =
            now_.rangings[link].contradict(seconds(), chain.end().R_world_link,
                                           now_.give.held(tree_, static_cast<int>(link), now_.state.motion));
        if (!found)
            continue;
        turnLimb(static_cast<int>(link), {found->q_believed_limb, found->variance_rad2, found->q_limb_axes});
        for (LimbRanging& other : now_.rangings)
            other.forget();
        return;
    }
}

void ManifoldFilter::turnLimb(int link, const LimbAlignment::Found& found) {
    ++now_.resets;
    loosen(link, kUnknownTurn_rad);
    const Quaterniond q_parent_limb =
        now_.state.motion.q_parent_link[static_cast<size_t>(link)] * found.q_believed_limb;
    LimbTarget target;
    target << q_parent_limb.coeffs(), found.q_limb_axes.coeffs();
    ObservationBlock block = turnOf(link, target, now_.state.motion);
    block.variance = found.variance_rad2;
    observe({block});
    fitErrors();  // it may have turned far, and this step's frame is yet to come
}

/// The limb may have turned alone, where boards tell how the limbs that it carries lie.
void ManifoldFilter::loosen(int link, double sigma_rad) {
    fitErrors();
    std::vector<bool> stays;
    for (const Link& other : tree_.links())
        stays.push_back(!isBlind(other));
    const Eigen::MatrixX3d error =
        sigma_rad * LimbTurns(tree_, now_.state.motion).errorOf(tree_, link, stays);
    const Eigen::Index moving = error.rows();
    now_.P.dense().topLeftCorner(moving, moving) += error * error.transpose();
    if (tape_) {
        Widening widening{Eigen::VectorXd::Zero(layout_.size)};
        widening.variance.head(moving) = error.rowwise().squaredNorm();
        tape_->push_back(std::move(widening));
    }
}

ObservationBlock ManifoldFilter::turnOf(int link, const LimbTarget& target, const MotionState& motion) const {
    const int first = layout_.theta(tree_.link(link).first);
    const Quaterniond q_parent_limb(Eigen::Vector4d(target.head<4>()));
    const Matrix3d to_axes = Quaterniond(Eigen::Vector4d(target.tail<4>())).toRotationMatrix().transpose();
    const Quaterniond& q = motion.q_parent_link[static_cast<size_t>(link)];
    return {{first, first + 1, first + 2},
            to_axes,
            to_axes * logQuaternion(q.conjugate() * q_parent_limb),
            Vector3d::Zero(),
            {ObservationOrigin::Kind::kTurn, link, target}};
}

/// A hinge that stands where none can has been lost.
void ManifoldFilter::beginAnew(int link) {
    ++now_.resets;
    loosen(link, kLostHinge_rad);
}

/// A joint that turns faster than any has been lost while its gyroscope was at the end of its range.
void ManifoldFilter::bringBackRunaways() {
    std::vector<ObservationBlock> blocks;
    for (size_t i = 1; i < tree_.links().size(); ++i) {
        const Link& link = tree_.links()[i];
        if (now_.state.motion.rate.segment(link.first, link.count).norm() < kFastest_rad_per_s)
            continue;
        ++now_.resets;
        for (int k = link.first; k < link.first + link.count; ++k) {
            const double rate = now_.state.motion.rate[k], accel = now_.state.motion.accel[k];
            widen(layout_.rate(k), 1, std::abs(rate));
            widen(layout_.accel(k), 1, std::abs(accel));
            blocks.push_back(pull(layout_.rate(k), -rate, kFast_rad_per_s * kFast_rad_per_s));
            blocks.push_back(
                pull(layout_.accel(k), -accel, std::pow(parameters_.motion_noise.most_rad_per_s2, 2)));
        }
    }
    observe(std::move(blocks));
}

}  // namespace noctule
