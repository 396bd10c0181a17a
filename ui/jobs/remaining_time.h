// SPDX-License-Identifier: Apache-2.0
// How long a job still takes, told from how far it came in the time so far. What it says changes calmly: a
// jump of the estimate is followed within about two seconds.
#pragma once

#include <optional>

namespace noctule::ui {

class RemainingTime {
public:
    /// `elapsed_s` never falls. A fraction that falls is the beginning of another stage.
    void report(double elapsed_s, double fraction);
    /// Absent for the first second of a stage and while less than 2 % of it is done.
    std::optional<int> seconds() const;

private:
    double began_s_ = 0, now_s_ = 0, fraction_ = 0;
    std::optional<double> left_s_;
};

}  // namespace noctule::ui
