// SPDX-License-Identifier: Apache-2.0
// Versions of what writes take files, as at run time: "3.40.1".
#pragma once

#include <string>

namespace noctule {

std::string sqliteVersion();
std::string zstdVersion();

}  // namespace noctule
