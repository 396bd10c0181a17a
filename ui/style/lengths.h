// SPDX-License-Identifier: Apache-2.0
// Lengths of people and rooms as the studio shows and reads them: metric, or feet and inches when that is
// chosen in Preferences. Errors of measurement stay in millimetres; files and the command line stay metric.
#pragma once

#include <QString>
#include <optional>

namespace noctule::ui {

enum class Units { kMetric, kImperial };

inline constexpr double kMetresPerInch = 0.0254, kMetresPerFoot = 12 * kMetresPerInch;

/// Kept in the settings and read from them once; metric by default. What is on the screen already stays as it
/// is.
Units chosenUnits();
void chooseUnits(Units units);

/// Metres in, "1.78 m" out; else "5′10.1″", below a yard "20.5″".
QString lengthText(double metres, int decimals = 2, Units units = chosenUnits());
/// Metres in, "25.0 cm" out, for parts of a body; else as above.
QString shortLengthText(double metres);
/// Metres of a text such as 180 cm, 1.8 m, 5'11", 5 ft 11 in or 71 in, whatever the units; nothing where it
/// is none. `bare_m`: the unit of a number without one.
std::optional<double> lengthFrom(const QString& text, double bare_m);

}  // namespace noctule::ui
