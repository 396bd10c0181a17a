// SPDX-License-Identifier: Apache-2.0
// Takes that go to another session.
#include <QDir>

#include "core/session/take_transfer.h"
#include "ui/language/core_words.h"
#include "ui/models/session_marker.h"
#include "ui/models/session_model.h"

namespace noctule::ui {
namespace {

QString shownAs(const std::string& text) {
    return QString::fromStdString(text);
}

/// Another window saves from memory: what came from here would be lost from its list.
Status mayWriteInto(const std::filesystem::path& folder) {
    const QString path = shownAs(folder.string());
    if (!SessionMarker::isOpenElsewhere(path))
        return Done{};
    return Error{ErrorKind::kUsage,
                 SessionModel::tr("“%1” is open in another window")
                     .arg(SessionModel::nameOfSession(path))
                     .toStdString(),
                 SessionModel::tr("Close it there first").toStdString()};
}

/// Arranged, and where only a copy can go there, copied.
Result<TakeTransfer> prepared(const Session& from, const std::string& name, const std::filesystem::path& to,
                              SessionModel::Transfer how, const JobContext& job) {
    if (Status may = mayWriteInto(to); !may)
        return may.error();
    auto transfer = arrangeTransfer(from, name, to);
    if (!transfer || (how == SessionModel::Transfer::kMove && canBeRenamed(from, *transfer)))
        return transfer;
    if (Status copied = copyThere(from, *transfer, job); !copied)
        return copied.error();
    return transfer;
}

/// Where it is now, and why it may be called otherwise.
QString outcomeOf(const TakeTransfer& transfer) {
    const QString before = shownAs(transfer.original.name), session = shownAs(transfer.to_name);
    if (transfer.take.name == transfer.original.name)
        return SessionModel::tr("%1 is in “%2”", "take, session").arg(before, session);
    return SessionModel::tr("%1 is in “%2” as %3: the name was taken there, and both are kept",
                            "take, session, name of the take there")
        .arg(before, session, shownAs(transfer.take.name));
}

/// Of a move that ended after copying.
QString leftOf(const TakeTransfer& transfer) {
    return SessionModel::tr("A copy of %1 is in “%2”; the take also stays where it was", "take, session")
        .arg(shownAs(transfer.original.name), shownAs(transfer.to_name));
}

}  // namespace

QString SessionModel::nameOfSession(const QString& folder) {
    const auto session = readSession(folder.toStdString());
    return session && !session->name.empty() ? shownAs(session->name) : QDir(folder).dirName();
}

void SessionModel::transferTake(int take, const QString& folder, Transfer how) {
    if (!session_ || take < 0 || take >= static_cast<int>(session_->takes.size()))
        return;
    emit triedAnew();
    const std::string name = session_->takes[static_cast<size_t>(take)].name;
    const bool moves = how == Transfer::kMove;
    // A job may write into it, so a copy would be torn.
    if (const Status may = mayMove(name); !may) {
        emit failed(coreWords(may.error()));
        return;
    }
    // Held by one only, so that it ends before the take itself moves.
    const auto kept = std::make_shared<std::shared_ptr<void>>(keepInPlace(takePath(take)));
    jobs_.start<TakeTransfer>(
        {moves ? tr("Moving %1 to %2") : tr("Copying %1 to %2"), shownAs(name), nameOfSession(folder)},
        [from = *session_, name, to = std::filesystem::path(QDir::cleanPath(folder).toStdString()),
         how](const JobContext& job) { return prepared(from, name, to, how, job); },
        [model = QPointer(this), name, moves, home = session_->folder,
         kept](Result<TakeTransfer> transfer) -> QString {
            kept->reset();
            if (!model)
                return {};
            if (!transfer) {
                model->tell((moves ? tr("%1 was not moved") : tr("%1 was not copied")).arg(shownAs(name)),
                            transfer.error());
                return {};
            }
            const bool is_here =
                model->session_ && model->session_->folder == home && model->session_->findTake(name) >= 0;
            if (moves && is_here)
                return model->pushMove(*transfer);
            if (moves)
                return transfer->is_copied
                           ? leftOf(*transfer)
                           : tr("%1 was not moved: its session was closed meanwhile").arg(shownAs(name));
            return outcomeOf(*transfer);
        });
}

/// `transfer` was arranged some time ago: its take may have been rated meanwhile.
QString SessionModel::pushMove(TakeTransfer transfer) {
    followList(*session_, transfer);
    const std::string name = transfer.original.name;
    push(
        tr("Move %1 to “%2”").arg(shownAs(name), shownAs(transfer.to_name)),
        [this, transfer, name](Session& session) {
            Status may = mayMove(name);
            if (may)
                may = mayWriteInto(transfer.to);
            return may ? moveThere(session, transfer) : may;
        },
        [transfer](Session& session) {
            const Status may = mayWriteInto(transfer.to);
            return may ? moveBack(session, transfer) : may;
        });
    if (session_->findTake(name) >= 0)  // failed() has said why
        return transfer.is_copied ? leftOf(transfer) : QString();
    const QString outcome = outcomeOf(transfer);
    emit takeMoved(outcome);
    return outcome;
}

}  // namespace noctule::ui
