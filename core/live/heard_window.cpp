// SPDX-License-Identifier: Apache-2.0
#include "core/live/heard_window.h"

#include <algorithm>
#include <cmath>

namespace noctule {

HeardWindow::HeardWindow(int source_count, int board_count, int sample_rate_hz)
    : HeardWindow(source_count, board_count, sample_rate_hz, Shape{}) {}

HeardWindow::HeardWindow(int source_count, int board_count, int sample_rate_hz, Shape shape)
    : source_count_(source_count),
      step_count_(static_cast<int>(std::lround(shape.seconds / shape.step_s))),
      step_samples_(std::max<int64_t>(1, std::llround(shape.step_s * sample_rate_hz))),
      cells_(static_cast<size_t>(source_count * step_count_)),
      counted_until_(static_cast<size_t>(source_count * board_count), -1) {}

size_t HeardWindow::at(int source, int64_t step) const {
    return static_cast<size_t>(source * step_count_ + step % step_count_);
}

void HeardWindow::add(std::span<const std::optional<RangeMeasurement>> newest) {
    for (size_t pair = 0; pair < std::min(newest.size(), counted_until_.size()); ++pair) {
        const auto& range = newest[pair];
        if (!range || range->pulse_sample <= counted_until_[pair] || range->pulse_sample < 0)
            continue;
        counted_until_[pair] = range->pulse_sample;
        const int64_t step = range->pulse_sample / step_samples_;
        Cell& into = cells_[at(range->source, step)];
        if (into.step > step)
            continue;  // older than the window
        if (into.step != step)
            into = {step, 0, 0};
        into.sum += range->confidence();
        ++into.count;
        newest_step_ = std::max(newest_step_, step);
    }
}

void HeardWindow::advanceTo(int64_t sample) {
    newest_step_ = std::max(newest_step_, sample / step_samples_);
}

std::optional<double> HeardWindow::confidence(int source, int step) const {
    const int64_t wanted = newest_step_ - step_count_ + 1 + step;
    if (wanted < 0)
        return std::nullopt;
    const Cell& found = cells_[at(source, wanted)];
    if (found.step != wanted || found.count == 0)
        return std::nullopt;
    return found.sum / found.count;
}

}  // namespace noctule
