// SPDX-License-Identifier: Apache-2.0
// Table 1 of Vlasic et al. 2007: orientation differences to an optical system over a 30-second motion, mean
// and deviation in degrees, for three joints. The paper's neck is our Head joint.
#pragma once

#include <array>
#include <string>

namespace noctule {

inline constexpr std::array<const char*, 3> kPaperJoints = {"Head", "RightArm", "LeftUpLeg"};

struct PaperRow {
    const char* sensors;
    std::array<double, 3> mean_deg, std_deg;  ///< of kPaperJoints
};

/// In the paper's order.
inline constexpr std::array<PaperRow, 7> kPaperTable1 = {{
    {"A", {159.7, 168.6, 184.0}, {147.7, 105.9, 146.0}},
    {"AD", {74.0, 178.6, 165.5}, {125.4, 110.9, 144.5}},
    {"D", {120.2, 54.7, 117.4}, {93.4, 37.0, 79.2}},
    {"G", {25.9, 10.1, 8.3}, {15.9, 7.0, 8.0}},
    {"GD", {18.4, 8.1, 9.8}, {7.4, 5.8, 5.4}},
    {"AG", {9.5, 10.9, 5.6}, {3.4, 6.4, 4.0}},
    {"AGD", {5.7, 8.0, 6.6}, {2.9, 5.0, 3.8}},
}};

/// Place in the paper's order; 7 when it has no such row.
inline size_t paperOrder(const std::string& sensors) {
    for (size_t i = 0; i < kPaperTable1.size(); ++i)
        if (sensors == kPaperTable1[i].sensors)
            return i;
    return kPaperTable1.size();
}

}  // namespace noctule
