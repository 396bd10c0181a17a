// SPDX-License-Identifier: Apache-2.0
// Parameters of estimators on the command line.
#pragma once

#include <string>
#include <vector>

#include "core/live/estimators.h"

namespace noctule::batch {

std::vector<std::string> estimatorNames();

/// Adds "NAME=VALUE"; kUsage when it is anything else. Names are not checked.
Status addParameter(const std::string& setting, ParameterValues& values);

/// Adds those of a JSON file: an object of numbers, or one with a member `parameters` that is, as the
/// settings of a run. kUnreadable names what is not; kUsage when the file is of another estimator.
Status addParameterFile(const std::string& path, const EstimatorEntry& estimator, ParameterValues& values);

}  // namespace noctule::batch
