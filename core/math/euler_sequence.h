// SPDX-License-Identifier: Apache-2.0
// The twelve orders of three turns that write any rotation: six about three different axes (euler.h) and six
// that end about the axis they began with, as ZXZ. Each turn is about the axes that the ones before have
// turned. Angles in radians.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

struct EulerSequence {
    int first = 2, second = 0, third = 1;  ///< 0 = x, 1 = y, 2 = z; neighbours differ

    bool isProper() const { return first == third; }
    bool operator==(const EulerSequence&) const = default;
};

/// "XYZ", "ZXZ", ... in any case; nothing: no such.
std::optional<EulerSequence> eulerSequenceNamed(const std::string& name);
/// All twelve, in capitals.
std::vector<std::string> eulerSequenceNames();

Quaterniond rotationFromAngles(const EulerSequence& sequence, const Vector3d& angles_rad);
/// Of all triples that give this rotation the one nearest to `previous_rad`; where the rotation does not
/// determine the first angle it stays as it was.
Vector3d anglesFromRotation(const EulerSequence& sequence, const Quaterniond& q,
                            const Vector3d& previous_rad);

}  // namespace noctule
