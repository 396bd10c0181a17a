// SPDX-License-Identifier: Apache-2.0
#include "core/live/motion_tracker.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/live/estimators.h"

namespace noctule {
namespace {

// For the instant of an arrival only: 2 % of a flight is 60 us, in which nothing moves.
constexpr double kUsualSpeedOfSound_m_per_s = 344;
constexpr std::array kSmootherNames{"none", "lag", "full", "batch"};  // in the order of Smoother
constexpr double kUnstatedSigma_m = 0.0025;                           // Vlasic 2007, section 5.2
// Nobody stands perfectly still: floors of a mean's deviation.
constexpr double kRestGyroSigma_rad_per_s = 0.0005, kRestAccelSigma_m_per_s2 = 0.01;

/// The pose has said which cycle of the carrier it is, or that none can be told: time and distance go with
/// it.
void settle(RangeMeasurement& range, const DistanceDecision::Settled& settled) {
    range.arrival_sample += (settled.distance_m - range.distance_m) / range.carrier.m_per_sample;
    range.distance_m = settled.distance_m;
    range.sigma_m = settled.sigma_m;
}

}  // namespace

const char* smootherName(Smoother smoother) {
    return kSmootherNames[static_cast<size_t>(smoother)];
}

std::optional<Smoother> smootherFromName(const std::string& name) {
    for (Smoother smoother : {Smoother::kNone, Smoother::kLag, Smoother::kFull, Smoother::kBatch})
        if (name == smootherName(smoother))
            return smoother;
    return std::nullopt;
}

Result<std::unique_ptr<MotionTracker>> MotionTracker::create(const Suit& suit, const Calibration& calibration,
                                                             const Actor& actor, double sample_rate_hz,
                                                             std::optional<std::pair<int64_t, int64_t>> rest,
                                                             const TrackerSettings& settings) {
    const auto entry = estimatorNamed(settings.estimator);
    if (!entry)
        return entry.error();
    if (Status checked = checkParameters((*entry)->parameters, settings.parameters, settings.estimator);
        !checked)
        return checked.error();
    const KinematicTree manifold_tree(actor.skeleton, BallCoordinates::kManifold);
    auto mounted = mountSuit(suit, calibration, actor, manifold_tree);
    if (!mounted)
        return mounted.error();
    std::unique_ptr<MotionTracker> tracker(new MotionTracker(suit, calibration, actor, sample_rate_hz));
    tracker->uses_distances_ = settings.sensors.distances;
    if (rest) {
        tracker->rest_begin_s_ = static_cast<double>(rest->first) / sample_rate_hz;
        tracker->rest_end_s_ = static_cast<double>(rest->second) / sample_rate_hz;
    }
    const EstimatorWorld world{suit, calibration, actor, *mounted, settings};
    auto estimator = settings.make ? settings.make(world) : (*entry)->make(world);
    if (!estimator)
        return estimator.error();
    tracker->estimator_ = std::move(*estimator);
    return tracker;
}

MotionTracker::MotionTracker(const Suit& suit, const Calibration& calibration, const Actor& actor,
                             double sample_rate_hz)
    : sample_rate_hz_(sample_rate_hz),
      rest_pose_(actor.restPose()),
      calibrator_(suit, calibration, sample_rate_hz),
      rest_sums_(suit.boards.size()) {}

void MotionTracker::add(const InertialReading& reading) {
    const InertialMeasurement measurement = calibrator_.convert(reading);
    if (started_)
        estimator_->add(measurement);
    else if (measurement.time_s > rest_end_s_)
        waiting_inertial_.push_back(measurement);
    else if (measurement.time_s >= rest_begin_s_)
        addToRest(measurement);
}

void MotionTracker::addToRest(const InertialMeasurement& measurement) {
    auto& sums = rest_sums_[static_cast<size_t>(measurement.board)];
    const auto add = [&](const TriadReading& triad, size_t first) {
        for (int i = 0; i < triad.count; ++i) {
            const AxisReading& axis = triad.axes[static_cast<size_t>(i)];
            Eigen::Index which = 0;
            axis.sensitive_axis_board.cwiseAbs().maxCoeff(&which);  // axes are nearly perpendicular
            AxisSum& sum = sums[first + static_cast<size_t>(which)];
            sum.sensitive_axis = axis.sensitive_axis_board;
            sum.sum += axis.value;
            sum.sum_of_squares += axis.value * axis.value;
            ++sum.count;
        }
    };
    add(measurement.gyro.inRange(), 0);
    add(measurement.accel.inRange(), 3);
}

void MotionTracker::add(const RangeMeasurement& range) {
    const double emission_s = static_cast<double>(range.pulse_sample) / sample_rate_hz_;
    if (!uses_distances_ || emission_s < rest_end_s_) {
        judged_.push_back(range);
        return;
    }
    const DistanceMeasurement measurement{next_id_,
                                          range.source,
                                          range.board,
                                          emission_s,
                                          emission_s + range.distance_m / kUsualSpeedOfSound_m_per_s,
                                          range.distance_m,
                                          range.sigma_m > 0 ? range.sigma_m : kUnstatedSigma_m,
                                          range.w_s * range.w_t,
                                          range.carrier};
    pending_[next_id_++] = range;
    if (started_)
        estimator_->add(measurement);
    else
        waiting_distances_.push_back(measurement);
}

void MotionTracker::add(const RootMeasurement& root) {
    if (started_)
        estimator_->add(root);
    else if (root.time_s > rest_end_s_)
        waiting_roots_.push_back(root);
    else
        rest_root_ = root;
}

RestReadings MotionTracker::restReadings() const {
    RestReadings rest{rest_begin_s_, rest_end_s_, {}};
    for (size_t b = 0; b < rest_sums_.size(); ++b) {
        InertialMeasurement mean{static_cast<int>(b), rest_end_s_, {}, {}};
        for (size_t i = 0; i < 6; ++i) {
            const AxisSum& sum = rest_sums_[b][i];
            if (sum.count < 2)
                continue;
            const double n = static_cast<double>(sum.count), value = sum.sum / n;
            const double variance = std::max(0.0, sum.sum_of_squares / n - value * value) / (n - 1);
            const double floor = i < 3 ? kRestGyroSigma_rad_per_s : kRestAccelSigma_m_per_s2;
            (i < 3 ? mean.gyro : mean.accel)
                .add({sum.sensitive_axis, value, std::sqrt(variance + floor * floor)});
        }
        rest.mean_by_board.push_back(mean);
    }
    return rest;
}

void MotionTracker::start() {
    started_ = true;
    if (!rest_root_ && !waiting_roots_.empty())
        rest_root_ = waiting_roots_.front();
    estimator_->start(rest_pose_, restReadings(), rest_root_ ? &*rest_root_ : nullptr);
    for (const auto& measurement : std::exchange(waiting_inertial_, {}))
        estimator_->add(measurement);
    for (const auto& measurement : std::exchange(waiting_distances_, {}))
        estimator_->add(measurement);
    for (const auto& measurement : std::exchange(waiting_roots_, {}))
        estimator_->add(measurement);
}

void MotionTracker::advanceTo(int64_t watermark_sample) {
    const double time_s = static_cast<double>(watermark_sample) / sample_rate_hz_;
    if (!started_ && time_s > rest_end_s_)
        start();
    if (!started_)
        return;
    estimator_->advanceTo(time_s);
    for (const DistanceDecision& decision : estimator_->takeDecisions()) {
        const auto found = pending_.find(decision.id);
        RangeMeasurement range = found->second;
        range.w_a = decision.w_a;
        range.fate = decision.fate;
        range.innovation_m = decision.innovation_m;
        if (decision.settled)
            settle(range, *decision.settled);
        judged_.push_back(range);
        pending_.erase(found);
    }
}

std::vector<TimedPose> MotionTracker::takePoses() {
    return estimator_->takePoses();
}

std::vector<RangeMeasurement> MotionTracker::takeRanges() {
    return std::exchange(judged_, {});
}

}  // namespace noctule
