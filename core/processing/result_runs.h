// SPDX-License-Identifier: Apache-2.0
// The derived runs that one processing adds to a take, whether the pipeline ran on the file or on the suit
// while it was recorded: the same rows either way.
#pragma once

#include <vector>

#include "core/processing/ingredients.h"
#include "core/processing/process_take.h"
#include "core/processing/result_spool.h"
#include "core/processing/take_clocks.h"
#include "core/recording/take_edit.h"

namespace noctule {

/// "AGD": what the estimator is given. Independent inertial sensors know no distances, whatever is asked for.
std::string sensorLetters(const TrackerSettings& tracker);

/// Where results go while the data are still being read: beside the take, which stays free for others until
/// store() writes them.
class ResultRuns : public ResultSink {
public:
    /// Readings do not depend on calibration or estimator: a run of them by the same software serves all, and
    /// those given here are then only counted.
    static Result<ResultRuns> begin(Take& take, const ProcessRequest& request,
                                    const std::vector<Ingredients>& subjects);
    /// What is written from now on is this subject's.
    Status beginSubject(const Ingredients& in);
    /// The microphones of a room: only ranges are written for it.
    Status beginRoom(const TakeSubject& room);
    /// Back to one that was begun, by the order of beginning.
    void goOn(size_t part) { part_ = part; }
    /// Another clock for what is written from now on.
    void useClock(const SuitClock& clock) { parts_[part_].clock = clock; }
    /// Of pulses of other suits.
    void writeCross(const std::vector<RangeMeasurement>& ranges);

    Status write(const std::vector<InertialReading>& readings) override;
    Status write(const std::vector<RangeMeasurement>& ranges) override;
    /// Fails (kUnusable) for a pose that is not finite.
    Status write(const std::vector<TimedPose>& poses) override;
    Status write(const std::vector<FootContacts>& contacts);

    /// All of it as one transaction, with the calibration and the actor of the request in force.
    Status store(Take& take, const ProcessRequest& request, std::vector<Ingredients>& subjects);

    ProcessSummary summary;
    TakeClocks clocks;                                   ///< of the take, where it has several suits
    std::vector<std::pair<int, RelativeRow>> relatives;  ///< with the suit of the first body

private:
    /// What one subject yields; poses and contacts on the take's time.
    struct Part {
        int suit = 0;  ///< counts from 1
        SuitClock clock;
        ResultSpool spool;
        std::vector<FootContacts> contacts;
    };
    explicit ResultRuns(const std::string& take_path) : take_path_(take_path) {}
    Status storeClocks(TakeEdit& edit) const;
    Status nameRuns(TakeEdit& edit, Take& take, const ProcessRequest& request,
                    const std::vector<Ingredients>& subjects);

    std::string take_path_;
    std::vector<Part> parts_;
    int64_t clock_run_ = 0;  ///< 0: suit 1 is alone, or nothing joins the clocks
    size_t part_ = 0;        ///< that is written for; bodies come first, in the order of summary.subjects
    bool writes_readings_ = false;
};

}  // namespace noctule
