// SPDX-License-Identifier: Apache-2.0
// The jig of the tests as a bundle: where cameras and markers truly were and which corners that shows.
#pragma once

#include "core/vision/bundle.h"
#include "tests/core/vision/test_jig.h"

namespace noctule::test {

/// Of one placement, `photographs` of it, with exact corners.
inline Bundle knownBundle(int photographs, int placement = 0) {
    const TestCamera with;
    const Lens lens{with.focal_px, with.center_px, with.k1, with.k2};
    LensBelief belief{lens, Lens::Values::Constant(1e-2)};
    belief.sigma << 0.1, 50, 50, 0.1, 0.1, 0.5;
    const std::vector<StuckMarker> stuck = stickMarkers(defaultSuit(), placement);
    Bundle bundle{stuck.front().side_m, {belief}, {lens}, {}, {}, {}};
    std::map<int, int> index_of_number;
    for (const StuckMarker& marker : stuck) {
        index_of_number[marker.number] = static_cast<int>(bundle.markers.size());
        bundle.markers.push_back({Quaterniond(marker.R), marker.p_m});
    }
    std::mt19937 random(1);
    for (int k = 0; k < photographs; ++k) {
        const TestCamera camera = cameraOf(placement, k);
        bundle.cameras.push_back(
            {Quaterniond(camera.R).conjugate(), -(camera.R.transpose() * camera.p_m), 0, k == 0});
        for (const SeenMarker& seen : seenCorners(camera, stuck, 0, random, "").markers)
            bundle.sightings.push_back({k, index_of_number.at(seen.number), seen.corners_px, true});
    }
    return bundle;
}

/// Largest error of a distance between two markers that are seen; `scale` of the true ones.
inline double worstDistance_m(const Bundle& bundle, const Bundle& truth, double scale = 1) {
    std::set<int> seen;
    for (const Sighting& sighting : bundle.sightings)
        if (sighting.used)
            seen.insert(sighting.marker);
    double worst_m = 0;
    for (const int a : seen)
        for (const int b : seen) {
            const auto distance = [&](const Bundle& of) {
                return (of.markers[size_t(a)].p_jig_marker_m - of.markers[size_t(b)].p_jig_marker_m).norm();
            };
            worst_m = std::max(worst_m, std::abs(distance(bundle) - scale * distance(truth)));
        }
    return worst_m;
}

inline double worstSighting_px(const Bundle& bundle) {
    double worst_px = 0;
    for (const Sighting& sighting : bundle.sightings)
        if (sighting.used)
            worst_px = std::max(worst_px, sightingError_px(bundle, sighting));
    return worst_px;
}

}  // namespace noctule::test
