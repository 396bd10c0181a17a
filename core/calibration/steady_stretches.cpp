// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/steady_stretches.h"

#include <algorithm>

#include "core/calibration/worn_part_names.h"

namespace noctule {
namespace {

constexpr double kBlock_s = 0.25;
constexpr size_t kFewestInBlock = 5;
constexpr double kLongestSilence_s = 0.1;
// Some ten times the noise of the boards and their rounding; a table that is 1 degree askew swings the
// accelerometer by 0.35 m/s^2 from one block to the next.
constexpr double kGyroWaver_rad_per_s = 0.03, kAccelWaver_m_per_s2 = 0.4;
constexpr double kGyroStep_rad_per_s = 0.02, kAccelStep_m_per_s2 = 0.5;
/// Between a gyroscope's zero, some 1.2 rad/s off at worst, and 33 1/3 rpm less that.
constexpr double kSlowestTurn_rad_per_s = 2;

struct SteadyBlock {
    size_t first = 0, end = 0;
    Vector3d rate = Vector3d::Zero(), accel = Vector3d::Zero();
    bool steady = false;
};

class BlockReader {
public:
    BlockReader(const Board& board, const std::vector<CountReading>& readings)
        : readings_(readings),
          gyro_(AxisCalibration::nominal(board.gyro_full_scale_rad_per_s)),
          accel_(AxisCalibration::nominal(board.accel_full_scale_m_per_s2)) {}

    std::vector<SteadyBlock> blocks() const {
        std::vector<SteadyBlock> blocks;
        for (size_t first = 0, end = 0; first < readings_.size(); first = end) {
            while (end < readings_.size() && readings_[end].time_s < readings_[first].time_s + kBlock_s)
                ++end;
            blocks.push_back(block(first, end));
        }
        return blocks;
    }

private:
    SteadyBlock block(size_t first, size_t end) const {
        SteadyBlock block{first, end};
        const auto count = static_cast<double>(end - first);
        Vector3d gyro_squares = Vector3d::Zero(), accel_squares = Vector3d::Zero();
        for (size_t i = first; i < end; ++i) {
            const Vector3d rate = gyro_.apply(readings_[i].gyro_counts);
            const Vector3d accel = accel_.apply(readings_[i].accel_counts);
            block.rate += rate / count;
            block.accel += accel / count;
            gyro_squares += rate.cwiseAbs2() / count;
            accel_squares += accel.cwiseAbs2() / count;
        }
        const auto worst = [](const Vector3d& squares, const Vector3d& mean) {
            return std::sqrt(std::max(0.0, (squares - mean.cwiseAbs2()).maxCoeff()));
        };
        block.steady = end - first >= kFewestInBlock && !silent(first, end) &&
                       worst(gyro_squares, block.rate) < kGyroWaver_rad_per_s &&
                       worst(accel_squares, block.accel) < kAccelWaver_m_per_s2;
        return block;
    }
    bool silent(size_t first, size_t end) const {
        for (size_t i = std::max<size_t>(first, 1); i < end; ++i)
            if (readings_[i].time_s - readings_[i - 1].time_s > kLongestSilence_s)
                return true;
        return false;
    }

    const std::vector<CountReading>& readings_;
    AxisCalibration gyro_, accel_;
};

bool goesOn(const SteadyBlock& before, const SteadyBlock& after) {
    return after.steady && (after.rate - before.rate).norm() < kGyroStep_rad_per_s &&
           (after.accel - before.accel).norm() < kAccelStep_m_per_s2;
}

/// Without its first and last block, which may hold the end of a movement; nothing of less than three.
void addStretch(std::span<const SteadyBlock> blocks, const BoardRecord::Part& part,
                std::vector<SteadyStretch>& stretches) {
    if (blocks.size() < 3)
        return;
    const std::span<const SteadyBlock> inner = blocks.subspan(1, blocks.size() - 2);
    SteadyStretch stretch;
    stretch.take = part.take;
    stretch.readings =
        std::span(*part.readings).subspan(inner.front().first, inner.back().end - inner.front().first);
    stretch.begin_s = stretch.readings.front().time_s;
    stretch.end_s = stretch.readings.back().time_s;
    for (const SteadyBlock& block : inner)
        stretch.rate_rad_per_s += block.rate / static_cast<double>(inner.size());
    stretch.turns = stretch.rate_rad_per_s.norm() > kSlowestTurn_rad_per_s;
    stretches.push_back(stretch);
}

}  // namespace

size_t BoardRecord::readingCount() const {
    size_t count = 0;
    for (const Part& part : parts)
        count += part.readings->size();
    return count;
}

std::vector<SteadyStretch> BoardRecord::steadyStretches() const {
    std::vector<SteadyStretch> stretches;
    for (const Part& part : parts) {
        const std::vector<SteadyBlock> blocks = BlockReader(board, *part.readings).blocks();
        for (size_t first = 0, end = 0; first < blocks.size(); first = end) {
            end = first + 1;
            if (!blocks[first].steady)
                continue;
            while (end < blocks.size() && goesOn(blocks[end - 1], blocks[end]))
                ++end;
            addStretch(std::span(blocks).subspan(first, end - first), part, stretches);
        }
    }
    return stretches;
}

std::vector<BoardRecord> boardRecords(const std::vector<Observations>& takes) {
    std::vector<BoardRecord> records;
    for (size_t take = 0; take < takes.size(); ++take)
        for (size_t b = 0; b < takes[take].suit.boards.size(); ++b) {
            const Board& board = takes[take].suit.boards[b];
            auto record = std::ranges::find(records, board.id, &BoardRecord::id);
            if (record == records.end())
                record = records.insert(records.end(), {board.id,
                                                        boardWords(takes[take].suit, static_cast<int>(b)),
                                                        board,
                                                        &takes[take].calibration,
                                                        {}});
            if (b < takes[take].boards.size())
                record->parts.push_back({static_cast<int>(take), &takes[take].boards[b]});
        }
    return records;
}

}  // namespace noctule
