// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/manifold_filter.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/carrier_cycle.h"
#include "core/estimation/prediction.h"
#include "core/inertial/reading.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

StateLayout makeLayout(int freedoms, const SuitModel& suit, const ManifoldParameters& p) {
    StateLayout layout;
    layout.freedoms = freedoms;
    int next = 3 * freedoms;
    const int boards = static_cast<int>(suit.boards.size());
    const auto reserve = [&next](bool wanted, int count) {
        const int first = wanted ? next : -1;
        next += wanted ? count : 0;
        return first;
    };
    // A bias that nothing observes only hurts: none without the sensor it belongs to.
    layout.gyro_bias = reserve(p.sensors.gyroscopes, 3 * boards);
    layout.accel_bias = reserve(p.sensors.accelerometers && !p.sensors.distances, 3 * boards);
    layout.source_offset = reserve(p.sensors.distances, static_cast<int>(suit.sources.size()));
    layout.sound_scale = reserve(p.sensors.distances, 1);
    layout.size = next;
    return layout;
}

/// Per joint: a gyroscope in use rides on its segment. `links` of boards are those of `tree`.
std::vector<bool> gyroscopeJoints(const Skeleton& skeleton, const KinematicTree& tree, const SuitModel& suit,
                                  const SensorSelection& sensors) {
    std::vector<bool> with(static_cast<size_t>(skeleton.size()), false);
    if (sensors.gyroscopes)
        for (const MountedBoard& board : suit.boards)
            if (board.link >= 0)
                with[static_cast<size_t>(tree.link(board.link).joint)] = true;
    return with;
}

/// Per joint: nothing tells whether a joint gives unless the segments on both its sides carry a gyroscope.
std::vector<bool> givingJoints(const Skeleton& skeleton, const std::vector<bool>& with_gyroscope) {
    std::vector<bool> gives = with_gyroscope;
    for (int j = 0; j < skeleton.size(); ++j) {
        int above = skeleton.joint(j).parent;
        while (above >= 0 && skeleton.joint(above).type == JointType::kFixed)
            above = skeleton.joint(above).parent;
        if (above < 0 || !with_gyroscope[static_cast<size_t>(above)])
            gives[static_cast<size_t>(j)] = false;
    }
    return gives;
}

SuitModel moved(SuitModel suit, const KinematicTree& from, const KinematicTree& to) {
    const auto move = [&](int& link) { link = link < 0 ? link : to.linkOfJoint(from.link(link).joint); };
    for (MountedBoard& board : suit.boards)
        move(board.link);
    for (MountedSource& source : suit.sources)
        move(source.link);
    return suit;
}

/// The link that carries this one about: itself unless its joint is rigid.
const Link& movingLink(const KinematicTree& tree, int link) {
    while (tree.link(link).count == 0 && tree.link(link).parent >= 0)
        link = tree.link(link).parent;
    return tree.link(link);
}

constexpr double kMinimumConfidence = 0.05;
constexpr double kDivergedShare = 0.7;  // of distances gated out, running over about kGatingMemory of them
constexpr double kGatingMemory = 60;
constexpr double kCoarsePose_m = 0.05;

}  // namespace

ManifoldFilter::ManifoldFilter(const Skeleton& skeleton, SuitModel suit, const ManifoldParameters& parameters)
    : parameters_(parameters),
      skeleton_(skeleton),
      gyroscope_joints_(gyroscopeJoints(skeleton, KinematicTree(skeleton, BallCoordinates::kManifold), suit,
                                        parameters.sensors)),
      tree_(parameters.joints_give ? givingSkeleton(skeleton, givingJoints(skeleton, gyroscope_joints_))
                                   : skeleton,
            BallCoordinates::kManifold),
      suit_(moved(std::move(suit), KinematicTree(skeleton, BallCoordinates::kManifold), tree_)),
      layout_(makeLayout(tree_.freedoms(), suit_, parameters_)),
      observations_(tree_, suit_, layout_, parameters_.g_m_per_s2),
      step_s_(1.0 / (kInertialFramesPerSecond * parameters_.steps_per_frame)) {
    const int n = tree_.freedoms();
    acceleration_decay_ = Eigen::VectorXd::Constant(n, std::exp(-step_s_ / parameters_.joint_accel_time_s));
    acceleration_variance_ = Eigen::VectorXd::Constant(n, std::pow(parameters_.joint_accel_rad_per_s2, 2));
    if (parameters_.joints_give)
        give_ = JointGive(skeleton_, tree_, givingJoints(skeleton_, gyroscope_joints_), parameters_.give);
    board_noise_.assign(suit_.boards.size(), BoardNoise(parameters_.board_noise, suit_.sources.size()));
    for (const Link& link : tree_.links())
        if (isBlind(link))
            acceleration_variance_.segment(link.first, link.count)
                .setConstant(std::pow(parameters_.blind.joint_accel_rad_per_s2, 2));
    if (!tree_.links().empty() && tree_.link(0).type == LinkType::kFree) {
        acceleration_decay_.head<3>().setConstant(std::exp(-step_s_ / parameters_.root_accel_time_s));
        acceleration_variance_.head<3>().setConstant(std::pow(parameters_.root_accel_m_per_s2, 2));
        acceleration_variance_.segment<3>(3).setConstant(std::pow(parameters_.root_turn_accel_rad_per_s2, 2));
    }
}

