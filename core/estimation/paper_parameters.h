// SPDX-License-Identifier: Apache-2.0
// The parameters of PaperFilter as a table.
#pragma once

#include "core/estimation/paper_filter.h"
#include "core/estimation/parameter.h"

namespace noctule {

/// The one that screens show, too.
inline constexpr const char* kPaperProcessSigma = "process_sigma";

const ParameterTable<PaperParameters>& paperParameters();

}  // namespace noctule
