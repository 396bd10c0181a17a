// SPDX-License-Identifier: Apache-2.0
// Which pairs of source and board see each other in the rest pose, and what it says about boards that are
// exchanged: a board on the left hears what is on the left. The body is its capsules; a pair whose line only
// grazes them, or that looks at the source from its side, tells nothing.
#pragma once

#include <vector>

#include "core/calibration/rest_pose/rest_evidence.h"

namespace noctule {

class RestSight {
public:
    RestSight(const Observations& take, const StillStretch& still, const RestEvidenceMaker& maker);

    /// -2 log likelihood of which pairs are heard on the direct way and which are not.
    double cost(const Arrangement& arrangement) const;

private:
    enum class Sight { kUnsure, kClear, kBlocked };
    struct Way {
        Sight sight = Sight::kUnsure;
        double distance_m = 0;
    };
    std::vector<std::vector<Way>> ways_;             ///< [source][place], in the rest pose asked for
    std::vector<std::vector<double>> distance_m_;    ///< [source][stream] heard well; 0: not heard
    std::vector<bool> source_heard_, stream_heard_;  ///< at all
};

}  // namespace noctule
