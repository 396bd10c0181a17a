// SPDX-License-Identifier: Apache-2.0
// Guide of the sources' calibration on the jig: its steps are the placements that were measured, in any order
// (Vlasic 2007, section 4.3). Which one stands there is told by the distances heard, against those measured;
// what a source's unknown offset adds to all of its distances is left out of that.
#pragma once

#include <string>

#include "core/calibration/source_offsets/known_distances.h"
#include "core/guide/guide.h"

namespace noctule {

class PlacementGuide : public Guide {
public:
    PlacementGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz,
                   const KnownDistances& known);

    /// Of the pairs that were measured there; with fewer something stands in between.
    static constexpr double kEnoughShare = 0.5;
    /// Detectors are some millimetres apart on a jig; placements differ by centimetres.
    static constexpr double kFits_m = 0.02;

    /// As in the table of distances, in its order.
    std::string labelOf(int step) const override { return placements_[index(step)]; }

protected:
    Hindrance see(const HealthReport& health, Guidance& guidance) override;

private:
    struct Pair {
        int source, board;
        double distance_m;
    };
    /// How far the distances heard are from the placement's, which are taken for so many times the true ones,
    /// in the median; absent with too few.
    std::optional<double> misfit_m(const HealthReport& health, size_t placement, double factor = 1) const;
    /// By which the table's distances are too long, if one of the usual mistakes explains what is heard.
    std::optional<double> unitFactor(const HealthReport& health) const;
    double heardShare(const HealthReport& health, size_t placement) const;

    std::vector<std::string> placements_;
    std::vector<std::vector<Pair>> pairs_;  ///< of each placement
};

/// As they come in the table.
std::vector<std::string> placementsOf(const KnownDistances& known);

}  // namespace noctule
