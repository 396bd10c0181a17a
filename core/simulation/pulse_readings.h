// SPDX-License-Identifier: Apache-2.0
// What the pulse detector would report, without any sound: the readings level. Arrival times come from the
// same geometry as the sound (flight, body, room), the detector is an error model with the figures measured
// for the inflection detector at signal level (core/acoustics/range_finder.cpp): it takes the first way whose
// power is above 0.3 of the loudest, is pulled by echoes that overlap it (pulse_overlap.h), scatters with
// 0.155 ms / SNR, and goes astray where the noise leads it. Clicks are left out.
//
// Ranges at full confidence, 6 s of a made motion, nominal, seeds 1 to 3; in brackets the signal level.
//   spread, mm                  1.01 (1.13)   1.37 (1.44)   1.31 (1.39)
//   median, mm                  0.01 (0.03)   0.45 (0.52)  -0.24 (-0.26)
//   more than 15 mm off, %      0.71 (0.74)   1.75 (1.65)   1.47 (1.23)
// Without the echoes' pull seed 1 has a spread of 0.59 mm. In `realistic`, with a click a second, the signal
// level has 0.5 to 0.9 % outliers and this one 0.2 to 0.3 %.
#pragma once

#include "core/acoustics/pulse_receiver.h"
#include "core/simulation/body_world.h"
#include "core/simulation/laboratory.h"
#include "core/simulation/pulse_overlap.h"
#include "core/simulation/sound_room.h"

namespace noctule::simulation {

class PulseReadings {
public:
    /// `world` must outlive the object. Its sources are those of `truth`, its boards may be more than one
    /// suit's. `room`: instead of the one that a suit alone is in.
    PulseReadings(const World& world, const Scenario& scenario, const HiddenTruth& truth,
                  const std::optional<Room>& room = {});

    /// Detections of one pulse by all boards, in their order; pulses are asked for in ascending order.
    /// Clears `detections`.
    void hear(const Pulse& pulse, std::vector<PulseDetection>& detections);
    /// The drive starts at that instant of the world. Arrivals still count from the pulse's sample.
    void hear(const Pulse& pulse, double drive_s, std::vector<PulseDetection>& detections);

private:
    void listWays(const Pulse& pulse, double drive_s, int board, std::vector<SoundWay>& ways);
    PulseDetection detect(const Pulse& pulse, int board, const std::vector<SoundWay>& ways);

    const World& world_;
    Scenario scenario_;
    HiddenTruth truth_;
    Medium medium_;
    Room room_;
    double speed_of_sound_m_per_s_;
    std::vector<PulseOverlap> overlaps_;  ///< per source
    std::vector<Random> random_;          ///< per board
    std::vector<WorldCapsule> capsules_;
    std::vector<EchoPath> echoes_;
};

}  // namespace noctule::simulation
