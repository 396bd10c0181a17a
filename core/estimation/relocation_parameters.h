// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace noctule {

/// How the body is found again after the whole suit was silent (relocation.h).
struct RelocationParameters {
    double silence_s = 0.2;  ///< shorter ones are bridged by the prediction
    double window_s = 0.8;   ///< of readings after it that are looked at together
    double pause_s = 0;      ///< between two times that the body is looked for
    int rounds = 3;          ///< of deciding what to believe and fitting the motion to it; 0: not at all
};

}  // namespace noctule
