// SPDX-License-Identifier: Apache-2.0
// How good a result is, by the program's own judgement.
#pragma once

namespace noctule {

enum class Grade { kGood, kUsable, kNotUsable, kUnknown };

/// "good", "usable", "not usable", "not judged": as on the command line.
inline const char* gradeWord(Grade grade) {
    constexpr const char* kWords[] = {"good", "usable", "not usable", "not judged"};
    return kWords[static_cast<int>(grade)];
}

}  // namespace noctule
