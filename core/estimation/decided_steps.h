// SPDX-License-Identifier: Apache-2.0
// What a filter decided in its first time over the data, kept in a file: which readings it believed and how
// far, and how much it let the state change. With that a take is one least-squares problem that stays the
// same however often it is linearised.
#pragma once

#include "core/estimation/step_spool.h"

namespace noctule {

struct DecidedStep {
    ManifoldFilter::StepInput input;
    Eigen::VectorXd acceleration_variance;  ///< of the process, per velocity index
    Eigen::VectorXd widened;                ///< added to the variances of all states; empty: nothing
    /// One after the other: variance and origin of each block (of pulls the columns, too), for
    /// ManifoldFilter::again().
    std::vector<std::vector<ObservationBlock>> updates;
    bool is_frame = false;  ///< a pose is wanted
    int64_t time_ns = 0;
    double flesh_rad2 = 0;  ///< as in jointSigmas()

    /// Takes over what a filter taped of one step.
    void note(const FilterTape& tape);
};

/// Steps in order, by stretches; 0.7 MB a second of the default suit.
class DecidedSteps {
public:
    explicit DecidedSteps(UnnamedFile file) : file_(std::move(file)) {}

    void add(const DecidedStep& step);
    /// What follows belongs to another stretch.
    void beginStretch() { stretches_.push_back({file_.position(), 0}); }
    int stretches() const { return static_cast<int>(stretches_.size()); }
    int64_t stepsOf(int stretch) const { return stretches_[static_cast<size_t>(stretch)].steps; }

    /// next() then gives that stretch's steps.
    void goTo(int stretch);
    /// False when it cannot be read back.
    bool next(DecidedStep& step);

private:
    struct Stretch {
        int64_t position = 0, steps = 0;
    };
    UnnamedFile file_;
    std::vector<Stretch> stretches_;
};

}  // namespace noctule
