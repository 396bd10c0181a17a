// SPDX-License-Identifier: Apache-2.0
// The rows of manifold_parameters.h about limbs: joint laxity, and the search for lost limbs and for a body
// whose suit was silent.
#pragma once

#include "core/estimation/manifold_parameters.h"

namespace noctule {

using ManifoldRows = ParameterTable<ManifoldSetup>;

ManifoldRows limbAlignmentRows();
ManifoldRows limbRangingRows();
ManifoldRows jointLaxityRows();
ManifoldRows silenceRows();

}  // namespace noctule
