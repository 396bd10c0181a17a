// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/manifold_filter.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/carrier_cycle.h"
#include "core/estimation/censoring.h"
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
    const auto reserve = [&](bool wanted, int count) {
        wanted = wanted && p.estimates_constants;
        const int first = wanted ? next : -1;
        next += wanted ? count : 0;
        return first;
    };
    // A bias that nothing observes only hurts: none without the sensor it belongs to.
    layout.gyro_bias = reserve(p.sensors.gyroscopes, 3 * boards);
    layout.accel_bias = reserve(p.sensors.accelerometers, 3 * boards);
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

/// Per joint: whether a gyroscope turns with it, on its segment or farther out.
std::vector<bool> turningJoints(const Skeleton& skeleton, std::vector<bool> with_gyroscope) {
    for (int j = skeleton.size() - 1; j > 0; --j)
        if (const int parent = skeleton.joint(j).parent;
            parent >= 0 && with_gyroscope[static_cast<size_t>(j)])
            with_gyroscope[static_cast<size_t>(parent)] = true;
    return with_gyroscope;
}

/// Per joint: nothing tells how much a joint gives unless the segments on both its sides carry a gyroscope.
std::vector<bool> seenJoints(const Skeleton& skeleton, const std::vector<bool>& with_gyroscope) {
    std::vector<bool> seen = with_gyroscope;
    for (int j = 0; j < skeleton.size(); ++j) {
        int above = skeleton.joint(j).parent;
        while (above >= 0 && skeleton.joint(above).type == JointType::kFixed)
            above = skeleton.joint(above).parent;
        if (above < 0 || !with_gyroscope[static_cast<size_t>(above)])
            seen[static_cast<size_t>(j)] = false;
    }
    return seen;
}

SuitModel moved(SuitModel suit, const KinematicTree& from, const KinematicTree& to) {
    const auto move = [&](int& link) { link = link < 0 ? link : to.linkOfJoint(from.link(link).joint); };
    for (MountedBoard& board : suit.boards)
        move(board.link);
    for (MountedSource& source : suit.sources)
        move(source.link);
    return suit;
}

std::vector<double> boardRates(const SuitModel& suit) {
    std::vector<double> rates_hz;
    for (const MountedBoard& board : suit.boards)
        rates_hz.push_back(board.rate_hz);
    return rates_hz;
}

