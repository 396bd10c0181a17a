// SPDX-License-Identifier: Apache-2.0
// How long a battery lasts at the rate at which it has been losing charge; a box says percent and no more.
#pragma once

#include <optional>

namespace noctule {

class BatteryForecast {
public:
    /// Times of any clock. Charging begins afresh, and so does what no load can do: another battery.
    void add(double t_s, double percent) {
        if (!first_ || percent > latest_.percent || percent < latest_.percent - kHighestStep_percent)
            first_ = Reading{t_s, percent};
        latest_ = {t_s, percent};
    }
    /// Absent until it has lost enough to tell: a box rounds to whole percents.
    std::optional<double> left_s() const {
        const double lost = first_ ? first_->percent - latest_.percent : 0;
        if (lost < kLeastLoss_percent || latest_.t_s - first_->t_s < kLeastTime_s)
            return std::nullopt;
        return latest_.percent / lost * (latest_.t_s - first_->t_s);
    }

private:
    static constexpr double kLeastLoss_percent = 2, kHighestStep_percent = 1.5, kLeastTime_s = 60;
    struct Reading {
        double t_s = 0, percent = 0;
    };
    std::optional<Reading> first_;
    Reading latest_;
};

}  // namespace noctule
