// SPDX-License-Identifier: Apache-2.0
// Frames of the link (README.md, sections 1 and 6): magic, version, type, sequence number, length and CRC-32
// around up to 1 MiB of payload. Bytes in pieces of any size go in, whole frames come out; whatever lies
// before, between or inside frames is skipped and counted, in memory of at most two frame lengths.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "devices/driver_box/wire.h"

namespace noctule::link {

inline constexpr std::array<uint8_t, 4> kMagic = {'N', 'C', 'T', 'L'};
inline constexpr uint8_t kLinkVersion = 1;
inline constexpr size_t kHeaderBytes = 20, kTailBytes = 4;
inline constexpr size_t kMaxPayloadBytes = 1'048'576;
inline constexpr size_t kMaxFrameBytes = kHeaderBytes + kMaxPayloadBytes + kTailBytes;

struct FrameHeader {
    uint8_t version = kLinkVersion;
    uint8_t type = 0;
    uint16_t flags = 0;
    uint32_t sequence = 0;
    uint32_t payload_bytes = 0;
};

/// The payload is only valid while the sink of FrameReader runs. A sink must not call its reader.
struct LinkFrame {
    FrameHeader header;
    ByteView payload;
};

/// A payload beyond kMaxPayloadBytes is a broken promise.
Bytes encodeFrame(uint8_t type, uint32_t sequence, ByteView payload);

/// Counts since the reader was made; a new connection does not clear them.
struct FrameStatistics {
    int64_t frames = 0;            ///< passed to the sink
    int64_t skipped_bytes = 0;     ///< in no frame
    int64_t bad_headers = 0;       ///< the magic was there, CRC or length wrong
    int64_t damaged_payloads = 0;  ///< CRC wrong; the whole frame was skipped
    int64_t unknown_versions = 0;  ///< good frames of another version, skipped
    int64_t lost_frames = 0;       ///< jumps of the sequence number
    std::optional<FrameHeader> last_unknown_version;

    /// Anything that may have cost data between two moments.
    int64_t losses() const { return bad_headers + damaged_payloads + unknown_versions + lost_frames; }
};

class FrameReader {
public:
    using Sink = std::function<void(const LinkFrame&)>;

    /// After this long without a byte what is held of a frame is given up, one byte at a time.
    static constexpr int64_t kPatience_ns = 1'000'000'000;

    /// `now_ns`: when the bytes arrived, on any clock that does not go back.
    void push(ByteView bytes, int64_t now_ns, const Sink& sink);
    /// Nothing has come; call a few times a second, so that a cut frame does not hold what follows it inside.
    void idle(int64_t now_ns, const Sink& sink);
    /// A new connection: what is held is forgotten, sequence numbers start at 0.
    void restart();

    const FrameStatistics& statistics() const { return statistics_; }
    size_t heldBytes() const { return buffer_.size() - begin_; }
    size_t memoryBytes() const { return buffer_.capacity(); }

private:
    void append(ByteView bytes);
    void search(const Sink& sink);
    bool readHeader();
    void finishFrame(const Sink& sink);
    void skipGarbage();
    void noteSequence(uint32_t sequence);
    ByteView held() const { return ByteView(buffer_).subspan(begin_); }
    size_t neededBytes() const {
        return header_ ? kHeaderBytes + header_->payload_bytes + kTailBytes : kHeaderBytes;
    }

    Bytes buffer_;  ///< what is held begins at begin_
    size_t begin_ = 0;
    std::optional<FrameHeader> header_;  ///< of the frame at begin_, once it is known to be good
    uint32_t expected_sequence_ = 0;
    int64_t last_byte_ns_ = 0;
    FrameStatistics statistics_;
};

}  // namespace noctule::link
