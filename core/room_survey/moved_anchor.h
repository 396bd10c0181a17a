// SPDX-License-Identifier: Apache-2.0
// Whether an anchor was moved while the survey went on: no single place explains its ranges, one before and
// one after some instant do.
#pragma once

#include <algorithm>

#include "core/room_survey/room_fit.h"

namespace noctule::room_survey {

struct AnchorMove {
    int anchor = 0;
    double time_s = 0, distance_m = 0, sigma_m = 0;
    double explained = 0;  ///< share of its ranges that two places explain and one does not

    double sigmas() const { return distance_m / std::max(sigma_m, 1e-3); }
    bool isSuspicious() const { return distance_m > 0.015 && sigmas() > 4; }
    /// Too far for chance, and no matter of some echoes.
    bool isPlain() const { return distance_m > 0.04 && sigmas() > 6 && explained > 0.2; }
};

/// The best two places of every anchor that enough ranges concern, the plainest move first.
std::vector<AnchorMove> shiftsOf(const Evidence& evidence, const RoomFit& fit);

}  // namespace noctule::room_survey
