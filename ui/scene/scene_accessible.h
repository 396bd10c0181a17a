// SPDX-License-Identifier: Apache-2.0
// Tells assistive technology that a 3D view is a picture, and what is on it.
#pragma once

namespace noctule::ui {

/// Once per program; further calls do nothing.
void installSceneAccessibility();

}  // namespace noctule::ui
