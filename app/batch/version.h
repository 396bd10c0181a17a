// SPDX-License-Identifier: Apache-2.0
// The version of the program, as packaging/cmake/version.cmake found it when the program was built.
#pragma once

namespace noctule::batch {

/// "0.1.0", "0.1.0-7-g1a2b3c4d" or "0.1.0+g1a2b3c4d"; "-dirty" behind it: with changes that are in no commit.
const char* softwareVersion();

}  // namespace noctule::batch
