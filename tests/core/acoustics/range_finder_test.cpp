// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/range_finder.h"

#include <gtest/gtest.h>

#include "tests/core/acoustics/synthetic_sound.h"

namespace noctule {
namespace {

constexpr double kOffset_s = 1.4e-4;
constexpr double kSound_m_per_s = 345;

SourceCalibration calibrated(const std::string& id, const std::map<std::string, double>& offsets_s,
                             std::optional<double> resonance_hz = {}, std::optional<double> q = {}) {
    SourceCalibration source;
    source.id = id;
    source.offsets_s = offsets_s;
    source.resonance_hz = resonance_hz;
    source.q = q;
    return source;
}

class RangeFinderTest : public testing::Test {
protected:
    RangeFinderTest() {
        suit.boards.resize(2);
        suit.boards[0].id = "head";
        suit.boards[1].id = "l_hand";
        suit.sources.resize(2);
        suit.sources[0].id = "chest";
        suit.sources[1].id = "hat";
        calibration.sound = {SoundModel::Kind::kFixed, kSound_m_per_s, 1};
        calibration.sources = {calibrated("hat", {{"inflection", 2 * kOffset_s}}),
                               calibrated("chest", {{"inflection", kOffset_s}})};
        calibration.boards.resize(1);
        calibration.boards[0].id = "l_hand";
        calibration.boards[0].mic_delay_s = 1e-6;
    }

    RangeFinder make() const {
        return std::move(RangeFinder::create(suit, calibration, train, Detector::kInflection).value());
    }

    /// What source 0 at this distance gives at board 0 in round `round`.
    PulseDetection heard(double distance_m, double strength = 1e6, int round = 0) const {
        PulseDetection detection;
        detection.pulse = {7 + round, 1200 + 9600 * round, 0};
        const double flight_s = distance_m / kSound_m_per_s + kOffset_s;
        detection.arrival_sample = double(detection.pulse.sample) + flight_s * train.sample_rate_hz;
        detection.peak_power = strength / (distance_m * distance_m);
        detection.noise_power = 0.01;
        return detection;
    }

