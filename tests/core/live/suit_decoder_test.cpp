// SPDX-License-Identifier: Apache-2.0
// The sound that somebody else made after the specification, against what its boards sent and how far apart
// they were.
#include "core/live/suit_decoder.h"

#include <cmath>
#include <cstdio>
#include <map>

#include "tests/core/live/worn_tiny_take.h"

namespace noctule {
namespace {

using test::goldenTable;
using test::WornTinyTake;

class TinyTakeDecoded : public testing::Test {
protected:
    static void SetUpTestSuite() {
        const WornTinyTake worn = test::wornTinyTake();
        auto decoder = std::move(SuitDecoder::create(worn.suit, worn.calibration, {worn.train}).value());
        for (const TemperatureStatus& status : worn.statuses)
            decoder->pushStatus(status);
        for (const Pulse& pulse : worn.pulses)
            decoder->pushPulse(pulse);
        constexpr int64_t kBlock = 6000;
        for (int64_t first = 0; first < worn.sampleCount(); first += kBlock)
            decoder->pushBlock(first, worn.samples(first, std::min(first + kBlock, worn.sampleCount())));
        decoder->finish();
        readings_ = decoder->takeReadings();
        ranges_ = decoder->takeRanges();
        for (const StreamReport& report : decoder->streamReports())
            frames_damaged_ += report.frames_damaged;
    }