void ManifoldFilter::add(const InertialMeasurement& measurement) {
    inertial_.add(measurement.time_s, measurement);
}

void ManifoldFilter::add(const DistanceMeasurement& measurement) {
    if (parameters_.sensors.distances)
        distances_.add(measurement.arrival_s, measurement);
}

void ManifoldFilter::add(const RootMeasurement& measurement) {
    if (parameters_.root_given)
        roots_.add(measurement.time_s, measurement);
}

void ManifoldFilter::advanceTo(double time_s) {
    while ((static_cast<double>(step_index_) + 1.5) * step_s_ <= time_s)
        step();
}

void ManifoldFilter::step() {
    predict(step_s_);
    ++step_index_;
    const double limit_s = (static_cast<double>(step_index_) + 0.5) * step_s_;
    const double begin_s = limit_s - step_s_;
    current_ = inertial_.takeUpTo(limit_s);
    std::erase_if(current_, [&](const InertialMeasurement& m) { return m.time_s < begin_s - 1e-9; });
    allowForClipping();
    updateRoot(limit_s);
    if (parameters_.sensors.accelerometers)
        updateTriads(false);
    if (parameters_.sensors.gyroscopes)
        updateTriads(true);
    updateDistances(limit_s);
    const auto prior_steps = std::max<int64_t>(1, std::llround(parameters_.prior_interval_s / step_s_));
    if (step_index_ % prior_steps == 0)
        updatePriors();
    if (step_index_ % parameters_.steps_per_frame == 0)
        poses_.push_back(estimateAt(static_cast<double>(step_index_) * step_s_));
}

/// What a gyroscope at the end of its range did not see may have been anything.
void ManifoldFilter::allowForClipping() {
    for (const InertialMeasurement& measurement : current_) {
        const int board_link = suit_.boards[static_cast<size_t>(measurement.board)].link;
        if (board_link <= 0 || measurement.gyro.count == 0 || !parameters_.sensors.gyroscopes)
            continue;
        const bool clipped = measurement.gyro.count < 3 || measurement.gyro.isClipped();
        const Link& link = movingLink(tree_, board_link);
        if (link.type == LinkType::kFree)
            continue;
        acceleration_variance_.segment(link.first, link.count)
            .setConstant(
                std::pow(parameters_.joint_accel_rad_per_s2 * (clipped ? parameters_.clipped_factor : 1), 2));
    }
}

void ManifoldFilter::predict(double dt_s) {
    predictMotion(tree_, state_.motion, P_.dense(), dt_s, acceleration_decay_, acceleration_variance_);
    const auto wander = [&](int first, size_t count, double walk) {
        if (first >= 0)
            P_.dense().diagonal().segment(first, static_cast<Eigen::Index>(count)).array() +=
                walk * walk * dt_s;
    };
    wander(layout_.gyro_bias, 3 * suit_.boards.size(), parameters_.gyro_bias_walk);
    wander(layout_.accel_bias, 3 * suit_.boards.size(), parameters_.accel_bias_walk);
}

void ManifoldFilter::updateRoot(double limit_s) {
    std::vector<ObservationBlock> blocks;
    for (const RootMeasurement& measurement : roots_.takeUpTo(limit_s))
        if (measurement.time_s >= limit_s - step_s_ - 1e-9)
            blocks.push_back(observations_.root(
                state_, measurement, measurement.time_s - static_cast<double>(step_index_) * step_s_));
    correct(P_.update(blocks));
}

