// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace noctule {

/// A text as a cell of a table with commas, quoted where RFC 4180 asks for it.
std::string csvCell(const std::string& text);

}  // namespace noctule
