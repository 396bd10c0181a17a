// SPDX-License-Identifier: Apache-2.0
// Pictures in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace noctule {

struct PictureSize {
    int width_px = 1, height_px = 1;
    double aspect() const { return static_cast<double>(width_px) / height_px; }
    bool operator==(const PictureSize&) const = default;
};

/// 8 bits each of red, green, blue, alpha; first row on top.
struct Picture {
    int width_px = 0, height_px = 0;
    std::vector<uint8_t> rgba;

    const uint8_t* at(int x, int y) const {
        return rgba.data() +
               4 * (static_cast<size_t>(y) * static_cast<size_t>(width_px) + static_cast<size_t>(x));
    }
};

/// 8 bits of brightness; first row on top.
struct GreyPicture {
    int width_px = 0, height_px = 0;
    std::vector<uint8_t> brightness;
};

}  // namespace noctule
