// SPDX-License-Identifier: Apache-2.0
// The raw sound of a take, block by block.
#include <zstd.h>

#include <bit>
#include <cstring>

#include "core/recording/take.h"

namespace noctule {

static_assert(std::endian::native == std::endian::little, "samples of a take are little-endian");

namespace {

enum Codec { kPlain = 0, kZstd = 1 };

/// A row of adc_block without its data.
struct BlockRow {
    int64_t id = 0;
    int64_t first_sample = 0;
    int64_t sample_count = 0;
    int64_t codec = kPlain;
};

RowVerdict readBlockRow(const Statement& row, int64_t next_sample, int64_t last_sample, BlockRow& block) {
    const auto first = row.integer(1);
    const auto count = row.integer(2);
    if (!isSample(first) || *first > last_sample)
        return "first_sample is missing or out of range";
    if (!count || *count < 1 || *count > kMaxBlockSamples)
        return "sample_count is not 1 to 65536";
    if (*first < next_sample)
        return "overlaps the block before";
    block = {row.integer(0).value_or(0), *first, *count, row.integer(3).value_or(row.isNull(3) ? 0 : -1)};
    if (block.codec != kPlain && block.codec != kZstd)
        return "its codec is not known to this program";
    return "";
}

/// Turns the bytes of a row into values; both buffers live on from block to block.
class BlockDecoder {
public:
    explicit BlockDecoder(int board_count) : board_count_(static_cast<size_t>(board_count)) {}

    RowVerdict decode(const BlockRow& block, std::span<const std::byte> data) {
        const size_t value_count = static_cast<size_t>(block.sample_count) * board_count_;
        const size_t byte_count = value_count * sizeof(int16_t);
        if (block.codec == kPlain && data.size() == byte_count && isAligned(data)) {
            values_ = {reinterpret_cast<const int16_t*>(data.data()), value_count};
            return "";
        }
        buffer_.resize(value_count);
        size_t length = data.size();
        if (block.codec == kZstd)
            length = ZSTD_decompress(buffer_.data(), byte_count, data.data(), data.size());
        else if (length == byte_count)
            std::memcpy(buffer_.data(), data.data(), byte_count);
        if (block.codec == kZstd && ZSTD_isError(length))
            return std::string("cannot be unpacked: ") + ZSTD_getErrorName(length);
        if (length != byte_count)
            return "data has " + std::to_string(length) + " bytes instead of " + std::to_string(byte_count);
        values_ = buffer_;
        return "";
    }
    std::span<const int16_t> values() const { return values_; }

private:
    /// Small blobs may lie anywhere in a page.
    static bool isAligned(std::span<const std::byte> data) {
        return reinterpret_cast<uintptr_t>(data.data()) % alignof(int16_t) == 0;
    }

    size_t board_count_;
    std::vector<int16_t> buffer_;
    std::span<const int16_t> values_;
};

}  // namespace

Status Take::forEachBlock(int suit, const BlockSink& sink) const {
    suit = seen(suit);
    return forEachBlockWhere("", suit, sink);
}

Status Take::forEachBlock(int suit, const SampleInterval& within, const BlockSink& sink) const {
    suit = seen(suit);
    // By first_sample alone, which is indexed: a block reaches no further than the largest can.
    const std::string filter = " AND first_sample>" + std::to_string(within.first - kMaxBlockSamples) +
                               " AND first_sample<=" + std::to_string(within.last);
    const auto boards = boardCount(suit);
    return forEachBlockWhere(filter, suit, [&](const AdcBlock& block) {
        const auto samples = static_cast<int64_t>(block.values.size()) / *boards;
        return block.first_sample + samples <= within.first || sink(block);
    });
}

Status Take::forEachBlockWhere(const std::string& filter, int suit, const BlockSink& sink) const {
    suit = seen(suit);
    const auto board_count = boardCount(suit);
    if (!board_count)
        return board_count.error();
    const std::string log_name = rowsOfSuit("adc_block", suit);
    log_->restart(log_name);
    // Two queries: sorting a file without the index must not drag the sound through the sorter.
    auto rows =
        database_->prepare(schema_->select("adc_block", {"id", "first_sample", "sample_count", "codec"}) +
                           ofSuit("adc_block", suit) + filter + " ORDER BY 2");
    auto data = database_->prepare(schema_->select("adc_block", {"data"}) + " WHERE " +
                                   schema_->expression("adc_block", "id") + "=?");
    if (!rows || !data)
        return rows ? data.error() : rows.error();
    BlockDecoder decoder(*board_count);
    int64_t next_sample = 0;
    while (true) {
        const Result<bool> there = rows->step();
        if (!there)
            return there.error();
        if (!*there)
            return Done{};
        BlockRow block;
        RowVerdict verdict = readBlockRow(*rows, next_sample, lastSample(), block);
        if (verdict.empty()) {
            data->reset();
            const Result<bool> found = data->bind(0, block.id).step();
            if (!found)
                return found.error();
            const auto bytes = *found ? data->blob(0) : std::nullopt;
            verdict = bytes ? decoder.decode(block, *bytes) : "data is missing";
        }
        if (!verdict.empty()) {
            log_->add(log_name, std::to_string(rows->integer(0).value_or(-1)), verdict);
            continue;
        }
        next_sample = block.first_sample + block.sample_count;
        if (!sink({block.first_sample, decoder.values()}))
            return Done{};
    }
}

}  // namespace noctule
