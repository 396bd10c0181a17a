// SPDX-License-Identifier: Apache-2.0
// Photographs sorted for the bundle adjustment: which markers of which placement count, and what is to be
// said about the others. First step of measurePhotographs.
#pragma once

#include "core/vision/bundle.h"
#include "core/vision/first_poses.h"
#include "core/vision/marker_photographs.h"
#include "core/vision/marker_plan.h"

namespace noctule {

struct PhotographSet {
    std::vector<PlannedMarker> plan;
    std::vector<std::string> placements;
    std::vector<PlacementParts> parts;  ///< of each placement
    Bundle bundle;                      ///< poses and lenses as at the beginning
    // What stands behind the bundle's indices.
    std::vector<int> photograph_of_camera;  ///< in the list that was given
    std::vector<int> marker_placement, marker_in_plan;
    std::vector<std::array<int, 2>> lens_size_px;
    std::vector<Finding> findings;

    /// "source 2, chest_r" for an index of the bundle.
    const std::string& markerName(int marker) const {
        return plan[size_t(marker_in_plan[size_t(marker)])].name;
    }
    const std::string& placementOfMarker(int marker) const {
        return placements[size_t(marker_placement[size_t(marker)])];
    }
};

PhotographSet sortPhotographs(const std::vector<PlacedPhotograph>& photographs,
                              std::vector<PlannedMarker> plan, double side_m);

/// "a, b and c"
std::string inWords(const std::vector<std::string>& words);

}  // namespace noctule
