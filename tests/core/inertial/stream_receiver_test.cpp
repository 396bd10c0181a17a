// SPDX-License-Identifier: Apache-2.0
// From samples to readings: golden line, every split alike, holes, restarts, offsets, loud pulses, garbage.
#include "core/inertial/stream_receiver.h"

#include <numbers>

#include "tests/core/inertial/golden.h"
#include "tests/core/inertial/virtual_board.h"

namespace noctule {
namespace {

struct Received {
    std::vector<InertialReading> readings;
    StreamReport report;
};

Received receive(const std::vector<int16_t>& samples, int sample_rate_hz = 150000, bool imu9 = false) {
    StreamReceiver receiver(0, sample_rate_hz, imu9);
    receiver.push(0, samples);
    receiver.finish();
    return {receiver.takeReadings(), receiver.report()};
}

bool same(const InertialReading& a, const InertialReading& b) {
    return a.board == b.board && a.frame == b.frame && a.sample == b.sample && a.counts == b.counts &&
           a.magnetometer_counts == b.magnetometer_counts && a.corrected_bits == b.corrected_bits;
}

void expectSame(const std::vector<InertialReading>& a, const std::vector<InertialReading>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i)
        ASSERT_TRUE(same(a[i], b[i])) << "reading " << i << ", frame " << a[i].frame;
}

/// Every present count is what the board sent; returns how many frames were lost.
int expectTruth(const Received& received, const VirtualBoard& board) {
    int lost = 0;
    for (const InertialReading& reading : received.readings) {
        lost += !reading.corrected_bits;
        for (int axis = 0; axis < 6; ++axis)
            if (reading.counts[axis]) {
                EXPECT_EQ(*reading.counts[axis], board.sent.at(reading.frame)[axis])
                    << "frame " << reading.frame << " axis " << axis;
            }
        const double frame_start =
            static_cast<double>(board.s0) +
            static_cast<double>(board.firstFrame() + reading.frame) * board.sample_rate_hz / 140;
        EXPECT_NEAR(reading.sample, frame_start, 1) << "frame " << reading.frame;
    }
    return lost;
}

TEST(LineShaper, MatchesTheGoldenLineInAnyPieces) {
    const auto rows = goldenRows("line_12frames.csv");
    const auto stream = goldenRows("stream_3s.csv");
    const auto frames = [&](int64_t frame) {
        return frame < 0 || frame >= 12 ? std::nullopt : std::optional(lineBits(stream[frame][26]));
    };
    LineShaper whole(150000, 137, 300, frames), pieces(150000, 137, 300, frames);
    std::vector<float> clean(rows.size(), 0.0f), again(rows.size(), 0.0f);
    whole.addTo(clean);
    for (size_t i = 0; i < again.size();) {
        const size_t count = std::min(again.size() - i, i % 41 + 1);
        pieces.addTo(std::span(again).subspan(i, count));
        i += count;
    }
    for (size_t i = 0; i < rows.size(); ++i)
        EXPECT_NEAR(clean[i], std::stod(rows[i][1]), 2) << "sample " << i;
    EXPECT_EQ(clean, again);
}

TEST(LineShaper, LeaksLittleIntoTheSound) {
    VirtualBoard board;
    board.noise_counts = 0;
    const std::vector<float> line = board.line(150000);
    double power = 0;  // sum of 1 s spectral lines in 37.5 .. 42.5 kHz, sampled every 50 Hz
    for (double f = 37500; f <= 42500; f += 50) {
        double re = 0, im = 0;
        for (size_t i = 0; i < line.size(); ++i) {
            const double turn = f * static_cast<double>(i) / 150000;
            const double window = 1 - std::cos(2 * std::numbers::pi * static_cast<double>(i) / 150000);
            re += window * line[i] * std::cos(2 * std::numbers::pi * (turn - std::floor(turn)));
            im += window * line[i] * std::sin(2 * std::numbers::pi * (turn - std::floor(turn)));
        }
        power += 50 * 2 * (re * re + im * im) / (150000.0 * 150000.0) / 1.5;
    }
    EXPECT_LT(std::sqrt(power), 1);
}

TEST(LineFilter, TakesThePulsesOutAndLetsTheStreamThrough) {
    for (int rate : {100000, 140000, 150000, 192000, 500000}) {
        const LineFilter filter(rate);
        std::vector<float> tone(4 * filter.reach() + 1);
        for (double f : {0.0, 3000.0, 37000.0, 38500.0, 40000.0, 41500.0, 43000.0}) {
            for (size_t i = 0; i < tone.size(); ++i)
                tone[i] = static_cast<float>(std::cos(2 * std::numbers::pi * f / rate *
                                                      (static_cast<double>(i) - 2 * filter.reach())));
            const double gain = std::abs(filter(&tone[2 * filter.reach()]));
            if (f < 4000) {
                EXPECT_NEAR(gain, f == 0 ? 1 : 0.93, 0.01) << rate << ' ' << f;
            } else {
                EXPECT_LT(gain, 3e-4) << rate << ' ' << f;  // -70 dB
            }
        }
    }
}

TEST(StreamReceiver, GoldenLine) {
    std::vector<int16_t> samples;
    for (const Row& row : goldenRows("line_12frames.csv"))
        samples.push_back(static_cast<int16_t>(std::stoi(row[2])));
    const Received received = receive(samples);
    const auto stream = goldenRows("stream_3s.csv");
    ASSERT_EQ(received.readings.size(), 12u);
    FrameDecoder decoder;
    for (int frame = 0; frame < 12; ++frame) {
        const InertialReading expected = decoder.decode(lineBits(stream[frame][26]), frame);
        EXPECT_EQ(received.readings[frame].counts, expected.counts);
        EXPECT_EQ(received.readings[frame].corrected_bits, 0);
        EXPECT_NEAR(received.readings[frame].sample, 137 + frame * 150000 / 140.0, 0.5);
    }
    EXPECT_NEAR(*received.report.amplitude_counts, 300, 9);
}

TEST(StreamReceiver, AnyRateAndPhase) {
    for (int rate : {100000, 140000, 150000, 153846, 192000, 250000})
        for (int64_t s0 : {0, 1, 500, -700, 1000}) {
            VirtualBoard board{.sample_rate_hz = rate, .s0 = s0};
            const Received received = receive(sampled(board.line(2 * rate)), rate);
            ASSERT_GE(received.readings.size(), 278u) << rate << ' ' << s0;
            EXPECT_EQ(received.readings.front().frame, 0) << rate << ' ' << s0;
            EXPECT_EQ(expectTruth(received, board), 0) << rate << ' ' << s0;
        }
}

TEST(StreamReceiver, NineAxes) {
    VirtualBoard board{.imu9 = true};
    const Received received = receive(sampled(board.line(300000)), 150000, true);
    EXPECT_EQ(expectTruth(received, board), 0);
    int magnetometer = 0;
    for (const InertialReading& reading : received.readings)
        magnetometer += reading.magnetometer_counts[1] == 2100;
    EXPECT_EQ(magnetometer, 14);
}

TEST(StreamReceiver, PhaseIsMeasuredToAFractionOfASample) {
    double sum_of_squares = 0, sum = 0;
    constexpr int kBoards = 100;
    for (int i = 0; i < kBoards; ++i) {
        VirtualBoard board{.s0 = 31 + 10 * i, .noise_counts = 40, .seed = 100u + i};
        board.first_counter = i;
        const Received received = receive(sampled(board.line(10000)));
        ASSERT_TRUE(received.report.phase_samples);
        const double error = *received.report.phase_samples - static_cast<double>(board.s0);
        EXPECT_LT(std::abs(error), 0.5);
        sum += error;
        sum_of_squares += error * error;
    }
    RecordProperty("phase_error_mean", std::to_string(sum / kBoards));
    RecordProperty("phase_error_rms", std::to_string(std::sqrt(sum_of_squares / kBoards)));
    EXPECT_LT(std::sqrt(sum_of_squares / kBoards), 0.1);
    EXPECT_NEAR(sum / kBoards, 0, 0.05);
}

TEST(StreamReceiver, EverySplitGivesTheSameReadings) {
    VirtualBoard board{.noise_counts = 60, .bit_error_rate = 0.01};
    const std::vector<int16_t> samples = sampled(board.line(450000));
    const int64_t hole_first = 210000, hole_count = 5000, marked_first = 300000, marked_count = 40;
    const auto run = [&](auto nextSize) {
        StreamReceiver receiver(3, 150000, false);
        receiver.markMissing(marked_first, marked_count);
        std::vector<InertialReading> readings;
        const auto pushRange = [&](int64_t first, int64_t end) {
            while (first < end) {
                const int64_t count = std::min<int64_t>(end - first, nextSize());
                receiver.push(first, std::span(samples).subspan(first, count));
                for (InertialReading& reading : receiver.takeReadings())
                    readings.push_back(reading);
                first += count;
            }
        };
        pushRange(0, hole_first);
        pushRange(hole_first + hole_count, static_cast<int64_t>(samples.size()));
        receiver.finish();
        for (InertialReading& reading : receiver.takeReadings())
            readings.push_back(reading);
        return readings;
    };
    const auto whole = run([] { return 1000000; });
    EXPECT_GT(whole.size(), 400u);
    EXPECT_EQ(whole.front().board, 3);
    expectSame(whole, run([] { return 1; }));
    std::mt19937 random(4);
    for (int split = 0; split < 5; ++split)
        expectSame(whole, run([&] { return 1 + static_cast<int>(random() % (split % 2 ? 30 : 20000)); }));
}

TEST(StreamReceiver, TakesItsColumnOfInterleavedBlocksAndSkipsWhatItKnows) {
    VirtualBoard board;
    const std::vector<int16_t> samples = sampled(board.line(60000));
    std::vector<int16_t> block;
    for (int16_t s : samples)
        block.insert(block.end(), {30000, s, -30000});
    StreamReceiver receiver(0, 150000, false);
    receiver.push(0, std::span(block).first(90000), 1, 3);
    receiver.push(20000, std::span(block).subspan(60000), 1, 3);  // 10 000 samples are known already
    receiver.push(5, std::span(block).subspan(15, 300), 1, 3);    // wholly old
    receiver.push(-5, std::span(block).first(30), 1, 3);
    receiver.finish();
    expectSame(receiver.takeReadings(), receive(samples).readings);
    EXPECT_THROW(receiver.push(60000, block, 1, 3), std::logic_error);
}

TEST(StreamReceiver, FramesWithMissingSamplesAreLostAndTheClockRunsOn) {
    VirtualBoard board;
    const std::vector<int16_t> samples = sampled(board.line(600000));
    StreamReceiver receiver(0, 150000, false);
    receiver.push(0, std::span(samples).first(200000));
    receiver.markMissing(450000, 1);
    receiver.push(290000, std::span(samples).subspan(290000));
    receiver.finish();
    const Received received{receiver.takeReadings(), receiver.report()};
    const int lost = expectTruth(received, board);
    EXPECT_EQ(received.readings.size(), static_cast<size_t>(received.report.frames_seen));
    for (size_t i = 0; i < received.readings.size(); ++i) {
        const InertialReading& reading = received.readings[i];
        ASSERT_EQ(reading.frame, static_cast<int64_t>(i));
        const double end = reading.sample + 150000 / 140.0;
        const bool hit =
            (reading.sample < 290000 && end > 200000) || (reading.sample < 450000 && end > 450000);
        EXPECT_EQ(reading.corrected_bits.has_value(), !hit) << "frame " << reading.frame;
    }
    EXPECT_EQ(received.report.frames_missing, lost);
    EXPECT_EQ(received.report.frames_damaged, 0);
    EXPECT_EQ(received.report.lock_losses, 0);
    // A frame carrying every axis was lost: each is silent until its own refresh, at most 120 frames.
    const auto after = static_cast<int64_t>(450000 / (150000 / 140.0)) + 1;
    int present = 0;
    for (int axis = 0; axis < 6; ++axis)
        present += received.readings[after].counts[axis].has_value();
    EXPECT_LE(present, 1);
    for (int axis = 0; axis < 6; ++axis)
        EXPECT_TRUE(received.readings[after + 121].counts[axis] ||
                    received.readings[after + 122].counts[axis]);
}

TEST(StreamReceiver, AHoleOfHoursEndsTheLockAndABlockFromNowhereIsIgnored) {
    VirtualBoard board;
    const std::vector<int16_t> samples = sampled(board.line(30000));
    StreamReceiver receiver(0, 150000, false);
    receiver.push(0, samples);
    receiver.push(int64_t{1} << 60, samples);
    receiver.push(int64_t{1} << 45, samples);
    receiver.finish();
    const auto readings = receiver.takeReadings();
    EXPECT_EQ(receiver.report().lock_losses, 1);
    EXPECT_GT(readings.size(), 50u);
    EXPECT_LT(readings.size(), 56u);
    EXPECT_NEAR(static_cast<double>(readings.back().frame), 0x1p45 / (150000 / 140.0), 30);
}

std::vector<int16_t> withRestart(int64_t restart, int64_t new_s0, int new_counter, int64_t count) {
    VirtualBoard before, after{.s0 = new_s0, .first_counter = new_counter, .seed = 2};
    std::vector<int16_t> samples = sampled(before.line(count)), later = sampled(after.line(count));
    std::copy(later.begin() + restart, later.end(), samples.begin() + restart);
    return samples;
}

TEST(StreamReceiver, FindsARestartedBoardAtAnotherPhase) {
    const Received received = receive(withRestart(300000, 612, 5, 900000));
    EXPECT_EQ(received.report.lock_losses, 1);
    EXPECT_NEAR(static_cast<double>(received.report.frames_damaged), 140, 1);
    EXPECT_NEAR(*received.report.phase_samples, 612, 1);
    int64_t last_frame = -1;
    for (const InertialReading& reading : received.readings) {
        EXPECT_GT(reading.frame, last_frame);
        EXPECT_EQ(reading.frame, static_cast<int64_t>((reading.sample + 0.5) / (150000 / 140.0)));
        last_frame = reading.frame;
    }
    EXPECT_EQ(last_frame, 838);
}

TEST(StreamReceiver, FindsARestartedBoardAtTheSamePhaseAfterEightFrames) {
    const Received received = receive(withRestart(300000, 137, 77, 600000));
    EXPECT_EQ(received.report.lock_losses, 1);
    EXPECT_NEAR(static_cast<double>(received.report.frames_damaged), 8, 1);
    EXPECT_GT(received.report.share_present, 0.5);
}

TEST(StreamReceiver, AnUnpluggedBoardIsLostAfterASecond) {
    VirtualBoard board;
    std::vector<float> line = board.line(150000);
    std::mt19937 random(9);
    std::normal_distribution<float> noise(0, 40);
    for (int i = 0; i < 450000; ++i)
        line.push_back(noise(random));
    const Received received = receive(sampled(line));
    EXPECT_EQ(received.report.lock_losses, 1);
    EXPECT_NEAR(static_cast<double>(received.report.frames_damaged), 140, 1);
    EXPECT_FALSE(received.report.phase_samples);
    EXPECT_TRUE(received.report.badSignal());
    EXPECT_LT(received.report.share_present, 0.25);
}

TEST(StreamReceiver, ToleratesOffsetAndSlowDrift) {
    for (double amplitude : {100.0, 300.0, 3000.0}) {
        VirtualBoard board{.amplitude_counts = amplitude, .noise_counts = amplitude / 10};
        std::vector<float> line = board.line(300000);
        for (size_t i = 0; i < line.size(); ++i)
            line[i] += static_cast<float>(
                amplitude / 2 * std::cos(2 * std::numbers::pi * 0.7 * static_cast<double>(i) / 150000));
        const Received received = receive(sampled(line));
        EXPECT_EQ(expectTruth(received, board), 0);
        EXPECT_GE(received.readings.size(), 279u);
        EXPECT_NEAR(*received.report.amplitude_counts, amplitude, 0.03 * amplitude);
    }
}

/// Ten cycles into a resonator of Q 30 every 8 ms, 15 000 counts at the top.
void addPulses(std::vector<float>& line) {
    constexpr double kTau = 30 / (std::numbers::pi * 40000);
    for (size_t start = 300; start < line.size(); start += 1200)
        for (size_t i = start; i < std::min(line.size(), start + 1200); ++i) {
            const double t = static_cast<double>(i - start) / 150000, drive = std::min(t, 10 / 40000.0);
            const double envelope = (1 - std::exp(-drive / kTau)) * std::exp(-(t - drive) / kTau);
            line[i] += static_cast<float>(15000 / (1 - std::exp(-10 / 40000.0 / kTau)) * envelope *
                                          std::sin(2 * std::numbers::pi * 40200 * t));
        }
}

TEST(StreamReceiver, ReadsUnderLoudPulses) {
    VirtualBoard board;
    std::vector<float> line = board.line(600000);
    addPulses(line);
    const Received received = receive(sampled(line));
    EXPECT_EQ(expectTruth(received, board), 0);
    EXPECT_GE(received.readings.size(), 559u);
    EXPECT_NEAR(received.readings.front().sample, 137, 1);
    EXPECT_LT(received.report.bits_corrected, 60);
}

TEST(StreamReceiver, GarbageYieldsNothing) {
    std::mt19937 random(8);
    std::vector<int16_t> noise(1500000);
    for (int16_t& s : noise)
        s = static_cast<int16_t>(random());
    EXPECT_TRUE(receive(noise).readings.empty());
    std::fill(noise.begin(), noise.end(), int16_t{-32768});
    EXPECT_TRUE(receive(noise).readings.empty());
    for (size_t i = 0; i < noise.size(); ++i)
        noise[i] = i / 11 % 3 ? 32767 : -32768;
    EXPECT_TRUE(receive(noise).readings.empty());
    EXPECT_TRUE(receive({}).readings.empty());
}

TEST(StreamReceiver, RefusesRatesItCannotServe) {
    EXPECT_FALSE(StreamReceiver::supports(48000));
    EXPECT_TRUE(StreamReceiver::supports(150000));
    EXPECT_THROW(StreamReceiver(0, 48000, false), std::logic_error);
}

}  // namespace
}  // namespace noctule
