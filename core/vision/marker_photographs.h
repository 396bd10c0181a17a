// SPDX-License-Identifier: Apache-2.0
// Distances on the jig from photographs of printed markers, at least two photographs per placement: where
// each source and board stood, from bundle adjustment over all placements with one camera for all photographs
// of one size, whose focal length, middle and distortion come out too, and by how
// much its tones move edges (markers near and far tell it from scale). Metres.
//
// A distance's sigma counts three things: what the corners tell (covariance of the fit), how well a marker's
// middle lies over the source's or the microphone's (by hand), how well the printed side is known. So it is
// never below 0.42 mm. The last is common to all distances and counts here as if it were not.
#pragma once

#include <string>
#include <vector>

#include "core/calibration/source_offsets/known_distances.h"
#include "core/job/job.h"
#include "core/suit/suit.h"
#include "core/vision/photograph.h"

namespace noctule {

struct PhotographSettings {
    double side_m = 0.04;            ///< of the markers, measured on the paper
    double sticking_sigma_m = 3e-4;  ///< of a marker's middle, in each direction
    double side_sigma = 1e-3;        ///< of the side, as a share of it
};

struct PlacedPhotograph {
    std::string placement;
    Photograph photograph;
};

struct PhotographUse {
    std::string name, placement;
    int markers = 0;      ///< used
    double error_px = 0;  ///< root mean square of their corners
};

struct FoundLens {
    int width_px = 0, height_px = 0;
    double focal_px = 0, k1 = 0, k2 = 0;
    double edge_px = 0;  ///< as in Lens
};

struct PhotographedDistances {
    KnownDistances known;             ///< with the findings; without distances when nothing can be told
    std::vector<double> fit_sigma_m;  ///< of each distance, the part from the fit
    std::vector<PhotographUse> photographs;
    std::vector<FoundLens> lenses;
    double corner_sigma_px = 0;
};

/// kUnusable when the suit has more parts than there are markers; all else is a finding.
Result<PhotographedDistances> measurePhotographs(const std::vector<PlacedPhotograph>& photographs,
                                                 const Suit& suit, const PhotographSettings& settings,
                                                 const JobContext& job);

}  // namespace noctule
