// SPDX-License-Identifier: Apache-2.0
// What a solver of calibration says about its own result, in plain words.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/job/grade.h"

namespace noctule {

struct Finding {
    Grade grade = Grade::kUsable;      ///< what it makes of the whole
    std::string part;                  ///< id of the board or source; empty: of several, or of all
    std::string what;                  ///< a whole sentence without its full stop; names the part
    std::string remedy;                ///< what to repeat or to mend, one sentence without its full stop
    std::vector<std::string> parts{};  ///< ids, when it is of several; empty: of `part`, or of all

    bool concerns(const std::string& id) const {
        return parts.empty() ? part.empty() || part == id : std::ranges::find(parts, id) != parts.end();
    }
    bool operator==(const Finding&) const = default;
};

/// The worst of all; good when there is none.
inline Grade gradeOf(const std::vector<Finding>& findings) {
    Grade worst = Grade::kGood;
    for (const Finding& finding : findings)
        worst = std::max(worst, finding.grade);
    return worst;
}

}  // namespace noctule
