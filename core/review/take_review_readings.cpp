// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "core/review/review_file.h"
#include "core/review/take_review.h"

namespace noctule {
namespace {

/// One triad's counts to SI. An axis that the stream left out keeps its last counts for what the others see
/// of it (misalignments of about 1 %) and is itself NaN.
class Triad {
public:
    explicit Triad(const AxisCalibration& calibration)
        : calibration_(calibration),
          held_counts_(calibration.zero_counts),
          is_si_(!calibration.isOfCounts()) {}

    /// Appends three values; true when one of them was clipped.
    bool append(const std::optional<double>* counts, std::vector<float>* value) {
        bool clipped[3] = {};
        for (int i = 0; i < 3; ++i)
            if (counts[i]) {
                held_counts_[i] = *counts[i];
                clipped[i] = !is_si_ && (*counts[i] <= kCountsMin || *counts[i] >= kCountsMax);
            }
        const Vector3d si = calibration_.apply(held_counts_);
        for (int i = 0; i < 3; ++i)
            value[i].push_back(counts[i] && !clipped[i] ? static_cast<float>(si[i]) : kNoValue);
        return clipped[0] || clipped[1] || clipped[2];
    }

private:
    const AxisCalibration& calibration_;
    Vector3d held_counts_;
    bool is_si_;  ///< of another maker's sensor: no counts, no limits
};

class BoardReader {
public:
    BoardReader(const BoardCalibration& calibration, const ReviewFile& file)
        : file_(file), gyro_(calibration.gyro), accel_(calibration.accel) {}

    void add(const InertialReading& reading, BoardTrack& track) {
        const double t_s = file_.seconds(reading.sample);
        if (!track.t_s.empty() && t_s <= track.t_s.back())
            return;
        track.t_s.push_back(t_s);
        const bool gyro_clipped = gyro_.append(reading.counts.data(), track.value.data());
        const bool accel_clipped = accel_.append(reading.counts.data() + 3, track.value.data() + 3);
        if (gyro_clipped || accel_clipped)
            track.clipped_s.push_back(t_s);
        if (!reading.corrected_bits)
            track.lost_s.push_back(t_s);
    }

private:
    const ReviewFile& file_;
    Triad gyro_, accel_;
};

}  // namespace

Result<ReadingTable> loadReadings(const TakeView& view, int64_t run, const JobContext& job) {
    const auto file = ReviewFile::open(view);
    if (!file)
        return file.error();
    const auto suit = file->take.suit();
    if (!suit)
        return suit.error();
    const Calibration nominal = nominalCalibration(*suit);
    const auto stored = file->take.calibrationInForce();
    auto readings = file->take.readings(run);
    if (!readings)
        return readings.error();
    ReadingTable table;
    table.boards.resize(suit->boards.size());
    std::vector<BoardReader> readers;
    for (const Board& board : suit->boards) {
        const BoardCalibration* known = stored ? stored->value.findBoard(board.id) : nullptr;
        readers.emplace_back(known ? *known : *nominal.findBoard(board.id), *file);
    }
    const auto samples = file->take.sampleCount();
    RowProgress progress(job, "Loading readings", samples ? file->seconds(static_cast<double>(*samples)) : 0);
    while (true) {
        const auto reading = readings->next();
        if (!reading)
            return reading.error();
        if (!*reading)
            return table;
        const auto board = static_cast<size_t>((*reading)->board);
        readers[board].add(**reading, table.boards[board]);
        if (!progress.at(file->seconds((*reading)->sample)))
            return JobContext::cancelledError();
    }
}

}  // namespace noctule
