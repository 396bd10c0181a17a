// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/pulse_readings.h"

#include <algorithm>
#include <cmath>

namespace noctule::simulation {
namespace {

constexpr double kFirstAboveShareOfPower = 0.3;  // the inflection detector's threshold
constexpr double kScatterTimesSnr_s = 1.55e-4;
// Of the direct way's amplitude. With 0.02 the spread of ranges is no nearer to the signal level's.
constexpr double kFaintestEcho = 0.05;

/// Share of pulses for which noise leads the detector astray: 3.5 % at an amplitude ratio of 8, 1 % at 11.
double astrayShare(double snr) {
    return std::min(1.0, 0.035 * std::exp((8 - snr) / 2.4));
}

}  // namespace

PulseReadings::PulseReadings(const World& world, const Scenario& scenario, const HiddenTruth& truth,
                             const std::optional<Room>& room)
    : world_(world),
      scenario_(scenario),
      truth_(truth),
      medium_(mediumOf(scenario.sound, truth.air.speedOfSound_m_per_s())),
      room_(room ? *room : Room(world, scenario.sound, truth.seed)),
      speed_of_sound_m_per_s_(truth.air.speedOfSound_m_per_s()) {
    for (const SourceTruth& source : truth.sound.sources)
        overlaps_.emplace_back(scenario.drive_hz, scenario.pulse_cycles, source.resonance_hz, source.q);
    for (int b = 0; b < world.boardCount(); ++b)
        random_.emplace_back(truth.seed, "detection", static_cast<uint64_t>(b));
}

void PulseReadings::listWays(const Pulse& pulse, double drive_s, int board, std::vector<SoundWay>& ways) {
    const double t_s = drive_s + truth_.sound.sources[pulse.source].start_delay_s;
    const double ka = truth_.sound.sources[pulse.source].ka;
    const PathEnds ends{world_.source(pulse.source, t_s), world_.sourceNormal(pulse.source, t_s),
                        world_.microphone(board, t_s)};
    const DirectPath direct = directPath(ends, capsules_, ka, medium_);
    const Flight flight = directFlight(world_, pulse.source, board, t_s, speed_of_sound_m_per_s_);
    ways.clear();
    ways.push_back({(flight.distance_m + direct.detour_m) / speed_of_sound_m_per_s_, direct.gain});
    if (!scenario_.sound.reflections)
        return;
    const Room::Query query{ends,
                            ends.source_m,
                            world_.sourceSegment(pulse.source),
                            world_.boardSegment(board),
                            ka,
                            std::max(kFaintestEcho * direct.gain, 1e-4)};
    room_.echoes(query, capsules_, medium_, echoes_);
    // The microphone moves alike for all ways: half a wavelength is 4 mm, so what it moves counts.
    const double moved_m = flight.distance_m - (ends.microphone_m - ends.source_m).norm();
    for (const EchoPath& echo : echoes_)
        ways.push_back({(echo.now.before_m + (ends.microphone_m - echo.now.last_point_m).norm() + moved_m) /
                            speed_of_sound_m_per_s_,
                        echo.gain});
}

PulseDetection PulseReadings::detect(const Pulse& pulse, int board, const std::vector<SoundWay>& ways) {
    double loudest = 0;
    for (const SoundWay& way : ways)
        loudest = std::max(loudest, way.gain);
    const SoundWay* heard = nullptr;
    for (const SoundWay& way : ways)
        if (way.gain * way.gain >= kFirstAboveShareOfPower * loudest * loudest &&
            (!heard || way.delay_s < heard->delay_s))
            heard = &way;

    const PulseOverlap::Rise rise = overlaps_[pulse.source].rise(ways, *heard, loudest);

    const SourceTruth& source = truth_.sound.sources[pulse.source];
    const BoardTruth& microphone = truth_.sound.boards[board];
    const double amplitude_counts = scenario_.sound.amplitude_counts_at_1m * rise.peak_gain *
                                    gainFromDb(source.gain_db + microphone.gain_db);
    PulseDetection detection;
    detection.pulse = pulse;
    detection.board = board;
    detection.peak_power = amplitude_counts * amplitude_counts / 2;
    const double rounding_power = 1.0 / 12 * 2 * 5000 / scenario_.sample_rate_hz;  // in the 5 kHz band
    detection.noise_power = std::pow(scenario_.sound.acoustic_noise_counts, 2) + rounding_power;

    // All draws are made for every pulse, so that what is heard does not shift the stream.
    Random& random = random_[board];
    const double scatter = random.gaussian(), astray = random.uniform(), astray_place = random.uniform();
    const bool noisy = scenario_.sound.acoustic_noise_counts > 0;
    double delay_s =
        heard->delay_s + rise.shift_s + truth_.inflection_offset_s[pulse.source] + microphone.mic_delay_s;
    if (noisy)
        delay_s += scatter * kScatterTimesSnr_s / detection.snr();
    if (noisy && astray < astrayShare(detection.snr()))
        delay_s = astray_place * scenario_.pulse_interval_s;
    detection.arrival_sample = static_cast<double>(pulse.sample) + delay_s * scenario_.sample_rate_hz;
    return detection;
}

void PulseReadings::hear(const Pulse& pulse, std::vector<PulseDetection>& detections) {
    hear(pulse, static_cast<double>(pulse.sample) / scenario_.sample_rate_hz, detections);
}

void PulseReadings::hear(const Pulse& pulse, double drive_s, std::vector<PulseDetection>& detections) {
    world_.capsules(drive_s, capsules_);
    detections.clear();
    std::vector<SoundWay> ways;
    for (int b = 0; b < world_.boardCount(); ++b) {
        listWays(pulse, drive_s, b, ways);
        detections.push_back(detect(pulse, b, ways));
    }
}

}  // namespace noctule::simulation