int64_t nanoseconds(double time_s) {
    return std::llround(time_s * 1e9);
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
      turning_joints_(turningJoints(skeleton, gyroscope_joints_)),
      tree_(parameters.joints_give ? givingSkeleton(skeleton, turning_joints_) : skeleton,
            BallCoordinates::kManifold),
      suit_(moved(std::move(suit), KinematicTree(skeleton, BallCoordinates::kManifold), tree_)),
      mounting_rad2_(mountingCovariances(suit_, tree_, parameters.unstated_mounting_rad)),
      layout_(makeLayout(tree_.freedoms(), suit_, parameters_)),
      observations_(tree_, suit_, layout_, parameters_.g_m_per_s2),
      step_s_(1.0 / (kInertialFramesPerSecond * parameters_.steps_per_frame)),
      inertial_(boardRates(suit_)) {
    const int n = tree_.freedoms();
    acceleration_decay_ = Eigen::VectorXd::Constant(n, std::exp(-step_s_ / parameters_.joint_accel_time_s));
    wander_ = Eigen::VectorXd::Zero(layout_.size);
    for (const auto& [first, walk] : {std::pair(layout_.gyro_bias, parameters_.gyro_bias_walk),
                                      std::pair(layout_.accel_bias, parameters_.accel_bias_walk)})
        if (first >= 0)
            wander_.segment(first, 3 * std::ssize(suit_.boards)).setConstant(walk * walk * step_s_);
    if (parameters_.root_given && !mounting_rad2_.empty())
        mounting_rad2_[0].setZero();  // the root's attitude is not its board's
    if (parameters_.joints_give)
        now_.give = JointGive(skeleton_, tree_, turning_joints_, seenJoints(skeleton_, gyroscope_joints_),
                              parameters_.give);
    now_.heard_s.assign(suit_.boards.size(), 0.0);
    now_.mean_square_rates.assign(tree_.links().size(), 0.0);
    now_.board_noise.assign(suit_.boards.size(), BoardNoise(parameters_.board_noise, suit_.sources.size()));
    now_.gains.assign(suit_.boards.size(), VelocityGain(parameters_.velocity_gain));
    now_.alignments.assign(suit_.boards.size(), LimbAlignment(parameters_.alignment));
    now_.rangings.assign(tree_.links().size(), LimbRanging(parameters_.ranging));
    Eigen::VectorXd variance = Eigen::VectorXd::Constant(n, std::pow(parameters_.joint_accel_rad_per_s2, 2));
    std::vector<bool> adapts;
    for (const Link& link : tree_.links()) {
        adapts.push_back(!isBlind(link));
        if (!turning_joints_[static_cast<size_t>(link.joint)])
            variance.segment(link.first, link.count)
                .setConstant(std::pow(blindness().joint_accel_rad_per_s2, 2));
    }
    if (!tree_.links().empty() && tree_.link(0).type == LinkType::kFree) {
        acceleration_decay_.head<3>().setConstant(std::exp(-step_s_ / parameters_.root_accel_time_s));
        variance.head<3>().setConstant(std::pow(parameters_.root_accel_m_per_s2, 2));
        variance.segment<3>(3).setConstant(std::pow(parameters_.root_turn_accel_rad_per_s2, 2));
    }
    now_.motion_noise =
        MotionNoise(tree_, variance, adapts, parameters_.motion_noise, parameters_.root_given);
}

void ManifoldFilter::add(const InertialMeasurement& measurement) {
    inertial_.add(measurement);
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
    while (isDue(time_s))
        step(nextInput());
}

void ManifoldFilter::step(const StepInput& input) {
    if (input.about) {
        predictAbout(*input.about);
    } else {
        returnToEstimate();
        predict(step_s_);
    }
    ++now_.step_index;
    noteHeard(input.inertial);
    allowForClipping(input.inertial);
    const auto accel_variances = [&] {
        return now_.P.dense().diagonal().segment(layout_.accel(0), layout_.freedoms);
    };
    const Eigen::VectorXd predicted = estimatedAccel(), variances = accel_variances();
    updateRoot(input.roots);
    if (parameters_.sensors.accelerometers)
        updateTriads(input.inertial, false);
    if (parameters_.sensors.gyroscopes)
        updateTriads(input.inertial, true);
    if (!input.inertial.empty() && learnsMotion())
        now_.motion_noise.learn(estimatedAccel() - predicted, variances - accel_variances(),
                                1.0 / kInertialFramesPerSecond, now_.give.fleshShare());
    if (parameters_.sensors.accelerometers && parameters_.sensors.gyroscopes) {
        updateVelocityGains(input.inertial);
        alignLimbs(input.inertial);
    }
    if (parameters_.sensors.gyroscopes)
        watchLimbs(input.inertial);
    updateDistances(input.distances);
    const auto search_steps = std::max<int64_t>(1, std::llround(parameters_.search_interval_s / step_s_));
    if (now_.step_index % search_steps == 0)
        searchLimbs();
    updateGround(input.inertial);
    const auto prior_steps = std::max<int64_t>(1, std::llround(parameters_.prior_interval_s / step_s_));
    if (now_.step_index % prior_steps == 0)
        updatePriors();
    noteSilence();
    if (!isAtFrame())
        return;
    if (tape_)
        tape_->push_back(frame({nanoseconds(seconds())}));
    else
        poses_.push_back(estimateAt(seconds()));
}

void ManifoldFilter::predict(double dt_s) {
    fitHeading();
    LinkTransitions transition =
        predictMotion(tree_, now_.state.motion, now_.P.dense(), dt_s, acceleration_decay_,
                      now_.motion_noise.variance(), shiftOfLimbs());
    if (tape_)
        tape_->push_back(std::move(transition));
    now_.P.dense().diagonal() += wander_;
    now_.fitted = now_.state.motion;
}

void ManifoldFilter::correct(const Eigen::VectorXd& delta) {
    if (now_.apart) {
        *now_.apart += delta;
        return;
    }
    addError(tree_, layout_,
             parameters_.sensors.gyroscopes ? bendTurns(tree_, now_.state.motion, delta) : delta, now_.state);
}

LinkTransitions ManifoldFilter::shiftOfLimbs() const {
    return parameters_.sensors.gyroscopes
               ? limbShift(tree_, LimbTurns(tree_, now_.fitted), LimbTurns(tree_, now_.state.motion))
               : LinkTransitions{tree_.freedoms()};
}

template <class Shift>
void ManifoldFilter::carryErrors(Shift shift) {
    shift.carry(now_.P.dense());
    if (tape_)
        tape_->push_back(std::move(shift));
}

void ManifoldFilter::fitHeading() {
    if (isFree())
        carryErrors(HeadingShift(now_.fitted, now_.state.motion, parameters_.among_others));
}

void ManifoldFilter::fitErrors() {
    carryErrors(shiftOfLimbs());
    fitHeading();
    now_.fitted = now_.state.motion;
}

void ManifoldFilter::updateRoot(const std::vector<RootMeasurement>& measurements) {
    std::vector<ObservationBlock> blocks;
    for (const RootMeasurement& measurement : measurements)
        blocks.push_back(observations_.root(now_.state, measurement, measurement.time_s - seconds()));
    for (size_t i = 0; i < blocks.size(); ++i)
        blocks[i].origin = {ObservationOrigin::Kind::kRoot, static_cast<int>(i), {}};
    observe(std::move(blocks));
}

void ManifoldFilter::updateTriads(const std::vector<InertialMeasurement>& measurements, bool gyro) {
    std::vector<ObservationBlock> blocks;
    for (const InertialMeasurement& measurement : measurements) {
        const double offset_s = measurement.time_s - seconds();
        const int reading = static_cast<int>(&measurement - measurements.data());
        BoardNoise& noise = now_.board_noise[static_cast<size_t>(measurement.board)];
        if (gyro) {
            blocks.push_back(observations_.gyro(now_.state, measurement, offset_s));
            blocks.back().origin = {ObservationOrigin::Kind::kGyro, reading, {}};
            // Flesh under the board turns against a root that another system knows.
            if (blocks.back().rows() > 0 && parameters_.root_given &&
                suit_.boards[static_cast<size_t>(measurement.board)].link == 0)
                noise.adaptGyro(blocks.back(), measurement.gyro, now_.P);
            believeBeyond(blocks.back(), measurement.gyro, parameters_.excess_rad_per_s);
            continue;
        }
        auto [block, motion_m_per_s2] = observations_.accel(now_.state, measurement, offset_s);
        if (block.rows() == 0)
            continue;
        noise.adaptAccel(
            block, measurement.accel, motion_m_per_s2,
            parameters_.sensors.gyroscopes ? now_.give.fleshShare() : parameters_.all_blind_flesh_share,
            now_.P);
        block.origin = {ObservationOrigin::Kind::kAccel, reading, {}};
        believeBeyond(block, measurement.accel, kAnyExcess);
        blocks.push_back(std::move(block));
    }
    std::erase_if(blocks, [](const ObservationBlock& block) { return block.rows() == 0; });
    observe(std::move(blocks));
}

void ManifoldFilter::believeBeyond(ObservationBlock& block, const TriadReading& reading,
                                   double mean_excess) const {
    if (block.rows() > 0 && reading.isClipped())
        censor(block, reading, now_.P.innovationVariance(block), mean_excess);
}

void ManifoldFilter::updateDistances(const std::vector<DistanceMeasurement>& measurements) {
    std::vector<ObservationBlock> blocks;
    const double now_s = seconds();
    for (const DistanceMeasurement& measurement : measurements) {
        DistanceDecision decision{measurement.id, measurement.board, RangeFate::kNoConfidence, 1, 0, 0};
        // Before the first step; or nobody knows where the limbs are, and distances alone would drive them.
        if (measurement.arrival_s < now_s - 0.5 * step_s_ - 1e-9 || (now_.lost && !now_.apart)) {
            decision.fate = RangeFate::kNotTried;
            decisions_.push_back(decision);
            continue;
        }
        auto [block, cos_angle] = observations_.distance(
            now_.state, measurement, measurement.emission_s - now_s, measurement.arrival_s - now_s);
        decision.w_a = cos_angle >= 0 ? 1 : 0;
        DistanceMeasurement known = measurement;
        useCarrier(known, block);
        block.origin = {ObservationOrigin::Kind::kDistance,
                        static_cast<int>(&measurement - measurements.data()),
                        Eigen::VectorXd::Constant(1, known.distance_m)};
        decision.innovation_m = block.residual[0];
        if (decision.w_a == 0)
            decision.fate = RangeFate::kBehindSource;
        else if (measurement.confidence >= kMinimumConfidence) {
            noteForLimbs(known);
            if (judgeDistance(known, block, decision))
                blocks.push_back(std::move(block));
        }
        decisions_.push_back(decision);
    }
    observe(std::move(blocks));
}

/// Gate and Huber's weight, into the block's variance; false when the distance is not to be believed.
bool ManifoldFilter::judgeDistance(const DistanceMeasurement& known, ObservationBlock& block,
                                   DistanceDecision& decision) {
    if (known.carrier.cycle_m != 0)
        decision.settled = {known.distance_m, known.sigma_m};
    const double sigma = known.sigma_m / known.confidence;
    block.variance[0] = sigma * sigma + parameters_.distance_floor_m * parameters_.distance_floor_m;
    BoardNoise& noise = now_.board_noise[static_cast<size_t>(known.board)];
    // Without gyroscopes innovations are those of a coarse model of motion, and no noise.
    decision.sigma_m =
        std::sqrt(parameters_.sensors.gyroscopes ? noise.learnDistance(block, known.source, now_.P)
                                                 : now_.P.innovationVariance(block)[0]);
    const double ratio = std::abs(decision.innovation_m) / decision.sigma_m;
    const bool gated = ratio > parameters_.distance_gate_sigma;
    noteGating(gated);
    decision.fate = gated                                      ? RangeFate::kGated
                    : ratio > parameters_.distance_huber_sigma ? RangeFate::kWeighted
                                                               : RangeFate::kUsed;
    limitPull(block, Eigen::VectorXd::Constant(1, decision.sigma_m * decision.sigma_m),
              parameters_.distance_huber_sigma);
    block.variance[0] += noise.distanceVariance(known.source, now_.give.fleshShare());
    if (known.carrier.cycle_m == 0)
        block.variance[0] += parameters_.echo_pull_m * parameters_.echo_pull_m;
    return !gated;
}

/// The carrier's distance instead of the envelope's, where the pose names its cycle.
void ManifoldFilter::useCarrier(DistanceMeasurement& measurement, ObservationBlock& block) const {
    const CarrierRange& carrier = measurement.carrier;
    if (carrier.cycle_m == 0)
        return;
    const double expected_m = measurement.distance_m - block.residual[0];
    block.variance[0] = carrier.sigma_m * carrier.sigma_m +
                        parameters_.distance_floor_m * parameters_.distance_floor_m +
                        now_.board_noise[static_cast<size_t>(measurement.board)].distanceVariance(
                            measurement.source, now_.give.fleshShare());
    // Without gyroscopes the pose is a coarse model's, surer of itself than it is true: the envelope decides.
    const double expected_variance_m2 = now_.P.innovationVariance(block)[0] +
                                        (parameters_.sensors.gyroscopes ? 0 : kCoarsePose_m * kCoarsePose_m);
    const auto by_carrier_m = carrierDistance(carrier, expected_m, expected_variance_m2);
    measurement.distance_m = by_carrier_m.value_or(carrier.envelope_m);
    measurement.sigma_m = by_carrier_m ? carrier.sigma_m : carrier.envelope_sigma_m;
    block.residual[0] = measurement.distance_m - expected_m;
}

/// A filter that has diverged gates out good data for ever: widen the pose and begin anew.
void ManifoldFilter::noteGating(bool gated) {
    now_.gated_share += ((gated ? 1.0 : 0.0) - now_.gated_share) / kGatingMemory;
    if (now_.gated_share < kDivergedShare)
        return;
    now_.gated_share = 0;
    ++now_.resets;
    widen(0, layout_.freedoms, 0.1);
    widen(layout_.freedoms, layout_.freedoms, 1);
}

void ManifoldFilter::widen(int first, int count, double sigma) {
    Eigen::VectorXd more = Eigen::VectorXd::Zero(layout_.size);
    more.segment(first, count).setConstant(sigma * sigma);
    now_.P.dense().diagonal() += more;
    if (tape_)
        tape_->push_back(Widening{std::move(more)});
}

void ManifoldFilter::updateGround(const std::vector<InertialMeasurement>& measurements) {
    now_.ground.listen(measurements, now_.state);
    if (isFree())
        fitErrors();
    observe(now_.ground.observe(tree_, layout_, now_.state, now_.P, seconds(), contacts_));
}

void ManifoldFilter::observe(std::vector<ObservationBlock> blocks) {
    if (blocks.empty())
        return;
    for (ObservationBlock& block : blocks) {
        if (tape_ && block.origin.kind == ObservationOrigin::Kind::kPull) {
            block.origin.target = block.residual;
            for (Eigen::Index i = 0; i < block.rows(); ++i)
                block.origin.target[i] += valueOf(now_.state, block.columns[static_cast<size_t>(i)]);
        }
        if (now_.apart)
            block.residual -= block.of(*now_.apart);
    }
    if (!tape_)
        return correct(now_.P.update(blocks));
    ObservedUpdate observed;
    correct(now_.P.update(blocks, &observed));
    tape_->push_back(std::move(observed));
}

void ManifoldFilter::conditionJointly(const Eigen::MatrixXd& x, const Eigen::VectorXd& correction) {
    subtractOuterProduct(now_.P.dense(), x);
    correct(correction);
}

void ManifoldFilter::loosenRoot(double place_m, double heading_rad) {
    const Vector3d up_root = now_.state.motion.q_parent_link[0].conjugate() * Vector3d::UnitY();
    Eigen::MatrixXd& P = now_.P.dense();
    P(0, 0) += place_m * place_m;
    P(2, 2) += place_m * place_m;
    P.block<3, 3>(3, 3) += heading_rad * heading_rad * up_root * up_root.transpose();
}

TimedPose ManifoldFilter::estimateAt(double time_s) const {
    return {nanoseconds(time_s), tree_.poseFromState(now_.state.motion),
            jointSigmas(tree_, skeleton_, now_.state.motion, now_.P.dense(), now_.give.meanVariance_rad2(),
                        mounting_rad2_)};
}

}  // namespace noctule
