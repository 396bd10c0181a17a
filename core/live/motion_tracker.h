// SPDX-License-Identifier: Apache-2.0
// Readings and ranges of one suit -> poses, as they come: waits out the rest pose, then feeds the estimator.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/acoustics/range.h"
#include "core/body/actor.h"
#include "core/estimation/estimator.h"
#include "core/estimation/ground_contacts.h"
#include "core/estimation/parameter.h"
#include "core/live/inertial_calibrator.h"

namespace noctule {

/// Names in the registry of estimators (estimators.h), on the command line and in takes.
inline constexpr const char* kManifoldEstimator = "manifold";
inline constexpr const char* kPaperEstimator = "paper";
inline constexpr const char* kOrientationEstimator = "orientation";

/// Smoothing. kLag: fixed lag, 0.5 s. kFull: fixed interval. kBatch: relinearised MAP.
enum class Smoother { kNone, kLag, kFull, kBatch };

/// "none", "lag", "full", "batch": as on the command line and in takes.
const char* smootherName(Smoother smoother);
std::optional<Smoother> smootherFromName(const std::string& name);

struct EstimatorWorld;
using MakeEstimator = std::function<Result<std::unique_ptr<Estimator>>(const EstimatorWorld& world)>;

struct TrackerSettings {
    std::string estimator = kManifoldEstimator;
    ParameterValues parameters;  ///< that differ from the estimator's defaults
    SensorSelection sensors;
    bool root_given = false;
    double g_m_per_s2 = kStandardGravity_m_per_s2;
    Smoother smoother = Smoother::kNone;  ///< of "manifold" only
    Ground ground = Ground::kLevel;       ///< of "manifold" only
    /// When each foot stands, instead of what the readings show.
    std::optional<std::vector<FootContacts>> contacts{};
    std::string spool_folder = ".";  ///< kFull and kBatch put aside there what memory should not hold
    /// Makes the estimator instead of the registry: one that is part of an estimate of several bodies.
    MakeEstimator make{};
};

class MotionTracker {
public:
    /// `rest`: first and last sample of the time in which the performer holds the rest pose; none: the motion
    /// is believed to begin in it at sample 0. Fails (kUnusable) when the suit does not fit the actor, and
    /// (kUsage) for an unknown estimator or parameter.
    static Result<std::unique_ptr<MotionTracker>> create(const Suit& suit, const Calibration& calibration,
                                                         const Actor& actor, double sample_rate_hz,
                                                         std::optional<std::pair<int64_t, int64_t>> rest,
                                                         const TrackerSettings& settings);

    void add(const InertialReading& reading);
    void add(const RangeMeasurement& range);
    void add(const RootMeasurement& root);
    /// Everything with an instant before this sample has been added.
    void advanceTo(int64_t watermark_sample);
    /// As that of Estimator.
    void end() { estimator_->end(); }

    std::vector<TimedPose> takePoses();
    /// Ranges as judged: w_a from the pose then believed, fate and innovation. Each comes out once, after its
    /// time has passed; those of the rest pose are not tried.
    std::vector<RangeMeasurement> takeRanges();

    /// As those of Estimator, after the last advanceTo().
    int portionsLeft() const { return estimator_->portionsLeft(); }
    Status finishPortion(const JobContext& job) { return estimator_->finishPortion(job); }

    std::vector<FootContacts> contacts() const { return estimator_->contacts(); }
    const Estimator& estimator() const { return *estimator_; }
    int resets() const { return estimator_->resets(); }
    int64_t clippedReadings(int board) const { return calibrator_.clippedReadings(board); }

private:
    MotionTracker(const Suit& suit, const Calibration& calibration, const Actor& actor,
                  double sample_rate_hz);
    void start();
    void addToRest(const InertialMeasurement& measurement);
    RestReadings restReadings() const;

    double sample_rate_hz_;
    Pose rest_pose_;
    InertialCalibrator calibrator_;
    std::unique_ptr<Estimator> estimator_;
    bool uses_distances_ = true;
    bool started_ = false;
    double rest_begin_s_ = 0, rest_end_s_ = 0;

    /// Sums over the rest pose, per board and axis.
    struct AxisSum {
        Vector3d sensitive_axis = Vector3d::Zero();
        double sum = 0, sum_of_squares = 0;
        int64_t count = 0;
    };
    std::vector<std::array<AxisSum, 6>> rest_sums_;
    std::optional<RootMeasurement> rest_root_;
    std::vector<InertialMeasurement> waiting_inertial_;  ///< after the rest, before the start
    std::vector<DistanceMeasurement> waiting_distances_;
    std::vector<RootMeasurement> waiting_roots_;
    std::map<int64_t, RangeMeasurement> pending_;  ///< by the id given to the estimator
    int64_t next_id_ = 0;
    std::vector<RangeMeasurement> judged_;
};

}  // namespace noctule
