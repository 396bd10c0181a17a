// SPDX-License-Identifier: Apache-2.0
// What is to be recorded in a session, and how much of it has been. As text a shot is a line, with "x3" at
// its end when three takes of it are wanted, so that a list can come from any document and go back to one.
#pragma once

#include <string>
#include <vector>

#include "core/session/session.h"

namespace noctule {

inline constexpr int kMostTakesOfShot = 99;
/// Of a take's meta: the name of the shot it was recorded for.
inline constexpr const char* kShotKey = "x_shot";

/// One shot a line. Bullets and numbers in front are left out; "x3", "3x", "(3)" or a column of its own say
/// how many takes; of lines that are the same the first one counts for all.
std::vector<Shot> shotsFromText(const std::string& text);
std::string textOf(const std::vector<Shot>& shots);
/// The same list with what only the file knows of shots that were there before.
std::vector<Shot> withUnknownMembers(std::vector<Shot> shots, const std::vector<Shot>& before);

/// Takes of the session that count for the shot.
int keptTakes(const Session& session, const std::string& shot);
/// Kept of wanted, over the list; a shot never counts for more than is wanted of it.
struct ShotProgress {
    int kept = 0, wanted = 0;
};
ShotProgress progressOf(const Session& session);
/// Which shot is due: `current` while takes of it are missing, else the first one after it that misses some,
/// else the first at all; -1: none is missing.
int dueShot(const Session& session, int current);

/// What takes of a shot are called: "Turn, both ways" -> "turn".
std::string takeBaseOf(const Shot& shot);

}  // namespace noctule
