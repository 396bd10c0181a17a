// SPDX-License-Identifier: Apache-2.0
// How each source was heard over the last seconds: per step of time the mean confidence of the boards that
// heard it. Push ranges as they come; a range that came before is not counted again. No clocks.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/acoustics/range.h"

namespace noctule {

class HeardWindow {
public:
    struct Shape {
        double seconds = 10;
        double step_s = 0.1;  ///< each source sounds every 64 ms
    };
    HeardWindow(int source_count, int board_count, int sample_rate_hz);
    HeardWindow(int source_count, int board_count, int sample_rate_hz, Shape shape);

    /// The newest range per pair, source * boards + board; absent: never heard.
    void add(std::span<const std::optional<RangeMeasurement>> newest);
    /// The window ends here.
    void advanceTo(int64_t sample);

    int sourceCount() const { return source_count_; }
    int stepCount() const { return step_count_; }
    /// Step 0 is the oldest. Absent: no board heard the source then.
    std::optional<double> confidence(int source, int step) const;

private:
    struct Cell {
        int64_t step = -1;  ///< since sample 0; else the cell holds what is long past
        double sum = 0;
        int count = 0;
    };
    size_t at(int source, int64_t step) const;

    int source_count_, step_count_;
    int64_t step_samples_, newest_step_ = 0;
    std::vector<Cell> cells_;             ///< a ring of steps per source
    std::vector<int64_t> counted_until_;  ///< pulse's sample per pair
};

}  // namespace noctule
