// SPDX-License-Identifier: Apache-2.0
#include "core/orientation/orientation_score.h"

#include <algorithm>
#include <cmath>

#include "core/job/contract.h"
#include "core/math/rotation.h"

namespace noctule {

namespace {

/// Turn about the vertical within a rotation of the world, -pi..pi.
double headingOf(const Quaterniond& turn_world) {
    return 2 * std::atan2(turn_world.y(), turn_world.w());
}

double inclinationOf(const Quaterniond& turn_world) {
    return 2 * std::acos(std::min(1.0, std::hypot(turn_world.w(), turn_world.y())));
}

double totalOf(const Quaterniond& turn_world) {
    return 2 * std::atan2(turn_world.vec().norm(), std::abs(turn_world.w()));
}

struct Sums {
    double total = 0, heading = 0, inclination = 0;
};

/// Sums of squares of the errors, each turned by `back` first.
Sums squaresOf(const std::vector<Quaterniond>& errors, const Quaterniond& back) {
    Sums sums;
    for (const Quaterniond& error : errors) {
        const Quaterniond turned = back * error;
        sums.total += std::pow(totalOf(turned), 2);
        sums.heading += std::pow(std::remainder(headingOf(turned), 2 * std::numbers::pi), 2);
        sums.inclination += std::pow(inclinationOf(turned), 2);
    }
    return sums;
}

}  // namespace

OrientationScore scoreOrientation(std::span<const Quaterniond> estimate,
                                  std::span<const Quaterniond> reference, const std::vector<char>& counts) {
    require(estimate.size() == reference.size() && (counts.empty() || counts.size() == reference.size()),
            "scoreOrientation: as many estimates as references");
    std::vector<Quaterniond> errors;
    double sine = 0, cosine = 0;
    for (size_t i = 0; i < estimate.size(); ++i) {
        if ((!counts.empty() && !counts[i]) || !reference[i].coeffs().allFinite())
            continue;
        errors.push_back(estimate[i] * reference[i].conjugate());
        const double heading = headingOf(errors.back());
        sine += std::sin(heading);
        cosine += std::cos(heading);
    }
    OrientationScore score;
    score.samples = errors.size();
    if (errors.empty())
        return score;
    const double offset = std::atan2(sine, cosine);
    const Sums given = squaresOf(errors, Quaterniond::Identity());
    const Sums turned = squaresOf(errors, axisAngle(Vector3d::UnitY(), -offset));
    const auto rms_deg = [&](double sum) { return degrees(std::sqrt(sum / double(errors.size()))); };
    score.total_deg = rms_deg(given.total);
    score.heading_deg = rms_deg(given.heading);
    score.inclination_deg = rms_deg(given.inclination);
    score.heading_offset_deg = degrees(offset);
    score.total_turned_deg = rms_deg(turned.total);
    score.heading_turned_deg = rms_deg(turned.heading);
    return score;
}

}  // namespace noctule
