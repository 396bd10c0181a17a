// SPDX-License-Identifier: Apache-2.0
// The baseline: Vlasic 2007 to the letter. Euler angles, their velocities and accelerations (equation 1), one
// observation step per sensor type at the frame's own time (equations 2 to 4), distances divided by
// confidence and not gated, biases fixed at the rest pose, the Kalman filter of equations 5 to 9. The root of
// another system is observed at each frame when given.
#pragma once

#include <utility>

#include "core/estimation/covariance.h"
#include "core/estimation/estimator.h"

namespace noctule {

struct PaperParameters {
    SensorSelection sensors;
    bool root_given = false;
    double g_m_per_s2 = kStandardGravity_m_per_s2;
    double process_sigma_rad_per_s2 =
        0.04;  ///< change of acceleration per frame; larger follows faster motion
    double gyro_sigma_rad_per_s = 0.002, accel_sigma_m_per_s2 = 0.02, distance_sigma_m = 0.0025;
    double initial_pose_rad = 0.035, initial_rate_rad_per_s = 0.05, initial_accel_rad_per_s2 = 0.5;
};

class PaperFilter : public Estimator {
public:
    /// `suit` mounted on the tree of BallCoordinates::kEuler; `start_suit` on that of kManifold, for the rest
    /// pose.
    PaperFilter(const Skeleton& skeleton, SuitModel suit, SuitModel start_suit,
                const PaperParameters& parameters);

    void start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) override;
    void add(const InertialMeasurement& measurement) override {
        inertial_.add(measurement.time_s, {measurement.board, measurement.time_s, measurement.gyro.inRange(),
                                           measurement.accel.inRange()});
    }
    void add(const DistanceMeasurement& measurement) override {
        distances_.add(measurement.arrival_s, measurement);
    }
    void add(const RootMeasurement& measurement) override { roots_.add(measurement.time_s, measurement); }
    void advanceTo(double time_s) override;
    std::vector<TimedPose> takePoses() override { return std::exchange(poses_, {}); }
    std::vector<DistanceDecision> takeDecisions() override { return std::exchange(decisions_, {}); }
    int resets() const override { return 0; }

private:
    void frame();
    void predict();
    void updateTriads(const std::vector<InertialMeasurement>& readings, bool gyro);
    void updateDistances(const std::vector<DistanceMeasurement>& measurements);
    void updateRoot(const std::vector<RootMeasurement>& measurements);
    void correct(const Eigen::VectorXd& delta);
    void emitPose();

    PaperParameters parameters_;
    Skeleton skeleton_;
    KinematicTree tree_;
    SuitModel suit_, start_suit_;
    StateLayout layout_;
    ObservationModel observations_;
    BodyState state_;
    Covariance P_;
    int64_t frame_ = 0;  ///< the state's time is frame_ / 140 s
    TimeQueue<InertialMeasurement> inertial_;
    TimeQueue<DistanceMeasurement> distances_;
    TimeQueue<RootMeasurement> roots_;
    std::vector<TimedPose> poses_;
    std::vector<DistanceDecision> decisions_;
};

}  // namespace noctule
