// SPDX-License-Identifier: Apache-2.0
// ADC payloads, plain and packed by zstd.
#include <zstd.h>

#include <bit>
#include <cstring>

#include "core/job/contract.h"
#include "devices/driver_box/messages.h"

namespace noctule::link {

static_assert(std::endian::native == std::endian::little, "samples of the link are little-endian");

namespace {

constexpr int kZstdLevel = 1;  ///< sound hardly packs; what counts is that packing keeps up

/// Fills `values`; false when the data is not exactly one zstd frame of exactly that many values.
bool unpack(ByteView data, std::vector<int16_t>& values) {
    const size_t byte_count = values.size() * sizeof(int16_t);
    const size_t frame_bytes = ZSTD_findFrameCompressedSize(data.data(), data.size());
    return !ZSTD_isError(frame_bytes) && frame_bytes == data.size() &&
           ZSTD_decompress(values.data(), byte_count, data.data(), data.size()) == byte_count;
}

bool copyPlain(ByteView data, std::vector<int16_t>& values) {
    if (data.size() != values.size() * sizeof(int16_t))
        return false;
    std::memcpy(values.data(), data.data(), data.size());
    return true;
}

}  // namespace

Bytes toPayload(const SoundBlock& block, AdcFormat format) {
    require(block.board_count >= 1 && block.board_count <= kMaxBoards, "ADC: no board, or too many");
    const int64_t samples = block.sampleCount();
    require(samples >= 1 && samples <= kMaxBlockSamples &&
                block.values.size() == static_cast<size_t>(samples * block.board_count),
            "ADC: the values do not make a block");
    Bytes payload;
    WireWriter writer(payload);
    writer.number(static_cast<uint64_t>(block.first_sample));
    writer.number(static_cast<uint32_t>(samples));
    writer.number(static_cast<uint16_t>(block.board_count));
    writer.number(static_cast<uint16_t>(format));
    const size_t header_bytes = payload.size(), byte_count = block.values.size() * sizeof(int16_t);
    if (format == AdcFormat::kPlain) {
        writer.bytes({reinterpret_cast<const uint8_t*>(block.values.data()), byte_count});
        return payload;
    }
    payload.resize(header_bytes + ZSTD_compressBound(byte_count));
    const size_t packed = ZSTD_compress(payload.data() + header_bytes, payload.size() - header_bytes,
                                        block.values.data(), byte_count, kZstdLevel);
    require(!ZSTD_isError(packed), "zstd refused a buffer of the size it asked for");
    payload.resize(header_bytes + packed);
    return payload;
}

std::optional<SoundBlock> readSoundBlock(ByteView payload) {
    WireReader reader(payload);
    const auto first_sample = reader.number<uint64_t>();
    const auto samples = reader.number<uint32_t>();
    const auto boards = reader.number<uint16_t>();
    const auto format = static_cast<AdcFormat>(reader.number<uint16_t>());
    if (!reader.ok() || first_sample > static_cast<uint64_t>(kHighestSample) || samples < 1 ||
        samples > kMaxBlockSamples || boards < 1 || boards > kMaxBoards)
        return std::nullopt;
    SoundBlock block{static_cast<int64_t>(first_sample), boards, std::vector<int16_t>(samples * boards)};
    const bool whole = format == AdcFormat::kPlain  ? copyPlain(reader.rest(), block.values)
                       : format == AdcFormat::kZstd ? unpack(reader.rest(), block.values)
                                                    : false;
    return whole ? std::optional(std::move(block)) : std::nullopt;
}

}  // namespace noctule::link
