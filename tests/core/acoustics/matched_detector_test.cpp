// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>

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
    const PulseTrain train{};
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

TEST(MatchedDetector, RefusesBurstsThatItCannotSeeWhole) {
    PulseTrain train;
    train.cycles = 18;
    EXPECT_TRUE(makeDetector(Detector::kMatched, train, {}));
    for (const int cycles : {19, 24, 400, 1'000'000}) {
        train.cycles = cycles;
        const auto refused = makeDetector(Detector::kMatched, train, {});
        ASSERT_FALSE(refused) << cycles;
        EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
        EXPECT_TRUE(makeDetector(Detector::kInflection, train, {})) << cycles;
    }
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
            EXPECT_NEAR(errors.envelope_sigmas, 1, 0.2);
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

TEST(Matched, AnEchoCloseBehindPullsLittle) {
    // 0.35 of the amplitude, 0.13 to 0.5 ms late: within the pulse. One path alone is pulled by millimetres.
    for (const double late : {20.0, 40.0, 75.0}) {
        Scene scene{.amplitude = 4000};
        scene.more = [late](SyntheticSound& sound, int board, double sample) {
            sound.addPulse(board, sample + late + 0.117 * board, 1400);
        };
        const Errors errors = errorsOf(scene);
        print("echo", errors);
        EXPECT_LT(errors.envelope_mm, 1.5);
        EXPECT_LT(errors.carrier_mm, 0.25);
        EXPECT_LE(errors.wrong_cycles, errors.count / 100);
    }
}

TEST(Matched, ALouderEchoIsNotTheDirectPulse) {
    Scene scene{.amplitude = 800};
    scene.more = [](SyntheticSound& sound, int board, double sample) {
        sound.addPulse(board, sample + 150, 4000);
    };
    const Errors errors = errorsOf(scene);
    print("louder echo", errors);
    EXPECT_LT(errors.envelope_mm, 1.5);
    EXPECT_LE(errors.wrong_cycles, errors.count / 100);
}

TEST(Matched, SilenceNoiseAndClipping) {
    const PulseTrain train{};
    auto detector = std::move(makeDetector(Detector::kMatched, train, {PulseShape{40000, 25}}).value());
    SyntheticSound sound(train, 32, detector->windowSamples(), 3);
    sound.addPulse(0, detector->marginSamples() + 300, 90000);
    for (int board = 2; board < 32; ++board)
        sound.addNoise(kNoise_counts, board);
    std::vector<PulseArrival> arrivals(32);
    detector->detect(sound.counts(), arrivals);
    EXPECT_TRUE(arrivals[0].clipped);
    EXPECT_FALSE(arrivals[1].carrier);
    double noise = 0;
    for (size_t board = 2; board < 32; ++board) {
        EXPECT_FALSE(arrivals[board].clipped);
        EXPECT_FALSE(arrivals[board].carrier) << board;
        noise += arrivals[board].noise_power / 30;
    }
    EXPECT_NEAR(noise, kNoise_counts * kNoise_counts, 10);
    detector->detect(sound.counts(), arrivals, {1, 1200, 7});  // a source of which nothing is known
    EXPECT_FALSE(arrivals[0].carrier);
    EXPECT_EQ(arrivals[0].peak_power, 0);
}

TEST(Matched, ShapesAreLearntFromSoundWithEchoes) {
    constexpr int kBoards = 18;
    const PulseTrain train{};
    const std::vector<PulseShape> truth{{39650, 17}, {40000, 25}, {40450, 33}};
    PulseShapeLearner learner(train, 4);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> any(0, 1);
    for (int window = 0; window < 18; ++window) {
        SyntheticSound sound(train, kBoards, learner.windowSamples(), 900 + window);
        sound.addNoise(kNoise_counts);
        const size_t source = static_cast<size_t>(window) % truth.size();
        for (int board = 0; board < kBoards; ++board) {
            const double at = learner.marginSamples() + 100 + 700 * any(random);
            const auto add = [&](double sample, double amplitude) {
                sound.addPulse(board, sample, amplitude, truth[source].resonance_hz, truth[source].q);
            };
            const double amplitude = 1000 + 3000 * any(random);
            add(at, amplitude);
            const double later = 30 + 300 * any(random), share = 0.3 * any(random);
            add(at + later, share * amplitude);
        }
        std::vector<PulseArrival> unused(kBoards);
        learner.detect(sound.counts(), unused, {window, window * 1200, static_cast<int>(source)});
    }
    const PulseShapes learnt = learner.learn();
    ASSERT_EQ(learnt.size(), 4u);
    for (size_t s = 0; s < truth.size(); ++s) {
        ASSERT_TRUE(learnt[s]);
        std::printf("learnt %.0f Hz, Q %.2f for %.0f Hz, Q %.0f\n", learnt[s]->resonance_hz, learnt[s]->q,
                    truth[s].resonance_hz, truth[s].q);
        // Echoes bend it a little; what counts is what distances make of it.
        EXPECT_NEAR(learnt[s]->resonance_hz, truth[s].resonance_hz, 50);
        EXPECT_NEAR(learnt[s]->q / truth[s].q, 1, 0.08);
        const Errors errors = errorsOf({truth[s], 3000}, *learnt[s]);
        print("with the learnt pulse", errors);
        EXPECT_LT(errors.envelope_mm, 0.8);
        EXPECT_LT(errors.carrier_mm, 0.05);
        EXPECT_EQ(errors.wrong_cycles, 0);
    }
    EXPECT_FALSE(learnt[3]) << "it was never heard";
}

}  // namespace
}  // namespace noctule
