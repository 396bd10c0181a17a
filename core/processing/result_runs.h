// SPDX-License-Identifier: Apache-2.0
// The derived runs that one processing adds to a take, whether the pipeline ran on the file or on the suit
// while it was recorded: the same rows either way.
#pragma once

#include <functional>
#include <vector>

#include "core/processing/ingredients.h"
#include "core/processing/process_take.h"
#include "core/processing/result_spool.h"
#include "core/recording/take_edit.h"

namespace noctule {

/// Where results go while the data are still being read: beside the take, which stays free for others until
/// store() writes them.
class ResultRuns : public ResultSink {
public:
    /// Readings do not depend on calibration or estimator: a run of them by the same software serves all, and
    /// those given here are then only counted.
    static Result<ResultRuns> begin(const Take& take, const ProcessRequest& request, const Ingredients& in);

    Status write(const std::vector<InertialReading>& readings) override;
    Status write(const std::vector<RangeMeasurement>& ranges) override;
    /// Fails (kUnusable) for a pose that is not finite.
    Status write(const std::vector<TimedPose>& poses) override;
    Status write(const std::vector<FootContacts>& contacts);

    /// All of it as one transaction, with the calibration and the actor of the request in force.
    Status store(Take& take, const ProcessRequest& request, Ingredients& in);

    ProcessSummary summary;

private:
    explicit ResultRuns(ResultSpool spool) : spool_(std::move(spool)) {}
    Status nameRuns(TakeEdit& edit, const Take& take, const ProcessRequest& request, const Ingredients& in);

    ResultSpool spool_;
    std::vector<FootContacts> contacts_;
    bool writes_readings_ = false;
};

/// Gives everything that the processing yields to the runs.
using FillRuns = std::function<Status(const Take& take, const Ingredients& in, ResultRuns& runs)>;

/// Everything or nothing: when filling fails or yields no pose, the take stays as it was. Reads in one
/// snapshot; another program that writes the take meanwhile is waited for, at most an hour.
Result<ProcessSummary> writeRuns(const ProcessRequest& request, const FillRuns& fill,
                                 const CancelFlag* cancel = nullptr);

}  // namespace noctule