    const PulseTrain train{};
    Suit suit;
    Calibration calibration;
};

TEST_F(RangeFinderTest, DistanceAfterTheSpecification) {
    RangeFinder finder = make();
    auto range = finder.process(heard(0.8));
    ASSERT_TRUE(range);
    EXPECT_EQ(range->pulse, 7);
    EXPECT_EQ(range->pulse_sample, 1200);
    EXPECT_NEAR(range->distance_m, 0.8, 1e-9);
    EXPECT_EQ(range->confidence(), 1);
    EXPECT_TRUE(finder.problems().empty());

    PulseDetection at_hand = heard(0.8);
    at_hand.board = 1;
    EXPECT_NEAR(finder.process(at_hand)->distance_m, 0.8 - 1e-6 * kSound_m_per_s, 1e-9);
    PulseDetection from_hat = heard(0.8);
    from_hat.pulse.source = 1;
    EXPECT_NEAR(finder.process(from_hat)->distance_m, 0.8 - kOffset_s * kSound_m_per_s, 1e-9);
}

TEST_F(RangeFinderTest, UsesTheTemperature) {
    calibration.sound = {};
    RangeFinder finder = make();
    EXPECT_TRUE(finder.soundSpeed().temperatureAssumed());
    finder.soundSpeed().add({0, 28.0, 40.0});
    EXPECT_NEAR(finder.process(heard(0.8))->distance_m, 0.8 * speedOfSoundCramer(28, 40) / kSound_m_per_s,
                1e-9);
}

TEST_F(RangeFinderTest, NoRangeWhereThereIsNone) {
    RangeFinder finder = make();
    EXPECT_FALSE(finder.process(heard(0.02)));
    EXPECT_FALSE(finder.process(heard(2.8)));
    EXPECT_TRUE(finder.process(heard(0.04)));
    PulseDetection detection = heard(1);
    detection.gap = true;
    EXPECT_FALSE(finder.process(detection));
    detection = heard(1);
    detection.clipped = true;
    EXPECT_FALSE(finder.process(detection));
    detection = heard(1);
    detection.noise_power = detection.peak_power / 50;
    EXPECT_FALSE(finder.process(detection));
    for (const int wrong : {-1, 2}) {
        detection = heard(1);
        detection.board = wrong;
        EXPECT_FALSE(finder.process(detection));
        detection = heard(1);
        detection.pulse.source = wrong;
        EXPECT_FALSE(finder.process(detection));
    }
}

TEST_F(RangeFinderTest, StrengthIsJudgedAtUnitDistance) {
    const RangeSettings settings;
    RangeFinder finder = make();
    for (const double distance_m : {0.3, 1.0, 2.0}) {
        EXPECT_EQ(finder.process(heard(distance_m, settings.full_strength * 1.001))->w_s, 1);
        EXPECT_NEAR(finder.process(heard(distance_m, settings.full_strength * 0.999))->w_s, 1, 1e-4);
        EXPECT_NEAR(finder.process(heard(distance_m, settings.full_strength * std::pow(10, -0.3)))->w_s, 0.5,
                    1e-9);
        // around the body: 15 dB
        EXPECT_NEAR(finder.process(heard(distance_m, settings.full_strength * std::pow(10, -1.5)))->w_s,
                    1 / 26.0, 1e-9);
    }
}

TEST_F(RangeFinderTest, ContinuityComparesWithTheSamePairsLastRange) {
    RangeFinder finder = make();
    const double plausible_m = 5 * 0.064;
    EXPECT_EQ(finder.process(heard(0.5, 1e6, 0))->w_t, 1);
    EXPECT_EQ(finder.process(heard(0.5 + 0.99 * plausible_m, 1e6, 1))->w_t, 1);
    EXPECT_NEAR(finder.process(heard(0.5 + 2.49 * plausible_m, 1e6, 2))->w_t, 0.5, 1e-9);
    EXPECT_EQ(finder.process(heard(0.5, 1e6, 3))->w_t, 0);
    EXPECT_EQ(finder.process(heard(0.5, 1e6, 4))->w_t, 1);
    // two rounds later twice as much is plausible; another pair has its own history; a long pause ends it
    EXPECT_EQ(finder.process(heard(0.5 + 1.9 * plausible_m, 1e6, 6))->w_t, 1);
    PulseDetection other = heard(2.5, 1e6, 7);
    other.board = 1;
    EXPECT_EQ(finder.process(other)->w_t, 1);
    EXPECT_EQ(finder.process(heard(2.5, 1e6, 11))->w_t, 1);
}

TEST_F(RangeFinderTest, SigmaGrowsWithNoise) {
    RangeFinder finder = make();
    PulseDetection detection = heard(1);
    const double quiet = finder.process(detection)->sigma_m;
    EXPECT_LT(quiet, 1e-4);  // the scatter of sampling
    EXPECT_GT(quiet, 3e-5);
    detection.noise_power = detection.peak_power / 400;
    EXPECT_NEAR(finder.process(detection)->sigma_m, 1.55e-4 / 20 * kSound_m_per_s, 1e-5);
}

TEST_F(RangeFinderTest, MakesAnOffsetFromTheModelOrNamesTheSource) {
    calibration.sources[0] = calibrated("hat", {{"start", 1.5e-5}}, 39800, 22);
    calibration.sources[1] = calibrated("chest", {{"start", 1.5e-5}, {"matched", 1e-4}});
    RangeFinder finder = make();
    ASSERT_EQ(finder.problems().size(), 1u);
    EXPECT_EQ(finder.problems()[0].source, 0);
    EXPECT_NE(finder.problems()[0].reason.find("chest"), std::string::npos);
    EXPECT_NE(finder.problems()[0].reason.find("inflection"), std::string::npos);
    EXPECT_FALSE(finder.process(heard(0.8)));

    const auto detector = std::move(makeDetector(Detector::kInflection, train).value());
    const double delay_s = detectorResponse(*detector, train, 39800, 22).delay_s;
    PulseDetection from_hat = heard(0.8);
    from_hat.pulse.source = 1;
    EXPECT_NEAR(finder.process(from_hat)->distance_m, 0.8 + (kOffset_s - 1.5e-5 - delay_s) * kSound_m_per_s,
                1e-9);

    calibration.sources.clear();
    EXPECT_EQ(make().problems().size(), 2u);
}

TEST_F(RangeFinderTest, TheMatchedDetectorTakesTheStartFromWhateverIsKnown) {
    const auto inflection = std::move(makeDetector(Detector::kInflection, train).value());
    const double delay_s = detectorResponse(*inflection, train, 39800, 22).delay_s;
    const auto distanceWith = [&](const SourceCalibration& chest) -> std::optional<double> {
        calibration.sources = {calibrated("hat", {}), chest};
        auto finder = std::move(RangeFinder::create(suit, calibration, train, Detector::kMatched).value());
        PulseDetection detection = heard(0.8);
        const auto range = finder.process(detection);
        return range ? std::optional(range->distance_m) : std::nullopt;
    };
    const double expected_m = 0.8 + (kOffset_s - 1.5e-5) * kSound_m_per_s;
    for (const auto& [detector, offset_s] : std::map<std::string, double>{
             {"matched", 1.5e-5}, {"start", 1.5e-5}, {"inflection", 1.5e-5 + delay_s}}) {
        const auto distance_m = distanceWith(calibrated("chest", {{detector, offset_s}}, 39800, 22));
        ASSERT_TRUE(distance_m) << detector;
        EXPECT_NEAR(*distance_m, expected_m, 1e-9) << detector;
    }
    EXPECT_FALSE(distanceWith(calibrated("chest", {{"matched", 1.5e-5}}))) << "its pulse is not known";
    const auto finder = std::move(RangeFinder::create(suit, calibration, train, Detector::kMatched).value());
    ASSERT_EQ(finder.problems().size(), 2u);
    EXPECT_NE(finder.problems()[1].reason.find("shape"), std::string::npos);
}

TEST_F(RangeFinderTest, ACarrierCountsWhereTheEnvelopeNamesItsCycle) {
    RangeFinder finder = make();
    PulseDetection detection = heard(0.8);
    detection.carrier = CarrierArrival{detection.arrival_sample - 0.5, 0.02, 3.75, 0.3};
    const auto sure = finder.process(detection);
    const double m_per_sample = kSound_m_per_s / train.sample_rate_hz;
    EXPECT_NEAR(sure->distance_m, 0.8 - 0.5 * m_per_sample, 1e-9);
    EXPECT_NEAR(sure->sigma_m, 0.02 * m_per_sample, 1e-9);
    EXPECT_NEAR(sure->carrier.cycle_m, 3.75 * m_per_sample, 1e-9);
    detection.carrier->envelope_sigma_samples = 1;
    const auto unsure = finder.process(detection);
    EXPECT_NEAR(unsure->distance_m, 0.8, 1e-9);
    EXPECT_NEAR(unsure->sigma_m, m_per_sample, 1e-9);
    EXPECT_NEAR(unsure->carrier.distance_m, sure->distance_m, 1e-9);
}

TEST_F(RangeFinderTest, OccludedPulsesCountLittleAndNoiseAlonePassesNever) {
    // Board 0 hears source 0 directly, board 1 only around the body: 30 dB down and 60 mm late. Source 1 is
    // mute.
    constexpr int kManyPulses = 100;
    constexpr double kDistance_m = 0.5, kDetour_m = 0.06;
    calibration.sources[1] = calibrated("chest", {{"start", 0.0}}, 40000, 25);
    SyntheticSound sound(train, 2, 1200 * (kManyPulses + 2), 21);
    sound.addNoise(8);
    auto receiver = std::move(PulseReceiver::create(Detector::kInflection, train, 2).value());
    const double samples_per_m = train.sample_rate_hz / kSound_m_per_s;
    for (int i = 0; i < kManyPulses; ++i) {
        const Pulse pulse{i, 1200 * (i + 1), i % 2};
        receiver.pushPulse(pulse);
        if (pulse.source == 1)
            continue;
        const double direct = double(pulse.sample) + kDistance_m * samples_per_m;
        sound.addPulse(0, direct, 1500 / kDistance_m);
        sound.addPulse(1, direct + (kDetour_m + 1e-6 * kSound_m_per_s) * samples_per_m,
                       1500 / kDistance_m * 0.0316);
    }
    std::vector<PulseDetection> detections;
    receiver.pushBlock(0, sound.counts());
    receiver.finish(detections);
    RangeFinder finder = make();
    int direct = 0, occluded = 0;
    for (const PulseDetection& detection : detections) {
        const auto range = finder.process(detection);
        if (!range)
            continue;
        ASSERT_EQ(range->source, 0) << "noise became a range of " << range->distance_m << " m";
        if (range->board == 0) {
            ++direct;
            EXPECT_EQ(range->confidence(), 1);
            EXPECT_NEAR(range->distance_m, kDistance_m, 5 * range->sigma_m);
        } else {
            ++occluded;
            EXPECT_LT(range->w_s, 0.1);
        }
    }
    EXPECT_EQ(direct, kManyPulses / 2);
    EXPECT_LE(occluded, kManyPulses / 2);
}

}  // namespace
}  // namespace noctule
