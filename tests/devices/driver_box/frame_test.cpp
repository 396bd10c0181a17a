// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/frame.h"

#include "devices/driver_box/crc32.h"
#include "tests/devices/driver_box/link_data.h"

namespace noctule::link {
namespace {

constexpr int64_t kOneSecond_ns = 1'000'000'000;
const FrameReader::Sink kIgnore = [](const LinkFrame&) {};

std::vector<uint32_t> sequencesOf(FrameReader& reader, const Bytes& bytes, int64_t now_ns = 0) {
    std::vector<uint32_t> sequences;
    reader.push(bytes, now_ns, [&](const LinkFrame& frame) { sequences.push_back(frame.header.sequence); });
    return sequences;
}

TEST(Crc32, IsTheCommonOne) {
    static_assert(crc32({}) == 0);
    EXPECT_EQ(crc32(bytesOf("123456789")), 0xCBF43926u);
}

TEST(Frame, EncodesEveryGoldenFrame) {
    for (const GoldenFrame& golden : goldenFrames())
        EXPECT_EQ(encodeFrame(static_cast<uint8_t>(golden.type()), golden.sequence, golden.payload()),
                  golden.bytes)
            << golden.name;
}

TEST(Frame, ReadsEveryGoldenFrame) {
    for (const GoldenFrame& golden : goldenFrames()) {
        FrameReader reader;
        int found = 0;
        reader.push(golden.bytes, 0, [&](const LinkFrame& frame) {
            ++found;
            EXPECT_EQ(frame.header.type, static_cast<uint8_t>(golden.type()));
            EXPECT_EQ(frame.header.sequence, golden.sequence);
            EXPECT_EQ(Bytes(frame.payload.begin(), frame.payload.end()), golden.payload());
        });
        EXPECT_EQ(found, 1) << golden.name;
        EXPECT_EQ(reader.heldBytes(), 0u);
    }
}

TEST(Frame, PayloadBeyondAFrameIsABrokenPromise) {
    EXPECT_EQ(encodeFrame(1, 0, Bytes(kMaxPayloadBytes)).size(), kMaxFrameBytes);
    EXPECT_THROW(encodeFrame(1, 0, Bytes(kMaxPayloadBytes + 1)), std::logic_error);
}

TEST(FrameReader, GoldenDamage) {
    FrameReader reader;
    EXPECT_EQ(sequencesOf(reader, damagedStream()),
              (std::vector<uint32_t>{0, 1, 3, 5, 6, 9, 11, 12, 13, 14}));
    const FrameStatistics& counts = reader.statistics();
    EXPECT_EQ(counts.damaged_payloads, 2);
    EXPECT_EQ(counts.unknown_versions, 1);
    EXPECT_EQ(counts.last_unknown_version->version, 2);
    EXPECT_EQ(counts.lost_frames, 2);
    EXPECT_GE(counts.bad_headers, 1);
    EXPECT_EQ(counts.skipped_bytes, 37 + 72 + 11 + 63);
    EXPECT_EQ(reader.heldBytes(), 0u);
}

TEST(FrameReader, EverySplitGivesTheSame) {
    const Bytes stream = damagedStream();
    FrameReader whole;
    const std::string expected = readAll(whole, stream, stream.size());
    for (size_t piece = 1; piece < 200; ++piece) {
        FrameReader reader;
        ASSERT_EQ(readAll(reader, stream, piece), expected) << piece;
    }
    for (size_t cut = 0; cut <= stream.size(); ++cut) {
        FrameReader reader;
        const std::vector<uint32_t> first = sequencesOf(reader, {stream.begin(), stream.begin() + cut});
        const std::vector<uint32_t> second = sequencesOf(reader, {stream.begin() + cut, stream.end()});
        ASSERT_EQ(first.size() + second.size(), 10u) << cut;
    }
}

TEST(FrameReader, EveryFlippedBitAndEveryCutIsNoticed) {
    const Bytes next = encodeFrame(0x07, 1, bytesOf("next"));
    for (const GoldenFrame& golden : {goldenFrame(Type::kAdc), goldenFrame(Type::kQuery)}) {
        for (size_t bit = 0; bit < 8 * golden.bytes.size(); ++bit) {
            Bytes stream = golden.bytes;
            stream[bit / 8] ^= static_cast<uint8_t>(1 << (bit % 8));
            append(stream, next);
            FrameReader reader;
            ASSERT_EQ(sequencesOf(reader, stream), std::vector<uint32_t>{1}) << bit;
        }
        for (size_t length = 1; length < golden.bytes.size(); ++length) {
            FrameReader reader;
            EXPECT_TRUE(sequencesOf(reader, {golden.bytes.begin(), golden.bytes.begin() + length}).empty());
            // The rest of the cut frame never comes; after its time the next frame is found.
            EXPECT_EQ(sequencesOf(reader, next, kOneSecond_ns), std::vector<uint32_t>{1}) << length;
        }
    }
}

TEST(FrameReader, GarbageBetweenFrames) {
    std::mt19937 random(11);
    Bytes stream;
    std::vector<uint32_t> expected;
    for (uint32_t i = 0; i < 200; ++i) {
        append(stream, randomBytes(random, random() % 300));
        if (i % 3 == 0)
            append(stream, bytesOf("NCTLNCTNCNNCTL"));
        append(stream, encodeFrame(3, i, randomBytes(random, random() % 500)));
        expected.push_back(i);
    }
    FrameReader reader;
    EXPECT_EQ(sequencesOf(reader, stream), expected);
    EXPECT_EQ(reader.statistics().lost_frames, 0);
}

TEST(FrameReader, TooLongAFrameIsABadHeader) {
    Bytes header = encodeFrame(3, 0, {});
    header.resize(16);
    header[14] = 0x10;  // 1 048 576
    for (const uint8_t low : {uint8_t{0}, uint8_t{1}}) {
        header.resize(16);
        header[12] = low;
        WireWriter writer(header);
        writer.number(crc32(header));
        FrameReader reader;
        EXPECT_TRUE(sequencesOf(reader, header).empty());
        EXPECT_EQ(reader.statistics().bad_headers, low);
        EXPECT_EQ(reader.heldBytes(), low ? 0u : 20u);
    }
}

TEST(FrameReader, CountsLostFramesAcrossTheWrap) {
    struct Case {
        uint32_t before, after;
        int64_t lost;
    };
    for (const Case& one :
         {Case{0xFFFFFFFE, 0xFFFFFFFF, 0}, Case{0xFFFFFFFF, 0, 0}, Case{0xFFFFFFFE, 1, 2}, Case{7, 7, 0},
          Case{7, 3, 0}, Case{7, 8 + 0x7FFFFFFFu, 0x7FFFFFFF}, Case{7, 8 + 0x80000000u, 0}}) {
        FrameReader reader;
        sequencesOf(reader, encodeFrame(7, one.before, {}));
        const int64_t lost_before = reader.statistics().lost_frames;
        sequencesOf(reader, encodeFrame(7, one.after, {}));
        EXPECT_EQ(reader.statistics().lost_frames - lost_before, one.lost) << one.before << ' ' << one.after;
    }
}

TEST(FrameReader, ANewConnectionForgetsHalfAFrameAndStartsAtZero) {
    FrameReader reader;
    Bytes stream = encodeFrame(7, 0, {});
    append(stream, Bytes(encodeFrame(7, 1, Bytes(100))));
    stream.resize(stream.size() - 60);
    EXPECT_EQ(sequencesOf(reader, stream), std::vector<uint32_t>{0});
    reader.restart();
    EXPECT_EQ(sequencesOf(reader, encodeFrame(7, 0, {})), std::vector<uint32_t>{0});
    EXPECT_EQ(reader.statistics().lost_frames, 0);
    EXPECT_EQ(reader.statistics().frames, 2);
}

TEST(FrameReader, FramesInsideAFrameThatNeverEndsComeOutAfterASecond) {
    Bytes cut = encodeFrame(3, 0, Bytes(1000));
    cut.resize(100);
    append(cut, encodeFrame(7, 1, bytesOf("one")));
    append(cut, encodeFrame(7, 2, bytesOf("two")));
    FrameReader reader;
    EXPECT_TRUE(sequencesOf(reader, cut).empty());
    int found = 0;
    const FrameReader::Sink count = [&](const LinkFrame&) { ++found; };
    reader.idle(kOneSecond_ns - 1, count);
    EXPECT_EQ(found, 0);
    reader.idle(kOneSecond_ns, count);
    EXPECT_EQ(found, 2);
    EXPECT_EQ(reader.statistics().skipped_bytes, 100);
    EXPECT_EQ(reader.heldBytes(), 0u);
}

/// Frames put together, cut, flipped, repeated and padded at random.
Bytes mutatedStream(std::mt19937& random, const std::vector<GoldenFrame>& frames) {
    Bytes stream;
    for (uint32_t parts = 1 + random() % 4; parts > 0; --parts) {
        Bytes part = frames[random() % frames.size()].bytes;
        switch (random() % 6) {
            case 0:
                part.resize(random() % part.size());
                break;
            case 1:
                part[random() % part.size()] ^= static_cast<uint8_t>(1 << (random() % 8));
                break;
            case 2:
                part = randomBytes(random, random() % 40);
                break;
            case 3:
                part.erase(part.begin() + static_cast<int>(random() % part.size()));
                break;
            case 4:
                part[8] = static_cast<uint8_t>(random());
                break;
            default:
                break;
        }
        append(stream, part);
    }
    return stream;
}

TEST(FrameReader, HundredThousandMutations) {
    const std::vector<GoldenFrame> frames = goldenFrames();
    std::mt19937 random(20261121);
    FrameReader reader;
    int64_t now_ns = 0, found = 0, pushed = 0;
    size_t most_memory = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Bytes stream = mutatedStream(random, frames);
        pushed += static_cast<int64_t>(stream.size());
        now_ns += random() % 20 == 0 ? kOneSecond_ns : 1000;
        reader.push(stream, now_ns, [&](const LinkFrame& frame) {
            ++found;
            ASSERT_LE(frame.payload.size(), kMaxPayloadBytes);
        });
        most_memory = std::max(most_memory, reader.memoryBytes());
    }
    EXPECT_EQ(found, reader.statistics().frames);
    EXPECT_GT(found, 30'000);
    EXPECT_LE(reader.statistics().skipped_bytes + found * 24, pushed);
    EXPECT_LE(most_memory, 2 * kMaxFrameBytes);
}

TEST(FrameReader, MemoryIsBoundedByTheLongestFrame) {
    Bytes stream = encodeFrame(3, 0, Bytes(kMaxPayloadBytes));
    stream.pop_back();
    FrameReader reader;
    for (int i = 0; i < 3; ++i) {
        reader.push(stream, i, kIgnore);
        reader.push(bytesOf("NCTLNCTNC"), i, kIgnore);
        EXPECT_LE(reader.memoryBytes(), kMaxFrameBytes);
    }
    EXPECT_EQ(reader.statistics().damaged_payloads, 3);
}

}  // namespace
}  // namespace noctule::link
