// SPDX-License-Identifier: Apache-2.0
// The pull of an echo, against the detector itself on the sound of a pulse and its echo.
#include "core/simulation/pulse_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/acoustics/pulse_detector.h"
#include "core/simulation/sound_tone.h"
#include "tests/support/rate.h"

namespace noctule::simulation {
namespace {

using test::kRate_hz;
constexpr double kDrive_hz = 40000, kAmplitude_counts = 10000;
constexpr int kCycles = 10;

struct Source {
    double resonance_hz, q;
};

class HeardByDetector {
public:
    HeardByDetector() : detector_(std::move(makeDetector(Detector::kInflection, train_).value())) {}

    PulseArrival hear(const Source& source, const std::vector<SoundWay>& ways) {
        std::vector<float> sound(static_cast<size_t>(detector_->windowSamples()));
        const ToneSum pulse = receivedPulse(kDrive_hz, kCycles, source.resonance_hz, source.q);
        for (const SoundWay& way : ways)
            addTones(
                pulse,
                {detector_->marginSamples() + way.delay_s * kRate_hz, kRate_hz, kAmplitude_counts * way.gain},
                sound);
        std::vector<int16_t> window;
        for (int i = 0; i < detector_->windowSamples(); ++i)
            window.push_back(static_cast<int16_t>(std::lround(sound[static_cast<size_t>(i)])));
        PulseArrival arrival;
        detector_->detect(window, {&arrival, 1});
        return arrival;
    }

private:
    PulseTrain train_{kRate_hz, 1200, kDrive_hz, kCycles};
    std::unique_ptr<PulseDetector> detector_;
};

TEST(PulseOverlap, PullsAsTheDetectorIsPulled) {
    HeardByDetector detector;
    double strongest_s = 0;
    for (const Source& source : {Source{40000, 25}, Source{40500, 31}, Source{39600, 15}}) {
        const PulseOverlap overlap(kDrive_hz, kCycles, source.resonance_hz, source.q);
        for (const double gain : {0.05, 0.15, 0.3})
            for (double delay_s = 15e-6; delay_s < 400e-6; delay_s += 7.3e-6) {
                const SoundWay direct{1e-3, 0.5}, echo{1e-3 + delay_s, 0.5 * gain};
                const PulseArrival alone = detector.hear(source, {direct});
                const PulseArrival both = detector.hear(source, {direct, echo});
                const PulseOverlap::Rise rise = overlap.rise({direct, echo}, direct, direct.gain);
                const double heard_s = (both.sample - alone.sample) / kRate_hz;
                // 1 us is 0.34 mm; the detector's own ripple over positions between samples is 0.2 mm.
                EXPECT_NEAR(rise.shift_s, heard_s, 1e-6 + 0.1 * std::abs(heard_s))
                    << gain << " after " << delay_s * 1e6 << " us";
                EXPECT_NEAR(kAmplitude_counts * rise.peak_gain / std::sqrt(2 * both.peak_power), 1, 0.05)
                    << gain << " after " << delay_s * 1e6 << " us";
                strongest_s = std::max(strongest_s, std::abs(heard_s));
            }
    }
    EXPECT_GT(strongest_s, 1e-5) << "3 mm: nothing was tested";
}

TEST(PulseOverlap, APulseAloneIsNotPulled) {
    const PulseOverlap overlap(kDrive_hz, kCycles, 40000, 25);
    const SoundWay direct{2e-3, 0.1}, far_echo{6e-3, 0.05};
    EXPECT_EQ(overlap.rise({direct}, direct, 0.1).shift_s, 0);
    EXPECT_EQ(overlap.rise({direct, far_echo}, direct, 0.1).shift_s, 0);
    const double peak_gain = overlap.rise({direct}, direct, 0.1).peak_gain;
    EXPECT_GT(peak_gain, 0.05) << "what the band-pass leaves of it";
    EXPECT_LT(peak_gain, 0.1);
}

}  // namespace
}  // namespace noctule::simulation
