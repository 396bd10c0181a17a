// SPDX-License-Identifier: Apache-2.0
// The shape of the default body as a table: every part is a bar of elliptic cross-sections (a loft) that lies
// in the frame of one joint of the default actor, 1.75 m tall. Parts of the left side stand for both sides.
#pragma once

#include <string>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

/// A cross-section of a part, in metres: where along the axis it stands, the offset of its centre, and how
/// far it reaches from there.
struct Section {
    double along_m;
    double across_m, front_m;  ///< centre
    double half_width_m;       ///< to both sides of `across`
    double to_front_m, to_back_m;
};

/// The directions of a part before it is turned.
enum class PartAxes {
    kUpward,   ///< along Y, across X, front Z: trunk, head, legs
    kOutward,  ///< along X, across Y, front Z: arms
    kForward,  ///< along Z, across X, front Y: feet
};

/// How a part meets those listed before it.
enum class PartUse { kAdd, kCarve };

struct Part {
    std::string joint;  ///< its frame; "Left..." joints stand for both sides
    PartAxes axes = PartAxes::kUpward;
    Vector3d origin_m = Vector3d::Zero();    ///< in the joint's frame
    Vector3d turn_deg = Vector3d::Zero();    ///< rotation vector, after the axes
    double first_cap_m = 0, last_cap_m = 0;  ///< length of the domes beyond the first and the last section
    double blend_m = 0;                      ///< width of the fillet to what comes before
    double corner = 2;                       ///< exponent of the cross-section: 2 ellipse, larger squarer
    bool both_sides = true;                  ///< mirrored to the right
    std::vector<Section> sections = {};      ///< sorted by along_m
    PartUse use = PartUse::kAdd;
};

std::vector<Part> trunkParts();
std::vector<Part> headParts();
std::vector<Part> armParts();
std::vector<Part> handParts();
std::vector<Part> legParts();
std::vector<Part> footParts();

/// A single ellipsoid of radii along X, Y and Z.
Part ellipsoid(const std::string& joint, const Vector3d& centre_m, const Vector3d& radii_m, double blend_m,
               const Vector3d& turn_deg = Vector3d::Zero(), bool both_sides = true,
               PartUse use = PartUse::kAdd);

}  // namespace noctule
