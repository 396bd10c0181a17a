// SPDX-License-Identifier: Apache-2.0
// Keeps what a job tells of one of its stages, and cancels it there when asked to.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/job/job.h"

namespace noctule::test {

class StageFractions : public ProgressSink {
public:
    explicit StageFractions(std::string stage, double cancel_at = std::numeric_limits<double>::infinity())
        : stage_(std::move(stage)), cancel_at_(cancel_at) {}

    void progress(double fraction, const std::string& stage) override {
        if (stage != stage_)
            return;
        told.push_back(fraction);
        if (fraction >= cancel_at_)
            cancel_.cancel();
    }
    JobContext job() { return {this, &cancel_}; }

    std::vector<double> told;

private:
    std::string stage_;
    double cancel_at_;
    CancelFlag cancel_;
};

}  // namespace noctule::test
