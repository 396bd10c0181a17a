// SPDX-License-Identifier: Apache-2.0
// What a solver of calibration says about its own result, in plain words.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace noctule {

enum class Verdict { kGood, kUsable, kNotUsable };

/// "good", "usable", "not usable", as on the command line.
inline const char* verdictName(Verdict verdict) {
    constexpr const char* kNames[] = {"good", "usable", "not usable"};
    return kNames[static_cast<int>(verdict)];
}

struct Finding {
    Verdict verdict = Verdict::kUsable;  ///< what it makes of the whole
    std::string part;                    ///< id of the board or source; empty: of all
    std::string what;                    ///< a whole sentence without its full stop; names the part
    std::string remedy;                  ///< what to repeat or to mend, one sentence without its full stop

    bool operator==(const Finding&) const = default;
};

/// The worst of all; good when there is none.
inline Verdict verdictOf(const std::vector<Finding>& findings) {
    Verdict worst = Verdict::kGood;
    for (const Finding& finding : findings)
        worst = std::max(worst, finding.verdict);
    return worst;
}

}  // namespace noctule
