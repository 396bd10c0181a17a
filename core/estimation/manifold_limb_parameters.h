// SPDX-License-Identifier: Apache-2.0
// The rows of manifold_parameters.h about limbs: how far joints give, and how lost limbs and a body whose
// suit was silent are found.
#pragma once

#include "core/estimation/manifold_parameters.h"

namespace noctule {

using ManifoldRows = ParameterTable<ManifoldSetup>;

ManifoldRows limbAlignmentRows();
ManifoldRows limbRangingRows();
ManifoldRows jointLaxityRows();
ManifoldRows silenceRows();

}  // namespace noctule
