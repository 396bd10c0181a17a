// SPDX-License-Identifier: Apache-2.0
// The body's joint angles from its segments' attitudes, one instant after the other: weighted least squares
// over all joints at once, so that what a joint cannot do corrects the headings, which are the least known.
// Segments without a sensor keep to the usual pose of their joint.
#pragma once

#include "core/body/actor.h"
#include "core/body/kinematics.h"

namespace noctule::posing {

/// One sensor's word on its segment.
struct SegmentAttitude {
    int joint = 0;
    Quaterniond q_world_segment = Quaterniond::Identity();
    double heading_sigma_rad = 0.1;
    double weight = 1;  ///< 0..1: a sensor that comes or leaves
};

/// Standard deviations.
struct PoseFitSettings {
    double tilt_rad = 0.03;      ///< inclination of a segment: mounting and soft tissue
    double heading_rad = 0.09;   ///< likewise its heading, beside what the sensor's is known to
    double step_rad_per_s = 15;  ///< a joint may turn so fast; smaller: smoother and later
    double usual_rad = 0.5;      ///< of a joint for which no usual pose is learned
    double upright_rad = 0.3;    ///< of a root without a sensor
};

struct FittedPose {
    Pose pose;  ///< the root's place is that of the pose before
    std::vector<double> sigma_rad;
};

class PoseFit {
public:
    PoseFit(const Skeleton& skeleton, const Pose& start, const PoseFitSettings& settings);

    FittedPose next(const std::vector<SegmentAttitude>& attitudes, double dt_s);

private:
    struct System;
    std::vector<Quaterniond> worldTurns() const;
    void addAttitudes(const std::vector<SegmentAttitude>& attitudes, System& system) const;
    std::vector<double> untold(const std::vector<SegmentAttitude>& attitudes) const;
    void addUsual(const std::vector<double>& untold, System& system) const;
    void addSteps(const MotionState& before, double dt_s, System& system) const;

    Skeleton skeleton_;
    KinematicTree tree_;
    PoseFitSettings settings_;
    MotionState now_;
    MotionState usual_;
    Eigen::VectorXd usual_sigma_rad_;  ///< per coordinate; infinite: nothing is usual
    bool started_ = false;
};

}  // namespace noctule::posing
