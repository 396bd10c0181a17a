// SPDX-License-Identifier: Apache-2.0
// Files that come with the program and that users may read and copy.
#pragma once

#include <string>

namespace noctule {

/// Path of `name`: in share/noctule beside the folder of the running program (as installed), else in that
/// folder (as built).
std::string sharedPath(const std::string& name);

}  // namespace noctule
