// SPDX-License-Identifier: Apache-2.0
// Helpers of the program: files that belong to it and are not for users.
#pragma once

#include <string>

namespace noctule {

/// Path of the helper `name`. It stands in the folder of the running program (as built), or in
/// libexec/noctule beside that folder (as installed, wherever that was moved to). A helper that is missing:
/// the former path.
std::string helperPath(const std::string& name);

}  // namespace noctule
