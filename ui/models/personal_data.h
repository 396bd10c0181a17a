// SPDX-License-Identifier: Apache-2.0
// Takes out of a text what says who somebody is: names that users gave, folders and files, the user's own
// name. The log is written with it, and a diagnosis that is passed on.
#pragma once

#include <QStringList>

#include "core/session/session.h"

namespace noctule::ui {

/// What users named: the session and its folder, performers, takes, shots.
QStringList namesOf(const Session& session);
/// Those of a session that is not open, as far as its folder can be read.
QStringList namesInFolder(const QString& folder);

/// names[N] becomes "[name-N]", in any case and also within longer words joined by "_" or "-". Paths become
/// "[path]/*" with the suffix of a known format, other files "*" with it, the user's name "[user]",
/// and what stands between curly quotes "[quoted]". Of a
/// folder whose name has spaces, at a path's end, words in lower case stay.
QString withoutPersonalData(const QString& text, const QStringList& names);

}  // namespace noctule::ui
