// SPDX-License-Identifier: Apache-2.0
#include "core/processing/standing_feet.h"

#include <algorithm>
#include <cmath>

namespace noctule {

FootPlants footPlants(const std::vector<FootContacts>& feet, double begin_s) {
    FootPlants plants;
    for (const FootContacts& foot : feet) {
        if (foot.foot != "LeftFoot" && foot.foot != "RightFoot")
            continue;
        std::vector<FootPlant>& stands = plants[foot.foot == "LeftFoot" ? 0 : 1];
        for (const FootContact& contact : foot.contacts)
            stands.push_back({contact.from_s - begin_s, contact.to_s - begin_s});
        std::ranges::sort(stands, {}, &FootPlant::from_s);
        size_t kept = 0;
        for (size_t i = 1; i < stands.size(); ++i)
            if (stands[i].from_s <= stands[kept].to_s)
                stands[kept].to_s = std::max(stands[kept].to_s, stands[i].to_s);
            else
                stands[++kept] = stands[i];
        stands.resize(std::min(stands.size(), kept + 1));
    }
    return plants;
}

FeetAtRest feetAtRest(const TimedMotion& motion, const std::vector<FootContacts>& feet) {
    const int64_t max_gap_ns = bridgeableGap_ns(motion);
    return feetAtRest(motion.skeleton, footPlants(feet, 0),
                      [&](double t_s) { return poseAt(motion, std::llround(t_s * 1e9), max_gap_ns); });
}

}  // namespace noctule
