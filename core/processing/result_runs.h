// SPDX-License-Identifier: Apache-2.0
// The derived runs that one processing adds to a take, whether the pipeline ran on the file or on the suit
// while it was recorded: the same rows either way.
#pragma once

#include <functional>
#include <vector>

#include "core/processing/ingredients.h"
#include "core/processing/process_take.h"
#include "core/recording/take_edit.h"

namespace noctule {

/// Where results go while the data are still being read; one transaction.
class ResultRuns {
public:
    /// Adds the rows that name the runs. Readings do not depend on calibration or estimator: a run of them by
    /// the same software serves all, and those given here are then only counted.
    static Result<ResultRuns> begin(Take& take, TakeEdit& edit, const ProcessRequest& request,
                                    const std::vector<Ingredients>& subjects);
    /// What is written from now on is this subject's.
    void beginSubject(const Ingredients& in);

    Status write(const std::vector<InertialReading>& readings);
    Status write(const std::vector<RangeMeasurement>& ranges);
    /// Fails (kInternal) for a pose that is not finite.
    Status write(const std::vector<TimedPose>& poses);
    Status write(const std::vector<FootContacts>& contacts);

    ProcessSummary summary;

private:
    ResultRuns(TakeEdit& edit, const char* detector) : edit_(&edit), detector_(detector) {}

    TakeEdit* edit_;
    const char* detector_;
    SuitClock clock_;
    bool writes_readings_ = false;
};

/// Gives everything that the processing of one subject, whose suit is in view, yields to the runs.
using FillRuns = std::function<Status(const Take& take, const Ingredients& in, ResultRuns& runs)>;

/// Everything or nothing: when filling fails or yields no pose, the take stays as it was.
Result<ProcessSummary> writeRuns(const ProcessRequest& request, const FillRuns& fill);

}  // namespace noctule
