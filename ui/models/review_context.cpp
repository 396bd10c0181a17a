// SPDX-License-Identifier: Apache-2.0
#include "ui/models/review_context.h"

#include <utility>

namespace noctule::ui {

ReviewContext::ReviewContext(SharedContext& shared)
    : shared_(shared),
      take_(shared.jobs(), time_),
      changes_(shared.jobs(), shared.session(), take_),
      markers_(changes_, take_),
      contacts_(changes_, take_, time_) {
    SessionModel& session = shared.session();
    QObject::connect(&session, &SessionModel::currentTakeChanged, &here_,
                     [this](int index) { openChosenTake(index); });
    QObject::connect(&session, &SessionModel::recoveryChanged, &here_, [this, &session](int index) {
        if (index >= 0 && index == session.currentTake())
            openChosenTake(index);
    });
    QObject::connect(&session, &SessionModel::takeRenamed, &here_,
                     [this](const QString& before, const QString& now) {
                         if (take_.path() == before)
                             take_.followMove(now);
                     });
    QObject::connect(&changes_, &TakeChanges::failed, &here_,
                     [&shared](const QString& what, const QString& remedy) {
                         emit shared.failed(what, remedy, About::kTake);
                     });
    // What is written may have been ordered before what failed: only a new order tries it anew.
    QObject::connect(&changes_, &TakeChanges::ordered, &here_,
                     [&shared] { emit shared.settled(About::kTake); });
    QObject::connect(&take_, &TakeDocument::opened, &here_, [this] { followTake(); });
}

/// What went wrong with another take is not of this one.
void ReviewContext::followTake() {
    if (std::exchange(seen_path_, take_.path()) == take_.path())
        return;
    emit shared_.settled(About::kTake);
    emit shared_.settled(About::kProcess);
}

/// The take chosen in the session is the one under review; a damaged one is listed only.
void ReviewContext::openChosenTake(int index) {
    const SessionModel& session = shared_.session();
    const SessionTake* chosen = index < 0 ? nullptr : &session.session().takes[static_cast<size_t>(index)];
    // Read while its file is replaced it would not be there.
    if (!chosen || chosen->state == TakeState::kDamaged || session.isRecovering(chosen->name)) {
        take_.close();
        return;
    }
    const QString path = QString::fromStdString(session.session().pathOf(*chosen).string());
    if (take_.path() != path)
        take_.open(path);
}

}  // namespace noctule::ui
