// SPDX-License-Identifier: Apache-2.0
// What hinders a suit, in words: what happened, to which thing, what to do. And boards in a few words each.
#pragma once

#include <QString>

#include "ui/models/live_suits.h"
#include "ui/style/ink.h"

namespace noctule::ui {

/// What the button of a card does.
enum class Repair { kNone, kBlinkBoard, kPlaySource, kCalibrate, kCheck };

struct HindranceWords {
    QString title, text;
    QString action{}, action_icon{};  ///< empty: there is none
    QString accept{};                 ///< "Go on without it"; empty: nothing to accept
    Repair repair = Repair::kNone;
};
HindranceWords wordsOf(const ReadinessProblem& problem, const SuitCheck& check);
/// Of those about the calibration and its check.
HindranceWords fitHindrance(const ReadinessProblem& problem, const SuitCheck& check);

struct VerdictWords {
    Tone tone = Tone::kNeutral;
    QString verdict, text;
};
VerdictWords verdictOf(const SuitCheck& check);
/// Of a suit that records.
VerdictWords recordingVerdictOf(const Readiness& readiness);

/// Of those that are connected the one that stands worst, the one that is looked at before others; it alone
/// where none is connected.
const SuitInUse& worstOf(const LiveSuits& suits);
/// Its verdict, with its performer's name where another one is looked at.
VerdictWords verdictOf(const LiveSuits& suits);

/// Below a board's name on the body: "6 of 8 pairs", "no signal since 10:42:07".
QString boardDetail(const SuitCheck& check, int board);
Tone toneOf(BoardReadiness::State state);

/// For a chip: "Link broken".
QString linkBrokenInShort();
/// Beside what a silent suit told last: battery and climate. Other numbers of it are not known then.
QString lastKnownInShort();
/// "12 % is left, about 40 min. Charge it before a long take."
QString batteryLeft(double percent, std::optional<double> left_s);
/// "3 h 20 min", "45 min", "50 s"
QString durationWords(double seconds);
/// Of how long can still be recorded.
Tone toneOfStorage(double left_s);

}  // namespace noctule::ui
