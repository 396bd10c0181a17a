// SPDX-License-Identifier: Apache-2.0
// One member of a document replaced by what must not stand there.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>

#include "core/job/result.h"

namespace noctule::test {

struct Damage {
    const char* pointer;
    nlohmann::json value;
    ErrorKind kind;
    const char* named;  ///< must stand in the message
};

/// How GoogleTest names the case.
inline void PrintTo(const Damage& c, std::ostream* out) {
    *out << c.pointer;
}

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace noctule::test
