// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/pulse_receiver.h"

#include <gtest/gtest.h>

#include "tests/core/acoustics/synthetic_sound.h"

namespace noctule {
namespace {

constexpr int kBoards = 3, kPulses = 12;
constexpr int64_t kSamples = 1200 * (kPulses + 2);

PulseReceiver makeReceiver(int boards = kBoards) {
    return std::move(PulseReceiver::create(Detector::kInflection, PulseTrain{}, boards).value());
}

std::vector<Pulse> pulseLog() {
    std::vector<Pulse> pulses;
    for (int i = 0; i < kPulses; ++i)
        pulses.push_back({100 + i, 1200 * (i + 1), i % 2});
    return pulses;
}

/// Board b hears every pulse at 150 + 60 b samples after its emission.
std::vector<int16_t> makeSound() {
    SyntheticSound sound(PulseTrain{}, kBoards, kSamples, 9);
    sound.addNoise(8);
    for (const Pulse& pulse : pulseLog())
        for (int board = 0; board < kBoards; ++board)
            sound.addPulse(board, double(pulse.sample) + 150.3 + 60 * board, 2000);
    return sound.counts();
}

std::span<const int16_t> samples(const std::vector<int16_t>& sound, int64_t begin, int64_t end) {
    return std::span(sound).subspan(size_t(begin * kBoards), size_t((end - begin) * kBoards));
}

std::vector<PulseDetection> receiveAtOnce(PulseReceiver receiver, const std::vector<int16_t>& sound) {
    std::vector<PulseDetection> detections;
    for (const Pulse& pulse : pulseLog())
        EXPECT_TRUE(receiver.pushPulse(pulse));
    receiver.pushBlock(0, sound);
    receiver.finish(detections);
    return detections;
}

void expectSame(const std::vector<PulseDetection>& a, const std::vector<PulseDetection>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].pulse.id, b[i].pulse.id);
        EXPECT_EQ(a[i].board, b[i].board);
        EXPECT_EQ(a[i].gap, b[i].gap);
        EXPECT_EQ(a[i].arrival_sample, b[i].arrival_sample);
        EXPECT_EQ(a[i].peak_power, b[i].peak_power);
        EXPECT_EQ(a[i].noise_power, b[i].noise_power);
    }
}

TEST(PulseReceiver, HearsEveryPulseOnEveryBoard) {
    const auto detections = receiveAtOnce(makeReceiver(), makeSound());
    ASSERT_EQ(detections.size(), size_t(kPulses * kBoards));
    for (size_t i = 0; i < detections.size(); ++i) {
        const PulseDetection& detection = detections[i];
        EXPECT_EQ(detection.pulse.id, 100 + int64_t(i / kBoards));
        EXPECT_EQ(detection.board, int(i % kBoards));
        EXPECT_FALSE(detection.gap);
        EXPECT_NEAR(detection.arrival_sample,
                    double(detection.pulse.sample) + 150.3 + 60 * detection.board + 19.3, 2);
        EXPECT_GT(detection.snr(), 60);
    }
}

TEST(PulseReceiver, EverySplitGivesTheSame) {
    const auto sound = makeSound();
    const auto expected = receiveAtOnce(makeReceiver(), sound);
    std::mt19937 random(3);
    for (int trial = 0; trial < 10; ++trial) {
        PulseReceiver receiver = makeReceiver();
        const auto pulses = pulseLog();
        // The log runs up to 3000 samples ahead of the sound or behind it; advance() waits for both.
        const int64_t lead = int64_t(random() % 6000) - 3000;
        std::vector<PulseDetection> detections;
        size_t next = 0;
        for (int64_t begin = 0, end; begin < kSamples; begin = end) {
            end = std::min<int64_t>(kSamples, begin + 1 + int64_t(random() % (trial < 5 ? 50 : 4000)));
            receiver.pushBlock(begin, samples(sound, begin, end));
            for (; next < pulses.size() && pulses[next].sample < end + lead; ++next)
                EXPECT_TRUE(receiver.pushPulse(pulses[next]));
            receiver.advance(std::min(end, end + lead), detections);
        }
        for (; next < pulses.size(); ++next)
            EXPECT_TRUE(receiver.pushPulse(pulses[next]));
        receiver.finish(detections);
        expectSame(detections, expected);
    }
}

TEST(PulseReceiver, MissingSamplesOfABoardSilenceOnlyItsOwnWindows) {
    const auto sound = makeSound();
    PulseReceiver receiver = makeReceiver();
    receiver.markMissing(2700, 10, 1);     // inside the second pulse's
    receiver.markMissing(2700, 10, 77);    // no such board
    receiver.markMissing(1 << 20, -5, 0);  // nonsense
    const auto detections = receiveAtOnce(std::move(receiver), sound);
    for (const PulseDetection& detection : detections)
        EXPECT_EQ(detection.gap, detection.pulse.sample == 2400 && detection.board == 1)
            << detection.pulse.sample << " " << detection.board;
}

TEST(PulseReceiver, AHoleBetweenBlocksSilencesAllBoards) {
    const auto sound = makeSound();
    PulseReceiver receiver = makeReceiver();
    for (const Pulse& pulse : pulseLog())
        receiver.pushPulse(pulse);
    receiver.pushBlock(0, samples(sound, 0, 5000));
    receiver.pushBlock(5100, samples(sound, 5100, kSamples - 1200));
    std::vector<PulseDetection> detections;
    receiver.finish(detections);
    const auto whole = receiveAtOnce(makeReceiver(), sound);
    ASSERT_EQ(detections.size(), whole.size());
    for (size_t i = 0; i < whole.size(); ++i) {
        const int64_t pulse = detections[i].pulse.sample;
        // 5000..5100 touches the pulse at 4800 and the one before it no more; the last one lacks its end
        EXPECT_EQ(detections[i].gap, pulse == 4800 || pulse == 1200 * kPulses) << pulse;
        if (!detections[i].gap) {
            EXPECT_EQ(detections[i].arrival_sample, whole[i].arrival_sample);
        }
    }
}

TEST(PulseReceiver, RefusesPulsesThatComeTooLateOrMakeNoSense) {
    PulseReceiver receiver = makeReceiver();
    receiver.pushBlock(0, samples(makeSound(), 0, 6000));
    std::vector<PulseDetection> detections;
    receiver.advance(6000, detections);
    EXPECT_FALSE(receiver.pushPulse({1, 1200, 0}));
    EXPECT_FALSE(receiver.pushPulse({1, -1, 0}));
    EXPECT_FALSE(receiver.pushPulse({1, INT64_MAX, 0}));
    EXPECT_TRUE(receiver.pushPulse({2, 4800, 0}));
}

TEST(PulseReceiver, NoiseFollowsTheAmbientButNotOneLoudWindow) {
    NoiseFloor noise;
    for (int i = 0; i < 20; ++i)
        noise.push(i == 9 ? 1e6 : 50);
    EXPECT_EQ(noise.power(), 50);
    for (int i = 0; i < 16; ++i)
        noise.push(200);
    EXPECT_EQ(noise.power(), 200);
}

TEST(PulseReceiver, NeedsBoards) {
    for (const int boards : {0, -1, 33})
        EXPECT_FALSE(PulseReceiver::create(Detector::kInflection, PulseTrain{}, boards).ok()) << boards;
}

}  // namespace
}  // namespace noctule
