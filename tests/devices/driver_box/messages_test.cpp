// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/messages.h"

#include <cmath>
#include <limits>

#include "tests/devices/driver_box/link_data.h"

namespace noctule::link {
namespace {

SoundBlock rampBlock(int64_t first_sample, int samples, int boards) {
    SoundBlock block{first_sample, boards, {}};
    for (int i = 0; i < samples * boards; ++i)
        block.values.push_back(static_cast<int16_t>(i * 7 - 300));
    return block;
}

template <class T>
void expectRoundTrip(const T& value, std::optional<T> (*read)(ByteView)) {
    const auto again = read(toPayload(value));
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, value);
}

TEST(Messages, WriteReadEqual) {
    expectRoundTrip(Ack{0xFFFFFFFF, Code::kNotNow, "schon unterwegs"}, readAck);
    expectRoundTrip(Ack{}, readAck);
    expectRoundTrip(std::vector<EmittedPulse>{}, readPulses);
    expectRoundTrip(std::vector<EmittedPulse>{{0, 0}, {1200, 31}, {kHighestSample, 65535}}, readPulses);
    expectRoundTrip(BoxStatus{}, readStatus);
    expectRoundTrip(BoxStatus{1234567890123, 21.5f, std::nullopt, 3.7f, 0.f, 4000000000u, {1, 0, 7, 0xFFFF}},
                    readStatus);
    expectRoundTrip(BoxError{Code::kBatteryLow, 77, "noch eine Minute: \xC3\x9C"}, readError);
    expectRoundTrip(BoxError{static_cast<Code>(9999), 0, ""}, readError);
    expectRoundTrip(Identify{3, 1500}, readIdentify);
    expectRoundTrip(Identify{kAllBoardsOff, 0}, readIdentify);
}

TEST(Messages, AdcBlocksOfBothFormats) {
    for (const AdcFormat format : {AdcFormat::kPlain, AdcFormat::kZstd})
        for (const SoundBlock& block :
             {rampBlock(0, 1, 1), rampBlock(123456, 600, 18), rampBlock(kHighestSample, 4096, 32)}) {
            const Bytes payload = toPayload(block, format);
            ASSERT_LE(payload.size(), kMaxPayloadBytes);
            const auto again = readSoundBlock(payload);
            ASSERT_TRUE(again);
            EXPECT_EQ(*again, block);
        }
    EXPECT_THROW(toPayload(rampBlock(0, 4097, 1)), std::logic_error);
    EXPECT_THROW(toPayload(rampBlock(0, 0, 1)), std::logic_error);
}

TEST(Messages, GoldenPayloads) {
    const auto adc = readSoundBlock(goldenFrame(Type::kAdc).payload());
    ASSERT_TRUE(adc);
    EXPECT_EQ(adc->first_sample, 0);
    EXPECT_EQ(adc->sampleCount(), 8);
    EXPECT_EQ(adc->values[0], -15000);
    EXPECT_EQ(toPayload(*adc), goldenFrame(Type::kAdc).payload());
    const auto pulses = readPulses(goldenFrame(Type::kPulses).payload());
    EXPECT_EQ(pulses, (std::vector<EmittedPulse>{{1200, 0}, {2400, 0}}));
    EXPECT_EQ(toPayload(*pulses), goldenFrame(Type::kPulses).payload());
    const auto status = readStatus(goldenFrame(Type::kStatus).payload());
    ASSERT_TRUE(status);
    EXPECT_EQ(status->sample, 16);
    EXPECT_EQ(status->temperature_c, 23.5f);
    EXPECT_FALSE(status->humidity_percent);
    EXPECT_EQ(status->battery_v, 3.97f);
    EXPECT_EQ(status->battery_percent, 81.f);
    EXPECT_EQ(status->board_flags,
              (std::vector<uint16_t>{kBoardConnected, kBoardConnected | kBoardClipping}));
    EXPECT_EQ(toPayload(*status), goldenFrame(Type::kStatus).payload());
    const auto error = readError(goldenFrame(Type::kError).payload());
    EXPECT_EQ(error, (BoxError{Code::kOverrun, 16,
                               "Daten verloren: \xC3\x9C"
                               "berlauf"}));
    const auto ack = readAck(goldenFrame(Type::kAck).payload());
    EXPECT_EQ(ack, (Ack{1, Code::kOk, ""}));
    EXPECT_EQ(toPayload(*ack), goldenFrame(Type::kAck).payload());
    EXPECT_EQ(startPayload(), goldenFrame(Type::kStart).payload());
    EXPECT_EQ(toPayload(Identify{1, 1500}), goldenFrame(Type::kIdentify).payload());
}

template <class T>
void expectEveryLengthIsChecked(const Bytes& payload, std::optional<T> (*read)(ByteView)) {
    EXPECT_TRUE(read(payload));
    for (size_t length = 0; length < payload.size(); ++length)
        EXPECT_FALSE(read(ByteView(payload).first(length))) << length;
    Bytes longer = payload;
    longer.push_back(0);
    EXPECT_FALSE(read(longer));
}

TEST(Messages, ALengthThatDoesNotFitTheCountIsDamage) {
    expectEveryLengthIsChecked(toPayload(rampBlock(8, 3, 2)), readSoundBlock);
    expectEveryLengthIsChecked(toPayload(rampBlock(8, 300, 2), AdcFormat::kZstd), readSoundBlock);
    expectEveryLengthIsChecked(toPayload(std::vector<EmittedPulse>{{1, 2}, {3, 4}}), readPulses);
    expectEveryLengthIsChecked(toPayload(BoxStatus{1, 2.f, 3.f, 4.f, 5.f, 6, {1, 2, 3}}), readStatus);
    expectEveryLengthIsChecked(toPayload(Identify{1, 2}), readIdentify);
    for (size_t length = 0; length < 6; ++length)
        EXPECT_FALSE(readAck(Bytes(length)));
    for (size_t length = 0; length < 12; ++length)
        EXPECT_FALSE(readError(Bytes(length)));
}

Bytes withByte(Bytes payload, size_t at, uint8_t value) {
    payload[at] = value;
    return payload;
}

TEST(Messages, NumbersOutOfRangeAreDamage) {
    const Bytes block = toPayload(rampBlock(0, 1, 1));
    EXPECT_FALSE(readSoundBlock(withByte(block, 7, 0x80)));  // first sample
    EXPECT_FALSE(readSoundBlock(withByte(block, 11, 1)));    // sample count
    EXPECT_FALSE(readSoundBlock(withByte(block, 14, 2)));    // format
    Bytes none = withByte(block, 8, 0);
    none.resize(16);
    EXPECT_FALSE(readSoundBlock(none));
    EXPECT_FALSE(readSoundBlock(withByte(toPayload(rampBlock(0, 33, 1)), 8, 1)));
    EXPECT_FALSE(readPulses(withByte(toPayload(std::vector<EmittedPulse>{{1, 0}}), 11, 0xFF)));
    // A count whose bytes overflow 32 bits.
    Bytes many = toPayload(std::vector<EmittedPulse>{{1, 0}, {1, 0}, {1, 0}, {1, 0}});
    EXPECT_FALSE(readPulses(withByte(many, 3, 0x40)));
    EXPECT_FALSE(readStatus(withByte(toPayload(BoxStatus{}), 7, 0xFF)));
    EXPECT_FALSE(readError(withByte(toPayload(BoxError{}), 11, 0xFF)));
}

TEST(Messages, ZstdNeverUnpacksMoreThanTheBlockHolds) {
    // 32 boards of silence are a few bytes packed; a block that says it is smaller gets none of them.
    SoundBlock silence{0, 32, std::vector<int16_t>(4096 * 32)};
    const Bytes payload = toPayload(silence, AdcFormat::kZstd);
    EXPECT_LT(payload.size(), 200u);
    EXPECT_TRUE(readSoundBlock(payload));
    EXPECT_FALSE(readSoundBlock(withByte(payload, 9, 0x0F)));
    EXPECT_FALSE(readSoundBlock(withByte(payload, 12, 31)));
    // Two zstd frames, together of the right size.
    Bytes two = toPayload(rampBlock(0, 10, 1), AdcFormat::kZstd);
    const Bytes half(two.begin() + 16, two.end());
    append(two, half);
    EXPECT_FALSE(readSoundBlock(withByte(two, 8, 20)));
}

TEST(Messages, WhatIsNoFiniteNumberIsUnknown) {
    BoxStatus status;
    status.temperature_c = std::numeric_limits<float>::infinity();
    status.battery_v = -std::numeric_limits<float>::quiet_NaN();
    const auto read = readStatus(toPayload(status));
    ASSERT_TRUE(read);
    EXPECT_FALSE(read->temperature_c);
    EXPECT_FALSE(read->battery_v);
}

TEST(Messages, TextIsAlwaysUtf8) {
    EXPECT_EQ(cleanText(bytesOf("a\xC3\x9F\xE2\x82\xAC\xF0\x9F\xA6\x87")),
              "a\xC3\x9F\xE2\x82\xAC\xF0\x9F\xA6\x87");
    const std::string no = "\xEF\xBF\xBD";
    EXPECT_EQ(cleanText(bytesOf("\xFFx")), no + "x");
    EXPECT_EQ(cleanText(bytesOf("\xC3")), no);
    EXPECT_EQ(cleanText(bytesOf("\xC0\x80")), no + no);
    EXPECT_EQ(cleanText(bytesOf("\xED\xA0\x80")), no + no + no);
    EXPECT_EQ(cleanText(bytesOf("\xF4\x90\x80\x80")), no + no + no + no);
}

TEST(Messages, RandomPayloadsNeverBreakAReader) {
    std::mt19937 random(5);
    int accepted = 0;
    for (int i = 0; i < 20'000; ++i) {
        Bytes payload =
            i % 2 ? randomBytes(random, random() % 64) : toPayload(rampBlock(8, 3, 2), AdcFormat::kZstd);
        if (i % 2 == 0)
            payload[random() % payload.size()] ^= static_cast<uint8_t>(1 << (random() % 8));
        accepted += readSoundBlock(payload) && readSoundBlock(payload)->values.empty();
        accepted += readPulses(payload) && readPulses(payload)->size() > 5;
        readStatus(payload), readError(payload), readAck(payload), readIdentify(payload);
    }
    EXPECT_EQ(accepted, 0);
}

TEST(Messages, NamesOfTypesAndCodes) {
    EXPECT_EQ(nameOf(Type::kIdentify), "IDENTIFY");
    EXPECT_EQ(nameOf(static_cast<Type>(0x42)), "type 0x42");
    EXPECT_EQ(nameOf(Code::kOverrun), "overrun");
    EXPECT_EQ(nameOf(Code::kShuttingDown), "shutting down");
    EXPECT_EQ(nameOf(static_cast<Code>(17)), "code 17");
}

}  // namespace
}  // namespace noctule::link
