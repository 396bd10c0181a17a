// SPDX-License-Identifier: Apache-2.0
// One pulse heard by one board: when it arrived and how far to trust it (Vlasic 2007, section 4.1).
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

namespace noctule {

/// A pulse as the driver box logged it.
struct Pulse {
    int64_t id = 0;      ///< row of the take's pulse table
    int64_t sample = 0;  ///< start of the electrical drive
    int source = 0;
};

/// What an estimator made of a range.
enum class RangeFate {
    kNotTried,  ///< no estimator has seen it, or it does without distances
    kUsed,
    kWeighted,      ///< used with less weight: further off than expected
    kGated,         ///< thrown out: too far from what the pose allows
    kBehindSource,  ///< the microphone is behind the source (w_a = 0)
    kNoConfidence,
};

/// "used", "weighted", "gated", "behind", "unsure"; empty for kNotTried. As in the take's range table.
inline const char* rangeFateName(RangeFate fate) {
    constexpr const char* kNames[] = {"", "used", "weighted", "gated", "behind", "unsure"};
    return kNames[static_cast<int>(fate)];
}
inline RangeFate rangeFateFromName(std::string_view name) {
    for (RangeFate fate : {RangeFate::kUsed, RangeFate::kWeighted, RangeFate::kGated,
                           RangeFate::kBehindSource, RangeFate::kNoConfidence})
        if (name == rangeFateName(fate))
            return fate;
    return RangeFate::kNotTried;
}

/// Ranges that were heard, by what became of them: the rest is left_out.
struct RangeTally {
    int64_t heard = 0, used = 0, gated = 0, behind = 0, left_out = 0;

    void add(RangeFate fate) {
        heard += 1;
        switch (fate) {
            case RangeFate::kUsed:
            case RangeFate::kWeighted:
                used += 1;
                return;
            case RangeFate::kGated:
                gated += 1;
                return;
            case RangeFate::kBehindSource:
                behind += 1;
                return;
            case RangeFate::kNotTried:
            case RangeFate::kNoConfidence:
                left_out += 1;
                return;
        }
    }
};

/// NaN: not measured, or to be computed from emission and arrival once both clocks are known.
inline constexpr double kNoDistance = std::numeric_limits<double>::quiet_NaN();

/// A distance by the phase of the carrier: fine, but only up to whole cycles.
struct CarrierRange {
    double cycle_m = 0;     ///< 0: there is none
    double distance_m = 0;  ///< of the cycles the one nearest to the envelope's distance
    double sigma_m = 0;     ///< once the cycle is right
    double envelope_m = 0, envelope_sigma_m = 0;
    double m_per_sample = 0;  ///< of the sound's way
};

struct RangeMeasurement {
    int64_t pulse = 0;  ///< Pulse::id
    int64_t pulse_sample = 0;
    int source = 0;
    int board = 0;
    double arrival_sample = 0;  ///< as detected, before the source's offset is taken off
    double distance_m = 0;      ///< from the source at emission to the microphone at arrival
    double w_s = 0;             ///< confidence from signal strength, 0..1
    double w_t = 0;             ///< from continuity in time, 0..1
    double w_a = 1;             ///< from the angle to the source's normal, 0..1; set where the pose is known
    double sigma_m = 0;         ///< standard deviation of distance_m at full confidence
    CarrierRange carrier{};     ///< of detectors that see it

    RangeFate fate = RangeFate::kNotTried;
    double innovation_m = 0;  ///< measured minus expected, where it was tried

    double confidence() const { return w_s * w_t * w_a; }
};

}  // namespace noctule
