// SPDX-License-Identifier: Apache-2.0
// Colours of text and of states by meaning, for widgets that take one as an argument.
#pragma once

#include <QColor>
#include <QString>

namespace noctule::ui {

/// Colour of text: values t1, labels t2, hints t3; the last five carry a meaning.
enum class Ink { kValue, kLabel, kHint, kAccent, kOnAccent, kOk, kWarn, kError };

/// State of a thing. Never by colour alone: iconOf() belongs beside it.
enum class Tone { kNeutral, kAccent, kOk, kWarn, kError };

/// Of words about a thing in this state.
Ink inkOf(Tone tone);
QColor colorOf(Ink ink);
QColor colorOf(Tone tone);
/// Surface behind a chip or card of this tone.
QColor backgroundOf(Tone tone);
/// "check", "warn", "error", "info" (also for kNeutral and kAccent).
QString iconOf(Tone tone);

}  // namespace noctule::ui
