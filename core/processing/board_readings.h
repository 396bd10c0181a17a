// SPDX-License-Identifier: Apache-2.0
// The primary readings of a take, board by board, calibrated, with the time between them: what methods need
// that look at one sensor's whole recording.
#pragma once

#include <vector>

#include "core/job/job.h"
#include "core/orientation/imu_samples.h"
#include "core/recording/take.h"

namespace noctule {

/// A lost frame is a row of NaN.
struct BoardReadings {
    ImuSamples samples;
    std::vector<int64_t> time_ns;  ///< of the suit's clock
    size_t missing = 0;            ///< rows without gyroscope or accelerometer
    size_t left_out = 0;           ///< readings whose instant falls out of the order of the others
};

/// With nominal values for the boards that `known` lacks.
Calibration completedCalibration(const Suit& suit, const Calibration& known);
/// Of the one in force, as far as there is one.
Calibration completedCalibration(const Suit& suit, const Take& take);

/// `suit` and `calibration` must outlive it; the calibration names all boards.
class ReadingsOfBoards {
public:
    ReadingsOfBoards(const Suit& suit, const Calibration& calibration, double sample_rate_hz)
        : suit_(suit),
          calibration_(calibration),
          sample_rate_hz_(sample_rate_hz),
          rows_(suit.boards.size()) {}

    /// Reads all of run 0 of the suit in view.
    Status gather(const Take& take, const JobContext& job);
    /// Nothing of a board with fewer than two rows. Instants of a regular stream are taken from a line
    /// through them, which has no jitter; those of another count as they are. kUnusable: a rate outside 10 to
    /// 10000 Hz, or more than a tenth of the readings out of order.
    Result<BoardReadings> of(size_t board, const Take& take) const;

private:
    struct Placement;
    static Placement onLine(const std::vector<InertialReading>& rows, double step);
    Placement byStamps(const std::vector<InertialReading>& rows, double usual_step) const;
    void fill(const std::vector<InertialReading>& rows, size_t board, const Placement& placement,
              BoardReadings& out) const;

    const Suit& suit_;
    const Calibration& calibration_;
    double sample_rate_hz_;
    std::vector<std::vector<InertialReading>> rows_;
};

}  // namespace noctule
