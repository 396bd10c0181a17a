// SPDX-License-Identifier: Apache-2.0
// Opens the studio: `noctule [SESSION|TAKE]`.
#pragma once

namespace noctule::studio {

/// Returns the exit code; 2 when there is no display.
int runStudio(int argc, char** argv);

}  // namespace noctule::studio
