// SPDX-License-Identifier: Apache-2.0
// The command line that makes a pose run again, for reports and for people who must explain every number.
#pragma once

#include <string>

#include "core/recording/rows.h"

namespace noctule {

/// `noctule --batch process TAKE ...` with the options that the run's settings hold; parameters that differ
/// from the estimator's defaults as --param. Repeats the run while the take's calibration and actor are those
/// that it was made with. Empty: the run does not say with which estimator it was made.
std::string commandOfRun(const DerivedRun& run, const std::string& take_path);

}  // namespace noctule
