// SPDX-License-Identifier: Apache-2.0
// Gauss-Newton's step for the motion of one stretch, in memory. The filter goes over it, linearised about the
// motion. Going back gives the adjoint lambda of every step, and with it the step's noise, -Q lambda. Going
// forward with these noises gives the errors. At the begin the error is the filter's less P lambda (Koopman,
// "Disturbance smoother for state space models", Biometrika 80, 1993).
#pragma once

#include <vector>

#include "core/estimation/backward_pass.h"
#include "core/estimation/map_problem.h"

namespace noctule {

class GaussNewtonStretch {
public:
    /// `begin`: the filter at the stretch's first state. Keeps a reference.
    GaussNewtonStretch(const MapProblem& problem, MapProblem::Estimate begin);

    /// The next step, in order.
    void pass(const DecidedStep& step, const Leg& leg);
    /// Of the states at the begin of the stretch and after each step: what is to be added to them. `adjoint`:
    /// at the stretch's end, and then at its begin.
    std::vector<Eigen::VectorXd> errors(AdjointPass& adjoint) const;

private:
    struct Passed {
        DecidedStep noise;  ///< of it only what noiseTimes() needs
        Eigen::VectorXd defect;
    };
    const MapProblem& problem_;
    MapProblem::Estimate begin_, estimate_;
    FilterTape tape_;
    std::vector<Passed> passed_;
};

}  // namespace noctule
