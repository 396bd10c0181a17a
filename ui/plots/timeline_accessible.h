// SPDX-License-Identifier: Apache-2.0
// What a screen reader sees of the Timeline: a slider in seconds whose value reads as a time.
#pragma once

namespace noctule::ui {

struct TimelineAccessible {
    /// Makes Qt ask for our interface; any number of times.
    static void install();
};

}  // namespace noctule::ui
