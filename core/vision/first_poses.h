// SPDX-License-Identifier: Apache-2.0
// Where bundle adjustment begins: each photograph tells each marker's pose before its camera up to an
// ambiguity (IPPE, Collins and Bartoli 2014: a small square looks nearly the same tilted to either side), and
// markers that several photographs show tie cameras together, from the photograph with the most on.
#pragma once

#include "core/vision/bundle.h"

namespace noctule {

/// Cameras and markers of one placement; indices into the bundle.
struct PlacementParts {
    std::vector<int> cameras, markers;
};

/// Sets the poses of the placement's cameras and markers, with the lenses as they are; the first camera of
/// all gets the placement's frame and stays. Sightings of cameras that share no marker with the others, and
/// those that make no sense, become unused.
void setFirstPoses(Bundle& bundle, const PlacementParts& parts);

/// Markers that another of their possible poses suits better take it; how many did.
int turnMistakenMarkers(Bundle& bundle);

}  // namespace noctule
