// SPDX-License-Identifier: Apache-2.0
#include "core/motion/course.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace noctule {
namespace {

Course::Stretch joined(const Course::Stretch& early, const Course::Stretch& late) {
    const double values[] = {early.first, early.second, late.first, late.second};
    const auto [least, most] = std::minmax_element(std::begin(values), std::end(values));
    return {early.time_s, *std::min(least, most), *std::max(least, most)};
}

}  // namespace

void Course::add(double time_s, double value) {
    if (stretches_.size() == kMost) {  // half of the room becomes free
        width_s_ = (stretches_.back().time_s - stretches_.front().time_s) / (kMost / 2.0);
        for (const Stretch& stretch : std::exchange(stretches_, {}))
            append(stretch);
    }
    append({time_s, value, value});
}

void Course::append(const Stretch& late) {
    if (!stretches_.empty() && late.time_s < stretches_.back().time_s + width_s_)
        stretches_.back() = joined(stretches_.back(), late);
    else
        stretches_.push_back(late);
}

}  // namespace noctule
