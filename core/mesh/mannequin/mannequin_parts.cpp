// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/mannequin/mannequin_parts.h"

namespace noctule {

Part ellipsoid(const std::string& joint, const Vector3d& centre_m, const Vector3d& radii_m, double blend_m,
               const Vector3d& turn_deg, bool both_sides, PartUse use) {
    return {.joint = joint,
            .origin_m = centre_m,
            .turn_deg = turn_deg,
            .first_cap_m = radii_m.y(),
            .last_cap_m = radii_m.y(),
            .blend_m = blend_m,
            .both_sides = both_sides,
            .sections = {{0, 0, 0, radii_m.x(), radii_m.z(), radii_m.z()}},
            .use = use};
}

std::vector<Part> trunkParts() {
    return {
        // from the crotch over pelvis, waist, rib cage and neck into the skull
        {.joint = "Hips",
         .axes = PartAxes::kUpward,
         .first_cap_m = 0.125,
         .last_cap_m = 0.03,
         .corner = 2.15,
         .both_sides = false,
         .sections = {{-0.01, 0, 0, 0.157, 0.106, 0.095},
                      {0.04, 0, 0, 0.152, 0.110, 0.091},
                      {0.09, 0, 0, 0.141, 0.111, 0.084},
                      {0.14, 0, 0, 0.136, 0.110, 0.082},
                      {0.19, 0, 0, 0.141, 0.111, 0.088},
                      {0.25, 0, 0, 0.153, 0.113, 0.100},
                      {0.31, 0, 0, 0.165, 0.111, 0.110},
                      {0.36, 0, 0, 0.164, 0.101, 0.111},
                      {0.41, 0, 0, 0.136, 0.078, 0.098},
                      {0.45, 0, -0.006, 0.090, 0.058, 0.074},
                      {0.485, 0, -0.012, 0.064, 0.052, 0.060},
                      {0.53, 0, -0.011, 0.056, 0.050, 0.055},
                      {0.58, 0, -0.008, 0.054, 0.050, 0.056},
                      {0.64, 0, -0.006, 0.052, 0.046, 0.050}}},
        // slope from neck to shoulder
        {.joint = "Chest",
         .axes = PartAxes::kOutward,
         .origin_m = {0.03, 0.292, -0.022},
         .turn_deg = {0, 0, -20},
         .first_cap_m = 0.04,
         .last_cap_m = 0.04,
         .blend_m = 0.06,
         .sections = {{0, 0, 0, 0.028, 0.030, 0.034},
                      {0.07, 0, 0, 0.030, 0.036, 0.040},
                      {0.13, 0, 0, 0.033, 0.040, 0.042}}},
        ellipsoid("Chest", {0.080, 0.155, 0.064}, {0.086, 0.058, 0.033}, 0.06, {0, 16, -8}),  // breast
        ellipsoid("Chest", {0.104, 0.125, -0.040}, {0.054, 0.120, 0.046}, 0.10, {0, 0, 8}),   // broad back
        ellipsoid("Chest", {0.066, 0.165, -0.080}, {0.054, 0.080, 0.028}, 0.06, {0, 0, 0}),  // shoulder blade
    };
}

std::vector<Part> headParts() {
    return {
        // from the chin to the crown
        {.joint = "Head",
         .axes = PartAxes::kUpward,
         .first_cap_m = 0.020,
         .last_cap_m = 0.082,
         .blend_m = 0.040,
         .corner = 2.12,
         .both_sides = false,
         .sections = {{0.018, 0, 0.042, 0.043, 0.046, 0.044},
                      {0.036, 0, 0.034, 0.0495, 0.055, 0.050},
                      {0.056, 0, 0.027, 0.0565, 0.065, 0.056},
                      {0.078, 0, 0.019, 0.0635, 0.074, 0.069},
                      {0.105, 0, 0.010, 0.070, 0.084, 0.088},
                      {0.135, 0, 0.004, 0.0745, 0.092, 0.095},
                      {0.163, 0, 0.001, 0.0755, 0.095, 0.097}}},
        ellipsoid("Head", {0.032, 0.118, 0.110}, {0.021, 0.011, 0.014}, 0.035, {0, 18, 0}, true,
                  PartUse::kCarve),                                                              // eye
        ellipsoid("Head", {0, 0.090, 0.094}, {0.010, 0.030, 0.013}, 0.022, {-12, 0, 0}, false),  // nose
        ellipsoid("Head", {0.072, 0.108, -0.008}, {0.006, 0.026, 0.015}, 0.014, {-8, 16, -6}),   // ear
    };
}

}  // namespace noctule
