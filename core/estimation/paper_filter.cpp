// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/paper_filter.h"

#include <cmath>

#include "core/estimation/censoring.h"
#include "core/estimation/manifold_filter.h"
#include "core/estimation/prediction.h"
#include "core/inertial/reading.h"

namespace noctule {
namespace {

constexpr double kStep_s = 1.0 / kInertialFramesPerSecond;

}  // namespace

PaperFilter::PaperFilter(const Skeleton& skeleton, SuitModel suit, SuitModel start_suit,
                         const PaperParameters& parameters)
    : parameters_(parameters),
      skeleton_(skeleton),
      tree_(skeleton, BallCoordinates::kEuler),
      suit_(std::move(suit)),
      start_suit_(std::move(start_suit)),
      observations_(tree_, suit_, layout_, parameters.g_m_per_s2) {
    for (SuitModel* worn : {&suit_, &start_suit_})  // the paper's boards are rigid on their segments
        for (MountedBoard& board : worn->boards)
            board.flesh.reset();
    layout_.freedoms = tree_.freedoms();
    layout_.size = 3 * tree_.freedoms();
}

/// Section 5.4: the pose is improved so that mean accelerations point up, gyroscope zeros so that mean rates
/// vanish.
void PaperFilter::start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) {
    ManifoldParameters settling;
    settling.initial_pose_rad = parameters_.initial_pose_rad;
    settling.g_m_per_s2 = parameters_.g_m_per_s2;
    ManifoldFilter at_rest(skeleton_, start_suit_, settling);
    at_rest.start(rest_pose, rest, root);
    poses_ = at_rest.takePoses();

    state_.motion = tree_.stateFromPose(at_rest.tree().poseFromState(at_rest.state().motion));
    state_.gyro_bias = at_rest.state().gyro_bias;
    state_.accel_bias.assign(suit_.boards.size(), Vector3d::Zero());
    state_.source_offset_m.assign(suit_.sources.size(), 0.0);
    const Eigen::Index n = tree_.freedoms();
    Eigen::VectorXd variance(3 * n);
    variance << Eigen::VectorXd::Constant(n, std::pow(parameters_.initial_pose_rad, 2)),
        Eigen::VectorXd::Constant(n, std::pow(parameters_.initial_rate_rad_per_s, 2)),
        Eigen::VectorXd::Constant(n, std::pow(parameters_.initial_accel_rad_per_s2, 2));
    P_ = Covariance(variance);
    frame_ = static_cast<int64_t>(std::ceil(rest.end_s / kStep_s - 1e-9));
}

void PaperFilter::advanceTo(double time_s) {
    while (static_cast<double>(frame_ + 1) * kStep_s <= time_s)
        frame();
}

void PaperFilter::frame() {
    predict();
    ++frame_;
    const double now_s = static_cast<double>(frame_) * kStep_s;
    const auto fresh = [&](double time_s) { return time_s > now_s - kStep_s - 1e-9; };
    std::vector<InertialMeasurement> readings = inertial_.takeUpTo(now_s);
    std::vector<DistanceMeasurement> distances = distances_.takeUpTo(now_s);
    std::vector<RootMeasurement> roots = roots_.takeUpTo(now_s);
    std::erase_if(readings, [&](const auto& m) { return !fresh(m.time_s); });
    std::erase_if(distances, [&](const auto& m) {  // before the first frame
        if (!fresh(m.arrival_s))
            decisions_.push_back({m.id, m.board, RangeFate::kNotTried, 1, 0, 0});
        return !fresh(m.arrival_s);
    });
    std::erase_if(roots, [&](const auto& m) { return !fresh(m.time_s); });
    if (parameters_.root_given)
        updateRoot(roots);
    if (parameters_.sensors.accelerometers)
        updateTriads(readings, false);
    if (parameters_.sensors.gyroscopes)
        updateTriads(readings, true);
    if (parameters_.sensors.distances)
        updateDistances(distances);
    emitPose();
}

/// Equations 1, 5 and 6 with time steps in seconds.
void PaperFilter::predict() {
    const Eigen::Index n = tree_.freedoms();
    MotionState& motion = state_.motion;
    tree_.retract(motion, kStep_s * motion.rate);
    motion.rate += kStep_s * motion.accel;
    // A P A^T for A = [I dt 0; 0 I dt; 0 0 I]: rows, then columns.
    Eigen::MatrixXd& P = P_.dense();
    P.topRows(n) += kStep_s * P.middleRows(n, n);
    P.middleRows(n, n) += kStep_s * P.bottomRows(n);
    P.leftCols(n) += kStep_s * P.middleCols(n, n);
    P.middleCols(n, n) += kStep_s * P.rightCols(n);
    P.diagonal().tail(n).array() +=
        parameters_.process_sigma_rad_per_s2 * parameters_.process_sigma_rad_per_s2;
}

void PaperFilter::updateTriads(const std::vector<InertialMeasurement>& readings, bool gyro) {
    const double sigma = gyro ? parameters_.gyro_sigma_rad_per_s : parameters_.accel_sigma_m_per_s2;
    std::vector<ObservationBlock> blocks;
    for (const InertialMeasurement& reading : readings) {
        blocks.push_back(gyro ? observations_.gyro(state_, reading, 0)
                              : observations_.accel(state_, reading, 0).block);
        leaveOutBeyond(blocks.back(), gyro ? reading.gyro : reading.accel);
        blocks.back().variance.setConstant(sigma * sigma);
    }
    correct(P_.update(blocks));
}

void PaperFilter::updateDistances(const std::vector<DistanceMeasurement>& measurements) {
    std::vector<ObservationBlock> blocks;
    for (const DistanceMeasurement& measurement : measurements) {
        DistanceDecision decision{measurement.id, measurement.board, RangeFate::kUsed, 1, 0, 0};
        auto [block, cos_angle] = observations_.distance(state_, measurement, 0, 0);
        decision.w_a = cos_angle >= 0 ? 1 : 0;
        decision.innovation_m = block.residual[0];
        const double confidence = measurement.confidence * decision.w_a;
        if (decision.w_a == 0)
            decision.fate = RangeFate::kBehindSource;
        else if (confidence <= 0)
            decision.fate = RangeFate::kNoConfidence;
        if (confidence > 0) {
            const double sigma = parameters_.distance_sigma_m / confidence;
            block.variance[0] = sigma * sigma;
            decision.sigma_m = std::sqrt(P_.innovationVariance(block)[0]);
            blocks.push_back(std::move(block));
        }
        decisions_.push_back(decision);
    }
    correct(P_.update(blocks));
}

void PaperFilter::updateRoot(const std::vector<RootMeasurement>& measurements) {
    std::vector<ObservationBlock> blocks;
    for (const RootMeasurement& measurement : measurements)
        blocks.push_back(observations_.root(state_, measurement, 0));
    correct(P_.update(blocks));
}

void PaperFilter::correct(const Eigen::VectorXd& delta) {
    const Eigen::Index n = tree_.freedoms();
    tree_.retract(state_.motion, delta.head(n));
    state_.motion.rate += delta.segment(n, n);
    state_.motion.accel += delta.tail(n);
}

void PaperFilter::emitPose() {
    poses_.push_back({std::llround(static_cast<double>(frame_) * kStep_s * 1e9),
                      tree_.poseFromState(state_.motion),
                      jointSigmas(tree_, skeleton_, state_.motion, P_.dense())});
}

}  // namespace noctule
