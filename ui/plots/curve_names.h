// SPDX-License-Identifier: Apache-2.0
// Angles and directions of a motion in words.
#pragma once

#include <QString>

#include "core/review/joint_curves.h"

namespace noctule::ui {

/// "flexion", "turn about z", "height".
QString freedomName(const std::string& freedom);
/// "Left knee, flexion"; of the root "Root, height".
QString curveName(const CurveChoice& choice);
/// Whether it is a freedom of the root: those have the names that joint_curves.h lists.
bool isOfRoot(const CurveChoice& choice);

}  // namespace noctule::ui
