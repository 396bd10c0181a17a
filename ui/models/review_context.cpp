// SPDX-License-Identifier: Apache-2.0
#include "ui/models/review_context.h"

#include <QFileInfo>
#include <QPointer>
#include <filesystem>
#include <utility>

#include "core/recording/recover_take.h"
#include "core/recording/take.h"
#include "core/session/take_folder.h"
#include "ui/language/core_words.h"

namespace noctule::ui {

ReviewContext::ReviewContext(SharedContext& shared)
    : shared_(shared),
      take_(shared.jobs(), time_),
      changes_(shared.jobs(), shared.session(), take_),
      markers_(changes_, take_),
      contacts_(changes_, take_, time_) {
    SessionModel& session = shared.session();
    QObject::connect(&session, &SessionModel::currentTakeChanged, &here_, [this](int index) {
        unreadable_ = {};
        openChosenTake(index);
        tellTorn(index);
    });
    QObject::connect(&session, &SessionModel::recoveryChanged, &here_, [this, &session](int index) {
        if (index >= 0 && index == session.currentTake())
            openChosenTake(index);
    });
    QObject::connect(&session, &SessionModel::takeRenamed, &here_,
                     [this](const QString& before, const QString& now) {
                         if (take_.path() == before)
                             take_.followMove(now);
                         if (unreadable_.path == before)
                             unreadable_.path = now;
                     });
    QObject::connect(&changes_, &TakeChanges::failed, &here_,
                     [&shared](const QString& what, const QString& remedy) {
                         emit shared.failed(what, remedy, About::kTake);
                     });
    QObject::connect(&session, &SessionModel::warned, &here_,
                     [&shared](const QString& what) { emit shared.warned(what, About::kTakes); });
    // What is written may have been ordered before what failed: only a new order tries it anew.
    QObject::connect(&changes_, &TakeChanges::ordered, &here_,
                     [&shared] { emit shared.settled(About::kTake); });
    QObject::connect(&take_, &TakeDocument::opened, &here_, [this] { followTake(); });
    QObject::connect(&take_, &TakeDocument::runsChanged, &here_, [this] { keepShownResult(); });
    QObject::connect(&take_, &TakeDocument::torn, &shared, &SharedContext::tornTake);
    QObject::connect(&shared, &SharedContext::tornTake, &here_,
                     [this](const QString& path, const QString& why) {
                         if (!take_.isOpen())
                             unreadable_ = {path, why};
                     });
}

/// A damaged take of the session is not opened, so nothing else says why nothing is shown.
void ReviewContext::tellTorn(int index) {
    const SessionModel& session = shared_.session();
    if (index < 0)
        return;
    const SessionTake& take = session.session().takes[static_cast<size_t>(index)];
    if (take.is_torn && !session.isRecovering(take.name))
        emit shared_.tornTake(session.takePath(index), coreWords(take.problem));
}

void ReviewContext::openLoose(const QString& path) {
    emit shared_.settled(About::kFile);
    const int asked = ++asked_;
    shared_.jobs().start<Done>(
        {TakeDocument::tr("Opening %1"), QFileInfo(path).fileName()},
        [path](const JobContext&) -> Status {
            const auto take = Take::open(path.toStdString());
            return take ? Status(Done{}) : Status(take.error());
        },
        [here = QPointer(&here_), this, path, asked](const Status& is_take) -> QString {
            if (!here || asked != asked_ || (!is_take && is_take.error().kind == ErrorKind::kCancelled))
                return {};
            if (is_take) {
                showLoose(path);
                shared_.goTo(Step::kReview);
            } else if (is_take.error().is_damage) {
                take_.noteDamage(path, is_take.error());
            } else {
                emit shared_.failed(coreWords(is_take.error().message), coreWords(is_take.error().remedy),
                                    About::kFile);
            }
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void ReviewContext::showLoose(const QString& path) {
    shared_.session().setCurrentTake(-1);
    take_.open(path);
}

void ReviewContext::saveReadable(const QString& path) {
    SessionModel& session = shared_.session();
    const int takes = session.isOpen() ? static_cast<int>(session.session().takes.size()) : 0;
    for (int take = 0; take < takes; ++take)
        if (QFileInfo(session.takePath(take)) == QFileInfo(path)) {
            session.recover(take);
            return;
        }
    emit shared_.settled(About::kTake);
    const QString name = QFileInfo(path).completeBaseName();
    struct Saved {
        QString path;
        Recovery losses;
    };
    shared_.jobs().start<Saved>(
        {SessionModel::tr("Recovering %1"), name},
        [path, name](const JobContext& job) -> Result<Saved> {
            const std::filesystem::path folder = QFileInfo(path).absolutePath().toStdString();
            const std::string copy = nextTakePath(folder, name.toStdString() + "_recovered").string();
            const Result<Recovery> saved = recoverTake(path.toStdString(), copy, job);
            if (!saved)
                return saved.error();
            return Saved{QString::fromStdString(copy), *saved};
        },
        [here = QPointer(&here_), this, shown = take_.path(), name](Result<Saved> copy) -> QString {
            if (!here || (!copy && copy.error().kind == ErrorKind::kCancelled))
                return {};
            if (!copy) {
                emit shared_.failed(
                    SessionModel::tr("%1 could not be recovered; its file stays as it is").arg(name),
                    coreWords(copy.error()), About::kTake);
                return {};
            }
            if (!take_.isOpen() || take_.path() == shown)  // else the operator has gone on with another one
                showLoose(copy->path);
            if (shown.isEmpty())
                shared_.goTo(Step::kReview);
            if (copy->losses)
                emit shared_.warned(SessionModel::savedInWords(name, *copy->losses), About::kTakes);
            return SessionModel::tr("%1 is recovered").arg(name);
        });
}

/// What went wrong with another take is not of this one.
void ReviewContext::followTake() {
    if (take_.isOpen())
        unreadable_ = {};
    if (std::exchange(seen_path_, take_.path()) == take_.path())
        return;
    emit shared_.settled(About::kTake);
    emit shared_.settled(About::kProcess);
}

/// For exports while another take is open, and for the next time. The last one is not named, so that a newer
/// one is shown once there is one.
void ReviewContext::keepShownResult() {
    if (!take_.isOpen() || take_.shownRun() < 0)
        return;
    const auto& runs = take_.overview()->runs;
    const auto shown = static_cast<size_t>(take_.shownRun());
    shared_.session().keepShownResult(
        shared_.session().indexOf(take_.path()),
        shown + 1 == runs.size() ? QString() : QString::fromStdString(runs[shown].run.name));
}

/// The take chosen in the session is the one under review; a damaged one is listed only.
void ReviewContext::openChosenTake(int index) {
    if (index >= 0)
        ++asked_;
    const SessionModel& session = shared_.session();
    const SessionTake* chosen = index < 0 ? nullptr : &session.session().takes[static_cast<size_t>(index)];
    // Read while its file is replaced it would not be there.
    if (!chosen || chosen->state == TakeState::kDamaged || session.isRecovering(chosen->name)) {
        take_.close();
        return;
    }
    const QString path = QString::fromStdString(session.session().pathOf(*chosen).string());
    if (take_.path() != path)
        take_.open(path, chosen->shown_result);
}

}  // namespace noctule::ui
