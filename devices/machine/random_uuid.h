// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace noctule {

/// Random, version 4 of RFC 9562.
std::string randomUuid();

}  // namespace noctule
