// SPDX-License-Identifier: Apache-2.0
// Stands in for the studio in builds without it (NOCTULE_STUDIO=OFF), which run jobs only.
#include "app/studio/studio_main.h"

#include <cstdio>

#include "core/job/result.h"

namespace noctule::studio {

int runStudio(int, char**) {
    std::fputs(
        "noctule: this build has no studio. Run jobs with `noctule --batch VERB`, or build it with "
        "`cmake --preset release` and `cmake --build --preset release`.\n",
        stderr);
    return static_cast<int>(ErrorKind::kUsage);
}

}  // namespace noctule::studio
