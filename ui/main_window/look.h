// SPDX-License-Identifier: Apache-2.0
// Dark or light, size of text, and motion, as they were chosen in the preferences.
#pragma once

#include <QSettings>

namespace noctule::ui {

/// Hands to the theme what the settings hold; what they do not hold stays as it is.
void applyLook(const QSettings& settings);
/// Keeps what the theme shows now.
void keepLook(QSettings& settings);

}  // namespace noctule::ui
