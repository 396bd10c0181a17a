// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/frame.h"

#include <algorithm>

#include "core/job/contract.h"
#include "devices/driver_box/crc32.h"

namespace noctule::link {

namespace {

constexpr size_t kCheckedHeaderBytes = kHeaderBytes - sizeof(uint32_t);
constexpr uint32_t kLongestLoss = uint32_t{1} << 31;  ///< a longer way forward is a way back

}  // namespace

Bytes encodeFrame(uint8_t type, uint32_t sequence, ByteView payload) {
    require(payload.size() <= kMaxPayloadBytes, "encodeFrame: the payload does not fit a frame");
    Bytes frame;
    frame.reserve(kHeaderBytes + payload.size() + kTailBytes);
    WireWriter writer(frame);
    writer.bytes(kMagic);
    writer.number(kLinkVersion);
    writer.number(type);
    writer.number(uint16_t{0});
    writer.number(sequence);
    writer.number(static_cast<uint32_t>(payload.size()));
    writer.number(crc32(frame));
    writer.bytes(payload);
    writer.number(crc32(payload));
    return frame;
}

void FrameReader::restart() {
    buffer_.clear();
    begin_ = 0;
    header_.reset();
    expected_sequence_ = 0;
}

void FrameReader::push(ByteView bytes, int64_t now_ns, const Sink& sink) {
    if (bytes.empty())
        return;
    idle(now_ns, sink);
    last_byte_ns_ = now_ns;
    // Never more than the frame at hand needs: so memory stays bounded whatever the size of a piece is.
    while (!bytes.empty()) {
        const size_t count = std::min(bytes.size(), neededBytes() - heldBytes());
        append(bytes.first(count));
        bytes = bytes.subspan(count);
        search(sink);
    }
}

/// What may be inside a frame that never ends gets its own patience, as a frame that has just begun does.
void FrameReader::idle(int64_t now_ns, const Sink& sink) {
    if (heldBytes() == 0 || now_ns - last_byte_ns_ < kPatience_ns)
        return;
    last_byte_ns_ = now_ns;
    header_.reset();
    ++begin_;
    ++statistics_.skipped_bytes;
    search(sink);
}

void FrameReader::append(ByteView bytes) {
    if (buffer_.size() + bytes.size() > buffer_.capacity()) {
        buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
        begin_ = 0;
        const size_t wanted = buffer_.size() + bytes.size();
        if (wanted > buffer_.capacity())
            buffer_.reserve(std::max(wanted, std::min(2 * wanted, kMaxFrameBytes)));
    }
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

/// Goes through what is held until more bytes are needed.
void FrameReader::search(const Sink& sink) {
    while (heldBytes() > 0) {
        if (!header_) {
            skipGarbage();
            if (heldBytes() < kHeaderBytes)
                break;
            if (!readHeader())
                continue;
        }
        if (heldBytes() < neededBytes())
            break;
        finishFrame(sink);
    }
    if (begin_ == buffer_.size()) {
        buffer_.clear();
        begin_ = 0;
    }
}

/// Up to the next magic, or to what may become one.
void FrameReader::skipGarbage() {
    const ByteView bytes = held();
    auto at = bytes.begin();
    while (at != bytes.end()) {
        at = std::find(at, bytes.end(), kMagic[0]);
        const auto length = std::min<std::ptrdiff_t>(bytes.end() - at, kMagic.size());
        if (std::equal(at, at + length, kMagic.begin()))
            break;
        ++at;
    }
    const auto skipped = static_cast<size_t>(at - bytes.begin());
    begin_ += skipped;
    statistics_.skipped_bytes += static_cast<int64_t>(skipped);
}

/// At the magic, with a whole header held. A bad one costs one byte: the next may be inside it.
bool FrameReader::readHeader() {
    const ByteView bytes = held().first(kHeaderBytes);
    WireReader reader(bytes.subspan(kMagic.size()));
    FrameHeader header;
    header.version = reader.number<uint8_t>();
    header.type = reader.number<uint8_t>();
    header.flags = reader.number<uint16_t>();
    header.sequence = reader.number<uint32_t>();
    header.payload_bytes = reader.number<uint32_t>();
    if (reader.number<uint32_t>() == crc32(bytes.first(kCheckedHeaderBytes)) &&
        header.payload_bytes <= kMaxPayloadBytes) {
        header_ = header;
        return true;
    }
    ++statistics_.bad_headers;
    ++statistics_.skipped_bytes;
    ++begin_;
    return false;
}

void FrameReader::finishFrame(const Sink& sink) {
    const ByteView bytes = held().first(neededBytes());
    const LinkFrame frame{*header_, bytes.subspan(kHeaderBytes, header_->payload_bytes)};
    const uint32_t crc = WireReader(bytes.last(kTailBytes)).number<uint32_t>();
    header_.reset();
    begin_ += bytes.size();
    noteSequence(frame.header.sequence);
    if (crc != crc32(frame.payload)) {
        ++statistics_.damaged_payloads;
    } else if (frame.header.version != kLinkVersion) {
        ++statistics_.unknown_versions;
        statistics_.last_unknown_version = frame.header;
    } else {
        ++statistics_.frames;
        sink(frame);
    }
}

/// Damaged and foreign frames have arrived, too. A number further back than forward is a box that began
/// again.
void FrameReader::noteSequence(uint32_t sequence) {
    const uint32_t distance = sequence - expected_sequence_;
    if (distance < kLongestLoss)
        statistics_.lost_frames += distance;
    expected_sequence_ = sequence + 1;
}

}  // namespace noctule::link
