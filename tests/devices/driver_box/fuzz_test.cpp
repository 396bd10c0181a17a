// SPDX-License-Identifier: Apache-2.0
// The link under damaged bytes, beginning at the golden vectors: whatever comes, nothing crashes, throws or
// grows.
#include "devices/driver_box/box_conversation.h"
#include "devices/driver_box/discovery.h"
#include "devices/driver_box/studio_conversation.h"
#include "tests/devices/driver_box/link_data.h"
#include "tests/support/fuzzing.h"

namespace noctule::link {
namespace {

constexpr int64_t kFuzzStep_ns = 50'000'000, kMostGrowth_kb = 32 * 1024;
constexpr int kFewInputs = 3000;

std::string textOf(const Bytes& bytes) {
    return {bytes.begin(), bytes.end()};
}

ByteView viewOf(const std::string& text) {
    return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

/// Payloads of one side, and its whole conversation.
std::vector<std::string> goldenTexts(bool from_box) {
    std::vector<std::string> texts{""};
    for (const GoldenFrame& frame : goldenFrames())
        if (frame.from_box == from_box)
            texts[0] += textOf(frame.bytes);
    return texts;
}

/// What every reader of payloads makes of it; nothing is a good answer.
void readAsEverything(ByteView payload) {
    readAck(payload);
    readPulses(payload);
    readStatus(payload);
    readError(payload);
    readIdentify(payload);
    (void)readAnnouncement(payload, "fuzz");
    (void)readSettings(payload);
    if (const auto block = readSoundBlock(payload)) {
        EXPECT_GE(block->first_sample, 0);
        EXPECT_LE(block->first_sample, kHighestSample);
        EXPECT_TRUE(block->board_count > 0 && block->board_count <= kMaxBoards);
        EXPECT_TRUE(block->sampleCount() > 0 && block->sampleCount() <= kMaxBlockSamples);
    }
    if (const auto hello = readHello(payload, "fuzz")) {
        EXPECT_FALSE(hello->serial.empty());
        EXPECT_TRUE(hello->boardCount() <= kMaxBoards);
    }
}

TEST(FuzzLink, BytesOfAStream) {
    auto examples = goldenTexts(true);
    examples.push_back(goldenTexts(false)[0]);
    examples.push_back(textOf(damagedStream()));
    test::feedDamaged(examples, kFewInputs, kMostGrowth_kb, [](const std::string& stream, int64_t number) {
        FrameReader reader;
        const FrameReader::Sink sink = [](const LinkFrame& frame) { readAsEverything(frame.payload); };
        const size_t piece = 1 + static_cast<size_t>(number) % 700;
        for (size_t at = 0; at < stream.size(); at += piece)
            reader.push(viewOf(stream).subspan(at, std::min(piece, stream.size() - at)), 0, sink);
        for (int i = 1; i < 5; ++i)
            reader.idle(i * FrameReader::kPatience_ns, sink);
        EXPECT_LE(reader.memoryBytes(), 2 * kMaxFrameBytes);
        (void)readAnnouncementDatagram(viewOf(stream), "fuzz");
    });
}

/// Frames that are whole, around payloads that are not.
TEST(FuzzLink, PayloadsToTheStudio) {
    std::vector<std::string> examples;
    std::vector<Type> types;
    for (const GoldenFrame& frame : goldenFrames())
        if (frame.from_box) {
            examples.push_back(textOf(frame.payload()));
            types.push_back(frame.type());
        }
    const Bytes hello = goldenFrame(Type::kHello).payload();
    test::feedDamaged(examples, kFewInputs, kMostGrowth_kb, [&](const std::string& payload, int64_t number) {
        StudioConversation studio("fuzz");
        int64_t now_ns = 0;
        uint32_t sequence = 0;
        const auto hear = [&](Type type, ByteView bytes) {
            studio.receive(encodeFrame(static_cast<uint8_t>(type), sequence++, bytes), now_ns);
            studio.tick(now_ns += kFuzzStep_ns);
        };
        readAsEverything(viewOf(payload));
        studio.opened(now_ns);
        if (number % 4 != 0)
            hear(Type::kHello, hello);
        if (number % 4 > 1 && studio.state() == StudioConversation::State::kIdle)
            studio.start(now_ns);
        const ByteView bytes = viewOf(payload).first(std::min(payload.size(), kMaxPayloadBytes));
        for (size_t i = 0; i < types.size(); ++i)
            hear(types[(i + static_cast<size_t>(number)) % types.size()], bytes);
        if (number % 4 == 3)
            studio.closed(now_ns);
        for (int i = 0; i < 8; ++i)
            studio.tick(now_ns += 10 * kFuzzStep_ns);
        int64_t next = 0;
        for (const StudioEvent& event : studio.takeEvents())
            if (const auto* block = std::get_if<SoundBlock>(&event)) {
                EXPECT_GE(block->first_sample, next);
                next = block->first_sample + block->sampleCount();
            }
    });
}

TEST(FuzzLink, PayloadsToTheBox) {
    std::vector<std::string> examples;
    std::vector<Type> types;
    for (const GoldenFrame& frame : goldenFrames())
        if (!frame.from_box) {
            examples.push_back(textOf(frame.payload()));
            types.push_back(frame.type());
        }
    const Hello hello = readHello(goldenFrame(Type::kHello).payload(), "fuzz").value();
    test::feedDamaged(examples, kFewInputs, kMostGrowth_kb, [&](const std::string& payload, int64_t number) {
        BoxConversation box(hello);
        box.connected(0);
        const ByteView bytes = viewOf(payload).first(std::min(payload.size(), kMaxPayloadBytes));
        for (uint32_t i = 0; i < 2 * types.size(); ++i) {
            const Type type = types[(i + static_cast<size_t>(number)) % types.size()];
            box.receive(encodeFrame(static_cast<uint8_t>(type), i, bytes), i);
            box.offer(SoundBlock{box.nextSample(), hello.boardCount(),
                                 std::vector<int16_t>(static_cast<size_t>(hello.boardCount()) * 60)});
            box.tick(i * kFuzzStep_ns);
        }
        FrameReader studio;
        int frames = 0;
        for (Bytes out = box.read(4096); !out.empty(); out = box.read(4096))
            studio.push(out, 0, [&](const LinkFrame&) { ++frames; });
        EXPECT_GT(frames, 0) << "every request is answered";
        EXPECT_EQ(studio.statistics().losses(), 0);
    });
}

}  // namespace
}  // namespace noctule::link
