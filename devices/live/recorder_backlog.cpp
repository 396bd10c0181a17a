// SPDX-License-Identifier: Apache-2.0
#include "devices/live/recorder_backlog.h"

#include <algorithm>

namespace noctule {
namespace {

int64_t bytesOf(const ArrivedBlock& block) {
    return static_cast<int64_t>(block.sound->values.size() * sizeof(int16_t));
}

LiveItem lost(const ArrivedBlock& block, int64_t samples) {
    return GapRow{block.firstSample(), samples, std::nullopt, kGapOfStudio};
}

}  // namespace

void RecorderBacklog::push(LiveItem item) {
    const auto* block = std::get_if<ArrivedBlock>(&item);
    if (!block) {
        entries_.emplace_back(std::move(item));
        return;
    }
    const int64_t bytes = bytesOf(*block);
    if (extent_.file_bytes == 0 && extent_.memory_bytes + bytes <= in_memory_bytes_) {
        extent_.memory_bytes += bytes;
        extent_.most_memory_bytes = std::max(extent_.most_memory_bytes, extent_.memory_bytes);
        entries_.emplace_back(std::move(item));
        return;
    }
    if (auto stored = store(*block))
        entries_.emplace_back(std::move(*stored));
    else
        entries_.emplace_back(lost(*block, block->sampleCount()));
}

std::optional<RecorderBacklog::Stored> RecorderBacklog::store(const ArrivedBlock& block) {
    if (!file_)
        if (auto made = UnnamedFile::make(folder_, "sound", "Check that it has room"))
            file_.emplace(std::move(*made));
    if (!file_)
        return std::nullopt;
    file_->seek(end_);
    file_->putBytes(block.sound->values.data(), static_cast<size_t>(bytesOf(block)));
    if (!file_->good())
        return std::nullopt;
    auto shell = std::make_shared<link::SoundBlock>();
    shell->first_sample = block.sound->first_sample;
    shell->board_count = block.sound->board_count;
    Stored stored{{std::move(shell), block.arrived_ns, block.origin}, end_, block.sound->values.size()};
    end_ += bytesOf(block);
    extent_.file_bytes += bytesOf(block);
    extent_.most_file_bytes = std::max(extent_.most_file_bytes, extent_.file_bytes);
    return stored;
}

LiveItem RecorderBacklog::fetch(const Stored& stored) {
    auto sound = std::make_shared<link::SoundBlock>(*stored.shell.sound);
    sound->values.resize(stored.values);
    const size_t bytes = stored.values * sizeof(int16_t);
    extent_.file_bytes -= static_cast<int64_t>(bytes);
    file_->seek(stored.position);
    const bool read = file_->takeBytes(sound->values.data(), bytes);
    ArrivedBlock block{std::move(sound), stored.shell.arrived_ns, stored.shell.origin};
    return read ? LiveItem(block) : lost(block, block.sampleCount());
}

LiveItem RecorderBacklog::pop() {
    std::variant<LiveItem, Stored> entry = std::move(entries_.front());
    entries_.pop_front();
    if (auto* item = std::get_if<LiveItem>(&entry)) {
        if (const auto* block = std::get_if<ArrivedBlock>(item))
            extent_.memory_bytes -= bytesOf(*block);
        return std::move(*item);
    }
    LiveItem item = fetch(std::get<Stored>(entry));
    if (extent_.file_bytes == 0) {
        file_.reset();
        end_ = 0;
    }
    return item;
}

}  // namespace noctule
