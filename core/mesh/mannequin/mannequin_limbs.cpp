// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/mannequin/mannequin_parts.h"

namespace noctule {
namespace {

/// A finger of three links, a little bent towards the palm; `spread_deg` fans it out in the palm's plane.
Part finger(const Vector3d& knuckle_m, double length_m, double radius_m, double spread_deg) {
    const double r = radius_m, l = length_m;
    return {.joint = "LeftHand",
            .axes = PartAxes::kOutward,
            .origin_m = knuckle_m,
            .turn_deg = {0, -spread_deg, 0},
            .first_cap_m = r,
            .last_cap_m = 0.8 * r,
            .blend_m = 0.008,
            .sections = {{-0.01, 0, 0, r, r, r},
                         {0.35 * l, -0.02 * l, 0, r, r, r},
                         {0.70 * l, -0.10 * l, 0, 0.92 * r, 0.92 * r, 0.92 * r},
                         {l - 0.8 * r, -0.23 * l, 0, 0.75 * r, 0.80 * r, 0.80 * r}}};
}

/// Ends `tip_m` before the ankle, on the floor.
Part toe(double across_m, double tip_m, double half_width_m, double height_m) {
    return {.joint = "LeftFoot",
            .axes = PartAxes::kForward,
            .origin_m = {across_m, -0.06 + 0.5 * height_m, 0},
            .first_cap_m = 0.010,
            .last_cap_m = half_width_m,
            .blend_m = 0.008,
            .corner = 2.2,
            .sections = {{tip_m - 0.045, 0, 0, 0.9 * half_width_m, 0.6 * height_m, 0.5 * height_m},
                         {tip_m - half_width_m, 0, 0, half_width_m, 0.5 * height_m, 0.5 * height_m}}};
}

}  // namespace

std::vector<Part> armParts() {
    return {
        // from the shoulder over the elbow (at 0.29) to the wrist
        {.joint = "LeftArm",
         .axes = PartAxes::kOutward,
         .first_cap_m = 0.04,
         .last_cap_m = 0.02,
         .blend_m = 0.045,
         .sections = {{-0.03, 0, -0.002, 0.046, 0.044, 0.045},
                      {0.03, 0, -0.002, 0.051, 0.049, 0.050},
                      {0.09, -0.002, 0, 0.048, 0.048, 0.050},
                      {0.16, -0.003, 0, 0.041, 0.046, 0.044},
                      {0.23, -0.001, 0, 0.036, 0.039, 0.040},
                      {0.28, 0, 0, 0.034, 0.036, 0.038},
                      {0.33, 0, 0.003, 0.038, 0.039, 0.038},
                      {0.38, 0, 0.004, 0.037, 0.039, 0.037},
                      {0.45, 0, 0.002, 0.029, 0.032, 0.031},
                      {0.51, 0, 0, 0.022, 0.027, 0.027},
                      {0.55, 0, 0, 0.019, 0.027, 0.027}}},
        ellipsoid("LeftArm", {0.030, 0.009, -0.002}, {0.075, 0.044, 0.050}, 0.05,
                  {0, 0, -6}),  // shoulder cap
    };
}

std::vector<Part> handParts() {
    return {
        {.joint = "LeftHand",
         .axes = PartAxes::kOutward,
         .first_cap_m = 0.02,
         .last_cap_m = 0.012,
         .blend_m = 0.02,
         .corner = 2.4,
         .sections = {{0.00, 0, 0, 0.020, 0.027, 0.027},
                      {0.03, 0, 0, 0.019, 0.036, 0.033},
                      {0.06, 0, 0, 0.016, 0.041, 0.038},
                      {0.085, -0.001, 0, 0.013, 0.041, 0.039}}},
        finger({0.088, 0.000, 0.0310}, 0.076, 0.0092, 7),
        finger({0.092, 0.001, 0.0105}, 0.086, 0.0095, 2),
        finger({0.089, 0.000, -0.0100}, 0.078, 0.0090, -3),
        finger({0.083, -0.002, -0.0290}, 0.062, 0.0080, -9),
        ellipsoid("LeftHand", {0.032, -0.008, 0.028}, {0.034, 0.016, 0.018}, 0.02,
                  {0, -25, 0}),  // thumb's ball
        {.joint = "LeftHand",
         .axes = PartAxes::kOutward,
         .origin_m = {0.030, -0.008, 0.034},
         .turn_deg = {0, -48, -14},
         .first_cap_m = 0.012,
         .last_cap_m = 0.009,
         .blend_m = 0.016,
         .sections = {{0, 0, 0, 0.0135, 0.0135, 0.0135},
                      {0.035, 0, 0, 0.0115, 0.0115, 0.0115},
                      {0.066, 0, 0, 0.0092, 0.0098, 0.0098}}},
    };
}

std::vector<Part> legParts() {
    return {
        // from the hip over the knee (at -0.43) into the foot
        {.joint = "LeftUpLeg",
         .axes = PartAxes::kUpward,
         .first_cap_m = 0.02,
         .last_cap_m = 0.13,
         .blend_m = 0.09,
         .corner = 2.1,
         .sections = {{-0.90, 0, -0.008, 0.030, 0.032, 0.032},
                      {-0.86, 0, -0.006, 0.030, 0.034, 0.036},
                      {-0.80, 0, -0.006, 0.030, 0.031, 0.034},
                      {-0.73, 0, -0.006, 0.034, 0.033, 0.038},
                      {-0.63, 0.001, -0.004, 0.045, 0.040, 0.052},
                      {-0.55, 0.001, -0.003, 0.051, 0.043, 0.058},
                      {-0.47, 0, 0.001, 0.049, 0.047, 0.050},
                      {-0.42, -0.001, 0.005, 0.049, 0.050, 0.047},
                      {-0.35, -0.001, 0.007, 0.056, 0.059, 0.057},
                      {-0.25, 0.000, 0.009, 0.069, 0.073, 0.070},
                      {-0.14, 0.003, 0.008, 0.079, 0.083, 0.081},
                      {-0.06, 0.006, 0.002, 0.076, 0.079, 0.082}}},
        ellipsoid("LeftUpLeg", {-0.010, -0.012, -0.050}, {0.078, 0.086, 0.060}, 0.06, {8, 0, 0}),  // buttock
        ellipsoid("LeftLeg", {0, 0.008, 0.040}, {0.026, 0.036, 0.014}, 0.04),                      // knee cap
        ellipsoid("LeftLeg", {-0.021, -0.130, -0.034}, {0.026, 0.085, 0.026}, 0.04),  // inner calf
        ellipsoid("LeftLeg", {0.023, -0.115, -0.032}, {0.024, 0.075, 0.025}, 0.04),   // outer calf
    };
}

std::vector<Part> footParts() {
    return {
        {.joint = "LeftFoot",
         .axes = PartAxes::kForward,
         .origin_m = {0, -0.06, 0},
         .turn_deg = {0, 3, 0},
         .first_cap_m = 0.026,
         .last_cap_m = 0.018,
         .blend_m = 0.045,
         .corner = 2.3,
         .sections = {{-0.032, 0, 0.030, 0.026, 0.030, 0.030},
                      {0.000, 0.001, 0.038, 0.030, 0.036, 0.036},
                      {0.050, 0.003, 0.034, 0.034, 0.030, 0.028},
                      {0.100, 0.002, 0.024, 0.042, 0.022, 0.022},
                      {0.145, 0.001, 0.015, 0.044, 0.014, 0.015}}},
        ellipsoid("LeftFoot", {-0.027, 0.012, 0.000}, {0.008, 0.014, 0.012}, 0.03),  // inner ankle
        ellipsoid("LeftFoot", {0.027, 0.004, -0.008}, {0.009, 0.014, 0.012}, 0.03),  // outer ankle
        toe(-0.022, 0.196, 0.0150, 0.027),
        toe(0.003, 0.191, 0.0095, 0.021),
        toe(0.020, 0.184, 0.0088, 0.020),
        toe(0.034, 0.175, 0.0083, 0.019),
        toe(0.046, 0.163, 0.0085, 0.018),
    };
}

}  // namespace noctule