void ManifoldFilter::updateTriads(bool gyro) {
    std::vector<ObservationBlock> blocks;
    for (const InertialMeasurement& measurement : current_) {
        const double offset_s = measurement.time_s - static_cast<double>(step_index_) * step_s_;
        const int link = suit_.boards[static_cast<size_t>(measurement.board)].link;
        BoardNoise& noise = board_noise_[static_cast<size_t>(measurement.board)];
        if (gyro) {
            blocks.push_back(observations_.gyro(state_, measurement, offset_s));
            // Flesh under the board turns against a root that another system knows.
            if (blocks.back().rows() > 0 && parameters_.root_given && link == 0)
                noise.adaptGyro(blocks.back(), measurement.gyro, P_);
            continue;
        }
        auto [block, motion_m_per_s2] = observations_.accel(state_, measurement, offset_s);
        if (block.rows() == 0)
            continue;
        if (!parameters_.sensors.gyroscopes)
            block.variance.array() += std::pow(parameters_.blind.accel_floor_m_per_s2, 2);
        else if (link > 0 && noise.isLost(measurement, block, parameters_.g_m_per_s2))
            beginAnew(movingLink(tree_, link));
        noise.adaptAccel(block, measurement.accel, motion_m_per_s2, give_.fleshShare(), P_);
        blocks.push_back(std::move(block));
    }
    std::erase_if(blocks, [](const ObservationBlock& block) { return block.rows() == 0; });
    correct(P_.update(blocks));
}

void ManifoldFilter::updateDistances(double limit_s) {
    std::vector<ObservationBlock> blocks;
    const double now_s = static_cast<double>(step_index_) * step_s_;
    for (const DistanceMeasurement& measurement : distances_.takeUpTo(limit_s)) {
        DistanceDecision decision{measurement.id, measurement.board, RangeFate::kNoConfidence, 1, 0, 0};
        if (measurement.arrival_s < limit_s - step_s_ - 1e-9) {  // before the first step
            decision.fate = RangeFate::kNotTried;
            decisions_.push_back(decision);
            continue;
        }
        auto [block, cos_angle] = observations_.distance(state_, measurement, measurement.emission_s - now_s,
                                                         measurement.arrival_s - now_s);
        decision.w_a = cos_angle >= 0 ? 1 : 0;
        DistanceMeasurement known = measurement;
        useCarrier(known, block, decision);
        decision.innovation_m = block.residual[0];
        if (decision.w_a == 0) {
            decision.fate = RangeFate::kBehindSource;
        } else if (measurement.confidence >= kMinimumConfidence) {
            const double sigma = known.sigma_m / measurement.confidence;
            block.variance[0] = sigma * sigma + parameters_.distance_floor_m * parameters_.distance_floor_m;
            BoardNoise& noise = board_noise_[static_cast<size_t>(measurement.board)];
            // Without gyroscopes innovations are those of a coarse model of motion, and no noise.
            decision.sigma_m =
                std::sqrt(parameters_.sensors.gyroscopes ? noise.learnDistance(block, measurement.source, P_)
                                                         : P_.innovationVariance(block)[0]);
            const double ratio = std::abs(decision.innovation_m) / decision.sigma_m;
            const bool gated = ratio > parameters_.distance_gate_sigma;
            noteGating(gated);
            decision.fate = gated                                      ? RangeFate::kGated
                            : ratio > parameters_.distance_huber_sigma ? RangeFate::kWeighted
                                                                       : RangeFate::kUsed;
            if (!gated) {
                // Huber: beyond the threshold the pull grows no further.
                const double excess = std::max(0.0, ratio / parameters_.distance_huber_sigma - 1);
                block.variance[0] += noise.distanceVariance() + excess * decision.sigma_m * decision.sigma_m;
                blocks.push_back(std::move(block));
            }
        }
        decisions_.push_back(decision);
    }
    correct(P_.update(blocks));
}

/// The carrier's distance instead of the envelope's, where the pose names its cycle.
void ManifoldFilter::useCarrier(DistanceMeasurement& measurement, ObservationBlock& block,
                                DistanceDecision& decision) {
    const CarrierRange& carrier = measurement.carrier;
    if (carrier.cycle_m == 0)
        return;
    const double expected_m = measurement.distance_m - block.residual[0];
    block.variance[0] = carrier.sigma_m * carrier.sigma_m +
                        parameters_.distance_floor_m * parameters_.distance_floor_m +
                        board_noise_[static_cast<size_t>(measurement.board)].distanceVariance();
    // Without gyroscopes the pose is a coarse model's, surer of itself than it is true: the envelope decides.
    const double expected_variance_m2 = P_.innovationVariance(block)[0] +
                                        (parameters_.sensors.gyroscopes ? 0 : kCoarsePose_m * kCoarsePose_m);
    decision.distance_m = carrierDistance(carrier, expected_m, expected_variance_m2);
    measurement.distance_m = decision.distance_m.value_or(carrier.envelope_m);
    measurement.sigma_m = decision.distance_m ? carrier.sigma_m : carrier.envelope_sigma_m;
    block.residual[0] = measurement.distance_m - expected_m;
}

