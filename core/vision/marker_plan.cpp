// SPDX-License-Identifier: Apache-2.0
#include "core/vision/marker_plan.h"

#include "core/calibration/source_offsets/jig_measurements.h"

namespace noctule {

Result<std::vector<PlannedMarker>> planMarkers(const Suit& suit) {
    const int sources = static_cast<int>(suit.sources.size()), boards = static_cast<int>(suit.boards.size());
    const int most_sources = kFirstBoardMarker - kFirstSourceMarker,
              most_boards = kOriginMarker - kFirstBoardMarker;
    if (sources > most_sources || boards > most_boards)
        return Error{ErrorKind::kUnusable,
                     "suit " + suit.name + " has " + std::to_string(sources) + " sources and " +
                         std::to_string(boards) + " boards; there are markers for " +
                         std::to_string(most_sources) + " and " + std::to_string(most_boards),
                     "Measure the distances with a digitizer or a tape"};
    std::vector<PlannedMarker> plan;
    using Kind = PlannedMarker::Kind;
    for (int s = 0; s < sources; ++s)
        plan.push_back(
            {Kind::kSource, kFirstSourceMarker + s, s, suit.sources[size_t(s)].id, jigSource(suit, s)});
    for (int b = 0; b < boards; ++b)
        plan.push_back(
            {Kind::kBoard, kFirstBoardMarker + b, b, suit.boards[size_t(b)].id, jigBoard(suit, b)});
    plan.push_back({Kind::kOrigin, kOriginMarker, 0, "", "origin"});
    return plan;
}

}  // namespace noctule
