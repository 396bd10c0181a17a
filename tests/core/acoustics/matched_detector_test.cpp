// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "core/acoustics/pulse_detector.h"
#include "core/acoustics/pulse_shape_learner.h"
#include "tests/core/acoustics/synthetic_sound.h"

namespace noctule {
namespace {

constexpr double kSoundSpeed_mm_per_s = 345e3, kNoise_counts = 8;

/// Cramer-Rao bound of one pulse's delay in white noise, its amplitude and phase unknown and the board still:
///     var = N0 / (2 E beta^2),  E = int |e|^2/2 dt,  beta^2 = int |e'|^2 / int |e|^2 - |int conj(e) e' / int
///     |e|^2|^2
/// with e the pulse's complex envelope and N0 the one-sided noise density. The phase known, beta^2 gains
/// the square of the carrier's angular frequency.
double boundOfEnvelope_s(const PulseTrain& train, const PulseShape& shape, double amplitude) {
    const PulseModel pulse(train, shape.resonance_hz, shape.q);
    constexpr double kStep_s = 1e-6;
    double energy = 0, slope = 0;
    std::complex<double> mixed = 0;
    for (double u = kStep_s / 2; u < 5e-3; u += kStep_s) {
        const auto e = pulse.envelope(u),
                   change = (pulse.envelope(u + 1e-8) - pulse.envelope(u - 1e-8)) / 2e-8;
        energy += std::norm(e) * kStep_s;
        slope += std::norm(change) * kStep_s;
        mixed += std::conj(e) * change * kStep_s;
    }
    const double beta2 = slope / energy - std::norm(mixed / energy);
    const double density = kNoise_counts * kNoise_counts / 5000;
    return std::sqrt(density / (amplitude * amplitude * energy * beta2));
}

struct Errors {
    double envelope_mm = 0, carrier_mm = 0;          // rms; carrier: of those with the right cycle
    double envelope_sigmas = 0, carrier_sigmas = 0;  // rms of error over stated sigma
    double snr = 0;
    int count = 0, missed = 0, wrong_cycles = 0;
};

/// What is heard in one window of 32 boards, each with one pulse at a place of its own.
struct Scene {
    PulseShape shape{40000, 25};
    double amplitude = 1500, stretch = 0;
    int windows = 20;
    std::function<void(SyntheticSound&, int board, double sample)> more{};
};

Errors errorsOf(const Scene& scene, PulseShape assumed) {
    constexpr int kBoards = 32;
    const PulseTrain train;
    auto detector = std::move(makeDetector(Detector::kMatched, train, {assumed}).value());
    const double to_mm = kSoundSpeed_mm_per_s / train.sample_rate_hz,
                 cycle = train.sample_rate_hz / train.drive_hz;
    Errors errors;
    for (int window = 0; window < scene.windows; ++window) {
        SyntheticSound sound(train, kBoards, detector->windowSamples(), 77 + window);
        sound.addNoise(kNoise_counts);
        std::vector<double> delays(kBoards);
        for (int board = 0; board < kBoards; ++board) {
            delays[board] = std::uniform_real_distribution<double>(60, 900)(sound.random());
            const double at = detector->marginSamples() + delays[board];
            sound.addPulse(board, at, scene.amplitude, scene.shape.resonance_hz, scene.shape.q,
                           scene.stretch);
            if (scene.more)
                scene.more(sound, board, at);
        }
        std::vector<PulseArrival> arrivals(kBoards);
        // Seconds apart: the detector knows nothing of how the boards moved.
        detector->detect(sound.counts(), arrivals, {window, window * 1000000, 0});
        for (int board = 0; board < kBoards; ++board) {
            const PulseArrival& heard = arrivals[board];
            if (!heard.carrier) {
                ++errors.missed;
                continue;
            }
            ++errors.count;
            const double envelope = heard.sample - delays[board],
                         carrier = heard.carrier->sample - delays[board];
            errors.snr += std::sqrt(heard.peak_power / heard.noise_power);
            errors.envelope_mm += envelope * envelope;
            errors.envelope_sigmas += std::pow(envelope / heard.carrier->envelope_sigma_samples, 2);
            if (std::abs(carrier) > cycle / 2) {
                ++errors.wrong_cycles;
                continue;
            }
            errors.carrier_mm += carrier * carrier;
            errors.carrier_sigmas += std::pow(carrier / heard.carrier->sigma_samples, 2);
        }
    }
    const int right = errors.count - errors.wrong_cycles;
    errors.envelope_mm = to_mm * std::sqrt(errors.envelope_mm / errors.count);
    errors.carrier_mm = to_mm * std::sqrt(errors.carrier_mm / right);
    errors.envelope_sigmas = std::sqrt(errors.envelope_sigmas / errors.count);
    errors.carrier_sigmas = std::sqrt(errors.carrier_sigmas / right);
    errors.snr /= errors.count;
    return errors;
}

Errors errorsOf(const Scene& scene) {
    return errorsOf(scene, scene.shape);
}

void print(const char* what, const Errors& e) {
    std::printf(
        "%s: %d heard, %d missed, snr %.0f, envelope %.3f mm (%.2f sigmas), carrier %.4f mm (%.2f), wrong "
        "%d\n",
        what, e.count, e.missed, e.snr, e.envelope_mm, e.envelope_sigmas, e.carrier_mm, e.carrier_sigmas,
        e.wrong_cycles);
}

TEST(Matched, EnvelopeIsNearItsCramerRaoBound) {
    for (const PulseShape& shape : {PulseShape{39600, 15}, PulseShape{40000, 25}, PulseShape{40600, 35}})
        for (const double amplitude : {6000.0, 1500.0, 500.0}) {
            const Errors errors = errorsOf({shape, amplitude});
            const double bound_mm = kSoundSpeed_mm_per_s * boundOfEnvelope_s(PulseTrain{}, shape, amplitude);
            print("single path", errors);
            std::printf("    Q %.0f, %.0f counts: %.2f times the bound of %.3f mm\n", shape.q, amplitude,
                        errors.envelope_mm / bound_mm, bound_mm);
            EXPECT_EQ(errors.missed, 0);
            EXPECT_LT(errors.envelope_mm, 1.2 * bound_mm);
            EXPECT_GT(errors.envelope_mm, 0.9 * bound_mm);
            EXPECT_NEAR(errors.envelope_sigmas, 1, 0.15);
        }
}

TEST(Matched, CarrierOfASinglePathFrom30Decibels) {
    // 30 dB: amplitude over the noise's rms between 37.5 and 42.5 kHz, both as rms: snr() of 32
    int count = 0, wrong = 0;
    for (const double amplitude : {600.0, 1000.0, 2000.0, 6000.0}) {
        const Errors errors = errorsOf({.amplitude = amplitude, .windows = 40});
        print("carrier", errors);
        EXPECT_GT(errors.snr, 31);
        EXPECT_LT(errors.carrier_mm, 0.1);
        EXPECT_NEAR(errors.carrier_sigmas, 1, 0.15);
        count += errors.count;
        wrong += errors.wrong_cycles;
    }
    EXPECT_LE(wrong, count / 1000);
}

TEST(Matched, DopplerOfAMovingLimb) {
    for (const double speed_m_per_s : {-5.0, 2.0, 5.0}) {
        const Errors errors = errorsOf({.amplitude = 3000, .stretch = speed_m_per_s / 345});
        print("moving", errors);
        EXPECT_LT(errors.carrier_mm, 0.15);
        EXPECT_LT(errors.envelope_mm, 1);
        EXPECT_EQ(errors.wrong_cycles, 0);
    }
}

}  // namespace
}  // namespace noctule
