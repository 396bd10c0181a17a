// SPDX-License-Identifier: Apache-2.0
// Files that belong to the program and stand beside it.
#pragma once

#include <string>

namespace noctule {

/// Path of a file in the folder of the program that runs.
std::string besideThisProgram(const std::string& name);

}  // namespace noctule
