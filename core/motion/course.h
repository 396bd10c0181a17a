// SPDX-License-Identifier: Apache-2.0
// A value over time, to be drawn, in bounded memory. Frames stand for themselves until kMost are kept; then
// neighbours share a stretch, of which the smallest and the largest value stay. A peak of one frame survives.
// Courses that were given the same times have the same stretches.
#pragma once

#include <cstddef>
#include <vector>

namespace noctule {

class Course {
public:
    /// Stretches of a full course are shorter than a 2000th of its duration: two to a pixel of a wide plot.
    static constexpr size_t kMost = 4096;

    struct Stretch {
        double time_s;         ///< of its first frame
        double first, second;  ///< smallest and largest value, in the order in which they came
    };

    /// Times must rise.
    void add(double time_s, double value);

    const std::vector<Stretch>& stretches() const { return stretches_; }

private:
    void append(const Stretch& late);

    std::vector<Stretch> stretches_;
    double width_s_ = 0;  ///< of a stretch; 0: every frame has its own
};

}  // namespace noctule
