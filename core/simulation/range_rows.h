// SPDX-License-Identifier: Apache-2.0
// Pulses and ranges of a take at readings level: every suit's pulses as the boards of all suits hear them.
// A range between suits: `arrival_sample` counts on the clock of the microphone's suit, `distance_m` believes
// the recorder's first guess of the clocks (several metres off), and the confidences are those of the true
// distance, as of a recorder that tracks the clocks.
#pragma once

#include <memory>

#include "core/acoustics/range_finder.h"
#include "core/simulation/cast_world.h"
#include "core/simulation/pulse_readings.h"
#include "core/simulation/suit_rows.h"

namespace noctule::simulation {

class RangeRows {
public:
    /// `status` per suit. `chamber`: the room of a cast; none: the room that a suit alone is in. Suits must
    /// outlive the object.
    static Result<RangeRows> create(const std::vector<StagedSuit>& suits,
                                    const std::vector<std::vector<TemperatureStatus>>& status,
                                    const std::optional<Room>& chamber);

    /// Writes the next pulse of all suits and its ranges; false: there is none.
    Result<bool> writeNext(TakeWriter& take, SimulationSummary& summary);
    /// When the last pulse was driven, take time.
    double reached_s() const { return reached_s_; }

private:
    /// A suit with its sources; the world is that of its pulses.
    struct Speaker {
        CastWorld world;
        PulseSchedule schedule;
        int64_t end_sample = 0;  ///< of the suit
        int64_t next = 0;        ///< pulse
        std::unique_ptr<PulseReadings> readings{};
        std::vector<RangeFinder> listeners{};  ///< per suit: of the pairs with its boards
    };

    explicit RangeRows(const std::vector<StagedSuit>& suits) : suits_(suits) {}
    Status addSpeaker(size_t suit, const std::vector<std::vector<TemperatureStatus>>& status,
                      const std::optional<Room>& chamber);
    bool hasPulse(const Speaker& speaker) const;
    std::optional<RangeMeasurement> rangeOf(size_t speaker, PulseDetection detection, double drive_s);

    const std::vector<StagedSuit>& suits_;
    std::vector<std::unique_ptr<Speaker>> speakers_;
    std::vector<PulseDetection> detections_;
    double reached_s_ = 0;
};

}  // namespace noctule::simulation