    static inline std::vector<InertialReading> readings_;
    static inline std::vector<RangeMeasurement> ranges_;
    static inline int64_t frames_damaged_ = 0;
};

TEST_F(TinyTakeDecoded, ReadingsAreWhatTheBoardsSent) {
    std::map<std::pair<int, int64_t>, InertialReading> decoded;
    for (const InertialReading& reading : readings_)
        EXPECT_TRUE(decoded.emplace(std::pair(reading.board, reading.frame), reading).second);
    EXPECT_EQ(frames_damaged_, 0);

    // An axis is refreshed once in 120 frames: until then a receiver cannot know it.
    constexpr size_t kColumnOfCounts = 4;
    std::map<std::pair<int, size_t>, bool> refreshed;
    int compared = 0;
    const auto sent_rows = goldenTable("tiny_take_readings.csv");
    ASSERT_EQ(sent_rows.size(), 563u);
    for (const auto& row : sent_rows) {
        const int board = std::stoi(row[0]);
        const int64_t frame = std::stoll(row[1]);
        const auto found = decoded.find({board, frame});
        if (found == decoded.end())
            continue;
        const InertialReading& reading = found->second;
        EXPECT_NEAR(reading.sample, std::stod(row[3]), 0.1) << "board " << board << " frame " << frame;
        EXPECT_EQ(reading.corrected_bits, 0);
        for (size_t axis = 0; axis < 6; ++axis) {
            const std::string& sent = row[kColumnOfCounts + axis];
            bool& known = refreshed[{board, axis}];
            known = known || reading.counts[axis].has_value();
            if (!known)
                continue;
            EXPECT_EQ(reading.counts[axis].has_value(), !sent.empty())
                << board << " " << frame << " " << axis;
            if (reading.counts[axis] && !sent.empty()) {
                EXPECT_EQ(*reading.counts[axis], std::stoi(sent)) << board << " " << frame << " " << axis;
                ++compared;
            }
        }
    }
    for (int board = 0; board < 2; ++board)
        for (size_t axis = 0; axis < 6; ++axis)
            EXPECT_TRUE((refreshed[{board, axis}])) << board << " " << axis;
    EXPECT_GT(compared, 2000);
}

struct PairErrors {
    std::vector<double> error_m, confidence;
    static double mean(const std::vector<double>& values) {
        double sum = 0;
        for (double value : values)
            sum += value;
        return sum / static_cast<double>(values.size());
    }
    double deviation_m() const {
        const double middle = mean(error_m);
        double squares = 0;
        for (double error : error_m)
            squares += (error - middle) * (error - middle);
        return std::sqrt(squares / static_cast<double>(error_m.size()));
    }
};

TEST_F(TinyTakeDecoded, RangesAreTrueWhereThereIsLineOfSight) {
    std::map<std::pair<int64_t, int>, RangeMeasurement> measured;
    for (const RangeMeasurement& range : ranges_)
        EXPECT_TRUE(measured.emplace(std::pair(range.pulse, range.board), range).second);
    PairErrors clear, occluded;
    int64_t clear_sent = 0;
    for (const auto& row : goldenTable("tiny_take_ranges.csv")) {
        const bool is_occluded = row[5] == "1", is_clear = !is_occluded && row[6] == "0";
        clear_sent += is_clear;
        const auto found = measured.find({std::stoll(row[0]), std::stoi(row[3])});
        if (found == measured.end())
            continue;
        const RangeMeasurement& range = found->second;
        EXPECT_EQ(range.pulse_sample, std::stoll(row[1]));
        EXPECT_EQ(range.source, std::stoi(row[2]));
        if (is_clear || is_occluded) {
            PairErrors& pair = is_clear ? clear : occluded;
            pair.error_m.push_back(range.distance_m - std::stod(row[4]));
            pair.confidence.push_back(range.confidence());
        }
    }
    // The filters look a millisecond beyond a pulse's window, and after the last one the take ends.
    EXPECT_EQ(std::ssize(clear.error_m), clear_sent - 1);
    EXPECT_LT(std::abs(PairErrors::mean(clear.error_m)), 0.0005);
    EXPECT_LT(clear.deviation_m(), 0.0015);
    EXPECT_GT(PairErrors::mean(clear.confidence), 0.95);
    ASSERT_FALSE(occluded.confidence.empty());
    EXPECT_LT(PairErrors::mean(occluded.confidence), 0.5);
    std::printf("clear: mean %.2f mm, deviation %.2f mm; occluded: mean confidence %.2f, %zu heard\n",
                1e3 * PairErrors::mean(clear.error_m), 1e3 * clear.deviation_m(),
                PairErrors::mean(occluded.confidence), occluded.confidence.size());
}

TEST(SuitDecoder, NothingComesFromBeforeTheWatermark) {
    const WornTinyTake worn = test::wornTinyTake();
    auto decoder = std::move(SuitDecoder::create(worn.suit, worn.calibration, {worn.train}).value());
    for (const Pulse& pulse : worn.pulses)
        decoder->pushPulse(pulse);
    constexpr int64_t kHop = 300, kLateFramesOfALock = 4;
    std::vector<int64_t> late(worn.suit.boards.size());
    int64_t promised = 0, readings = 0, ranges = 0;
    for (int64_t first = 0; first < worn.sampleCount(); first += kHop) {
        decoder->pushBlock(first, worn.samples(first, std::min(first + kHop, worn.sampleCount())));
        for (const InertialReading& reading : decoder->takeReadings()) {
            late[static_cast<size_t>(reading.board)] += reading.sample < static_cast<double>(promised);
            ++readings;
        }
        for (const RangeMeasurement& range : decoder->takeRanges()) {
            EXPECT_GE(range.pulse_sample, promised);
            ++ranges;
        }
        EXPECT_GE(decoder->watermark(), promised);
        promised = decoder->watermark();
    }
    for (int64_t count : late)
        EXPECT_LE(count, kLateFramesOfALock);
    EXPECT_GT(readings, 400);
    EXPECT_GT(ranges, 100);
    EXPECT_GT(promised, worn.sampleCount() - 3000) << "the price is 20 ms at most";
}

TEST(SuitDecoder, RefusesARateThatNoBoardCanBeReceivedAt) {
    WornTinyTake worn = test::wornTinyTake();
    worn.train.sample_rate_hz = 8000;
    const auto refused = SuitDecoder::create(worn.suit, worn.calibration, {worn.train});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(refused.error().text().find("8000 Hz"), std::string::npos);
}

}  // namespace
}  // namespace noctule
