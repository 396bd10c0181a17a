// SPDX-License-Identifier: Apache-2.0
// Our own promises, checked in every build: a broken one throws std::logic_error.
#pragma once

#include <stdexcept>

namespace noctule {

inline void require(bool promise, const char* what) {
    if (!promise)
        throw std::logic_error(what);
}

}  // namespace noctule
