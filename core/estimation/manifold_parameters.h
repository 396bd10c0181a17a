// SPDX-License-Identifier: Apache-2.0
// The parameters of the manifold filter and of its smoothers as a table.
#pragma once

#include "core/estimation/batch_smoother.h"
#include "core/estimation/manifold_filter.h"
#include "core/estimation/parameter.h"

namespace noctule {

struct ManifoldSetup {
    ManifoldParameters filter;
    /// In place of the filter's without a smoother, as live: it takes no longer than sound may wait.
    RelocationParameters live_relocation{.window_s = 0.4, .pause_s = 3, .rounds = 2};
    double lag_s = 0.5, stride_s = 0.2;  ///< FixedLagSmoother
    double stretch_s = 2;                ///< FixedIntervalSmoother
    BatchParameters batch;
};

const ParameterTable<ManifoldSetup>& manifoldParameters();

}  // namespace noctule
