// SPDX-License-Identifier: Apache-2.0
// Reads resources/style/tokens.json; the confidence ramp.
#pragma once

#include <QByteArray>
#include <array>

#include "ui/style/theme.h"

namespace noctule::ui {

/// High contrast: white on black, and what is not said again as in the dark set.
enum class ColorSet { kDark, kLight, kContrast };

/// Throws std::logic_error naming a colour that is missing or no colour.
Tokens readTokens(const QByteArray& json, ColorSet set);

/// Linear in sRGB between the five colours, first to last; each step is lighter (or darker) than the one
/// before.
std::array<QRgb, 256> confidenceRamp(const std::array<QColor, 5>& colors);

}  // namespace noctule::ui
