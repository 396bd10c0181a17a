// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/recovery_words.h"

#include <QCoreApplication>

namespace noctule::ui {
namespace {

struct RecoveryWords {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::RecoveryWords)
};

}  // namespace

QString rebuildOffer(const QString& problem) {
    return RecoveryWords::
        tr("%1. Rebuilding makes a new session.json from what the takes know: performers, suits and the "
           "order of recording. Ratings, notes, in and out are not in the takes; a damaged session.json is "
           "kept beside the new one.",
           "what is wrong and which takes are safe")
            .arg(problem);
}

QString recoverOffer() {
    return RecoveryWords::tr(
        "Recover checks it and makes a whole take of it; the recording itself is kept in the trash of the "
        "session.");
}

}  // namespace noctule::ui