/// A filter that has diverged gates out good data for ever: widen the pose and begin anew.
void ManifoldFilter::noteGating(bool gated) {
    gated_share_ += ((gated ? 1.0 : 0.0) - gated_share_) / kGatingMemory;
    if (gated_share_ < kDivergedShare)
        return;
    gated_share_ = 0;
    ++resets_;
    P_.dense().diagonal().head(layout_.freedoms).array() += 0.1 * 0.1;
    P_.dense().diagonal().segment(layout_.freedoms, layout_.freedoms).array() += 1.0;
}

/// One limb has been lost, most often while its gyroscope was at the end of its range.
void ManifoldFilter::beginAnew(const Link& link) {
    ++resets_;
    P_.dense().diagonal().segment(link.first, link.count).tail(std::min(link.count, 3)).array() += 0.5 * 0.5;
}

void ManifoldFilter::updatePriors() {
    std::vector<ObservationBlock> blocks = give_.observe(state_.motion, P_, parameters_.prior_interval_s);
    const auto pull = [&](int index, double residual, double sigma) {
        blocks.push_back({{index},
                          Eigen::MatrixXd::Ones(1, 1),
                          Eigen::VectorXd::Constant(1, residual),
                          Eigen::VectorXd::Constant(1, sigma * sigma)});
    };
    const bool free_root = tree_.link(0).type == LinkType::kFree && !parameters_.root_given;
    if (free_root)
        for (int i = 0; i < 3; ++i)
            pull(layout_.rate(i), -state_.motion.rate[i], parameters_.root_velocity_prior_m_per_s);
    for (size_t i = 0; i < tree_.links().size(); ++i) {
        const Link& link = tree_.links()[i];
        if (!isBlind(link) || (i == 0 && parameters_.root_given))
            continue;
        const int rotation = link.type == LinkType::kFree ? 3 : 0;
        const Vector3d away =
            logQuaternion(rest_.q_parent_link[i].conjugate() * state_.motion.q_parent_link[i]);
        for (int k = rotation; k < link.count; ++k) {
            const int index = link.first + k;
            const double angle = link.type == LinkType::kHinge
                                     ? state_.motion.angle_rad[i] - rest_.angle_rad[i]
                                     : away[k - rotation];
            if (i > 0)
                pull(layout_.theta(index), -angle, parameters_.blind.pose_prior_rad);
            pull(layout_.rate(index), -state_.motion.rate[index], parameters_.blind.rate_prior_rad_per_s);
        }
    }
    correct(P_.update(blocks));
}

void ManifoldFilter::correct(const Eigen::VectorXd& delta) {
    const int n = layout_.freedoms;
    tree_.retract(state_.motion, delta.head(n));
    state_.motion.rate += delta.segment(n, n);
    state_.motion.accel += delta.segment(2 * n, n);
    for (size_t b = 0; b < suit_.boards.size(); ++b) {
        if (layout_.gyro_bias >= 0)
            state_.gyro_bias[b] += delta.segment<3>(layout_.gyro_bias + 3 * static_cast<int>(b));
        if (layout_.accel_bias >= 0)
            state_.accel_bias[b] += delta.segment<3>(layout_.accel_bias + 3 * static_cast<int>(b));
    }
    if (layout_.source_offset >= 0)
        for (size_t s = 0; s < suit_.sources.size(); ++s)
            state_.source_offset_m[s] += delta[layout_.source_offset + static_cast<int>(s)];
    if (layout_.sound_scale >= 0)
        state_.sound_scale += delta[layout_.sound_scale];
}

TimedPose ManifoldFilter::estimateAt(double time_s) const {
    return {std::llround(time_s * 1e9), tree_.poseFromState(state_.motion),
            jointSigmas(tree_, skeleton_, state_.motion, P_.dense(), give_.meanVariance_rad2())};
}

}  // namespace noctule
