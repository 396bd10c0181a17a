// SPDX-License-Identifier: Apache-2.0
// What every estimator of the body's motion is: measurements in, poses out, live and offline alike. Time
// advances by the data alone: advanceTo(t) promises that everything with an instant up to t has been given,
// and processes it; so the result does not depend on how the data arrived.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "core/estimation/measurement.h"
#include "core/job/job.h"
#include "core/motion/foot_contacts.h"
#include "core/motion/timed_poses.h"

namespace noctule {

class Estimator {
public:
    virtual ~Estimator() = default;

    /// Starts from the pose the performer was asked to hold. Frames up to `rest.end_s` come out as that pose,
    /// refined by the mean readings. `root`: as another system saw it at rest.end_s, or null.
    virtual void start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) = 0;

    virtual void add(const InertialMeasurement& measurement) = 0;
    virtual void add(const DistanceMeasurement& measurement) = 0;
    virtual void add(const RootMeasurement& measurement) = 0;
    virtual void advanceTo(double time_s) = 0;
    /// Before the last advanceTo(): nothing more will be added, so nothing may wait for it.
    virtual void end() {}

    /// Poses (140 a second) and decisions on distances since the last call.
    virtual std::vector<TimedPose> takePoses() = 0;
    virtual std::vector<DistanceDecision> takeDecisions() = 0;
    /// When each foot stood, to the time reached; what stands there may still grow.
    virtual std::vector<FootContacts> contacts() const { return {}; }
    /// How often the estimator noticed that it had diverged and began anew from a wide covariance.
    virtual int resets() const = 0;

    /// Poses that had to wait for the end of the data come out in portions after the last advanceTo(), each
    /// in order of time but the last portion of the take perhaps first.
    virtual int portionsLeft() const { return 0; }
    /// Works out the next portion; kCancelled, or kDisk when what was put aside cannot be read back.
    virtual Status finishPortion(const JobContext&) { return Done{}; }
};

/// A queue of measurements ordered by time; those of equal time keep the order in which they came.
template <class Measurement>
class TimeQueue {
public:
    void add(double time_s, const Measurement& measurement) {
        auto at = entries_.end();
        while (at != entries_.begin() && std::prev(at)->time_s > time_s)
            --at;
        entries_.insert(at, {time_s, measurement});
    }
    /// Removes and returns all with time <= limit_s.
    std::vector<Measurement> takeUpTo(double limit_s) {
        std::vector<Measurement> taken;
        while (!entries_.empty() && entries_.front().time_s <= limit_s) {
            taken.push_back(entries_.front().measurement);
            entries_.pop_front();
        }
        return taken;
    }

private:
    struct Entry {
        double time_s;
        Measurement measurement;
    };
    std::deque<Entry> entries_;
};

}  // namespace noctule
