// SPDX-License-Identifier: Apache-2.0
// What a screen reader sees of a PairGrid: a table whose cells have a name and say their pair and value.
#pragma once

namespace noctule::ui {

class PairGrid;

struct PairGridAccessible {
    /// Makes Qt ask for our interface; any number of times.
    static void install();
    static void contentChanged(PairGrid& grid);
    static void currentChanged(PairGrid& grid);
};

}  // namespace noctule::ui
