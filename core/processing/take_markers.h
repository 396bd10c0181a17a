// SPDX-License-Identifier: Apache-2.0
// Sets, renames and deletes markers of the operator (kind "user") in a take that exists.
#pragma once

#include <optional>
#include <string>

#include "core/job/job.h"
#include "core/job/result.h"
#include "core/recording/take.h"

namespace noctule {

/// Operators mark the take, not a suit: their markers stand with the first suit that somebody wears, else
/// with that of the room, in samples of its box.
struct MarkerClock {
    int suit;
    SuitClock clock;
    double rate_hz;  ///< 0: the take has none

    /// Of the take's clock, as all times on the screens.
    double seconds(int64_t sample) const;
    int64_t sampleAt(double t_s) const;
};
/// The take looks at that suit then.
Result<MarkerClock> markerClock(Take& take);

struct UserMarker {
    double t_s = 0;  ///< on the take's clock
    std::string label{};

    bool operator==(const UserMarker&) const = default;
};

/// What goes and what comes; only one of them when a marker is set or deleted.
struct MarkerChange {
    std::optional<UserMarker> before{}, after{};

    MarkerChange reversed() const { return {after, before}; }
};

/// All of it or nothing. kUsage when `after` lies outside the take or the take has no marker `before`.
Status changeMarker(const std::string& path, const MarkerChange& change, const JobContext& job);

}  // namespace noctule
