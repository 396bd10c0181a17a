// SPDX-License-Identifier: Apache-2.0
// What the operator changes in a session, each with its way back. Takes are remembered by name and performers
// by place: what lies between a step and its undo has been undone before.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>

#include "core/session/shot_list.h"
#include "core/session/take_folder.h"
#include "ui/language/core_words.h"
#include "ui/models/session_command.h"
#include "ui/models/session_model.h"

namespace noctule::ui {
namespace {

constexpr int kBestRating = 5;

/// Sets a member of a take to `value`.
template <class T>
std::function<Status(Session&)> setOf(const std::string& take, T SessionTake::*member, T value) {
    return [take, member, value = std::move(value)](Session& session) -> Status {
        const int index = session.findTake(take);
        if (index >= 0)
            session.takes[static_cast<size_t>(index)].*member = value;
        return Done{};
    };
}

template <class T>
std::function<Status(Session&)> setOf(T Session::*member, T value) {
    return [member, value = std::move(value)](Session& session) -> Status {
        session.*member = value;
        return Done{};
    };
}

std::function<Status(Session&)> setRange(const std::string& take, double in_s, double out_s) {
    return [take, in_s, out_s](Session& session) -> Status {
        const int index = session.findTake(take);
        if (index >= 0) {
            session.takes[static_cast<size_t>(index)].in_s = in_s;
            session.takes[static_cast<size_t>(index)].out_s = out_s;
        }
        return Done{};
    };
}

/// Also wherever the name stands.
std::function<Status(Session&)> setPerformer(size_t index, const Performer& performer) {
    return [index, performer](Session& session) -> Status {
        Performer& changed = session.performers.at(index);
        if (changed.name != performer.name) {
            for (SessionTake& take : session.takes)
                if (take.performer == changed.name)
                    take.performer = performer.name;
            if (session.current_performer == changed.name)
                session.current_performer = performer.name;
        }
        changed = performer;
        return Done{};
    };
}

std::function<Status(Session&)> insertPerformer(size_t index, const Performer& performer) {
    return [index, performer](Session& session) -> Status {
        session.performers.insert(session.performers.begin() + static_cast<ptrdiff_t>(index), performer);
        return Done{};
    };
}

std::function<Status(Session&)> erasePerformer(size_t index) {
    return [index](Session& session) -> Status {
        session.performers.erase(session.performers.begin() + static_cast<ptrdiff_t>(index));
        return Done{};
    };
}

/// With its report. Nothing is overwritten, and both are moved or none.
Status moveCalibration(const QString& file, const std::filesystem::path& from,
                       const std::filesystem::path& to) {
    const QDir source(QString::fromStdString(from.string())), target(QString::fromStdString(to.string()));
    const auto move = [&](const QString& name, const QDir& here, const QDir& there) {
        return QFile::rename(here.filePath(name), there.filePath(name));
    };
    const auto failed = [&](const QString& name) {
        return Error{ErrorKind::kDisk,
                     SessionModel::tr("%1 was not moved to %2", "file, folder")
                         .arg(name, QDir::toNativeSeparators(target.path()))
                         .toStdString(),
                     SessionModel::tr("See whether that folder can be written and has no file of this name")
                         .toStdString()};
    };
    const QString report = QFileInfo(file).completeBaseName() + ".html";
    if (!source.exists(file) || !target.mkpath(".") || !move(file, source, target))
        return failed(file);
    if (source.exists(report) && !move(report, source, target)) {
        move(file, target, source);
        return failed(report);
    }
    return Done{};
}

bool isIndex(int index, size_t size) {
    return index >= 0 && index < static_cast<int>(size);
}

}  // namespace

/// False: it was not done, and failed() was emitted.
bool SessionModel::push(const QString& what, Step redo, Step undo, const QString& merge_key) {
    if (!apply(redo))
        return false;
    undo_.push(new SessionCommand(*this, what, std::move(redo), std::move(undo), merge_key));
    return true;
}

bool SessionModel::apply(const Step& step) {
    emit triedAnew();
    const Status done = step(*session_);
    if (done)
        noteChange();
    else
        emit failed(coreWords(done.error()));
    return done.ok();
}

void SessionModel::rate(int take, int rating) {
    if (!session_ || !isIndex(take, session_->takes.size()))
        return;
    const SessionTake& rated = session_->takes[static_cast<size_t>(take)];
    rating = std::clamp(rating, 0, kBestRating);
    if (rating != rated.rating)
        push(tr("Rate %1").arg(QString::fromStdString(rated.name)),
             setOf(rated.name, &SessionTake::rating, rating),
             setOf(rated.name, &SessionTake::rating, rated.rating));
}

void SessionModel::setTakeNotes(int take, const QString& notes) {
    if (!session_ || !isIndex(take, session_->takes.size()))
        return;
    const SessionTake& noted = session_->takes[static_cast<size_t>(take)];
    if (notes.toStdString() != noted.notes)
        push(tr("Notes of %1").arg(QString::fromStdString(noted.name)),
             setOf(noted.name, &SessionTake::notes, notes.toStdString()),
             setOf(noted.name, &SessionTake::notes, noted.notes),
             QString("notes/%1").arg(QString::fromStdString(noted.name)));
}

void SessionModel::setTakeRange(int take, double in_s, double out_s, const QString& merge_key) {
    if (!session_ || !isIndex(take, session_->takes.size()))
        return;
    const SessionTake& cut = session_->takes[static_cast<size_t>(take)];
    if (in_s != cut.in_s || out_s != cut.out_s)
        push(tr("In and out of %1").arg(QString::fromStdString(cut.name)), setRange(cut.name, in_s, out_s),
             setRange(cut.name, cut.in_s, cut.out_s), merge_key);
}

void SessionModel::renameSession(const QString& name) {
    if (session_ && name.toStdString() != session_->name)
        push(tr("Rename the session"), setOf(&Session::name, name.toStdString()),
             setOf(&Session::name, session_->name));
}

void SessionModel::setNotes(const QString& notes) {
    if (session_ && notes.toStdString() != session_->notes)
        push(tr("Notes of the session"), setOf(&Session::notes, notes.toStdString()),
             setOf(&Session::notes, session_->notes), "session-notes");
}

void SessionModel::setCalibration(const QString& file, const QString& what) {
    if (session_ && file.toStdString() != session_->calibration)
        push(what, setOf(&Session::calibration, file.toStdString()),
             setOf(&Session::calibration, session_->calibration));
}

void SessionModel::setSuitCalibration(const QString& serial, const QString& file, const QString& what) {
    if (!session_)
        return;
    auto all = session_->suit_calibrations;
    all[serial.toStdString()] = file.toStdString();
    if (all != session_->suit_calibrations)
        push(what, setOf(&Session::suit_calibrations, all),
             setOf(&Session::suit_calibrations, session_->suit_calibrations));
}

QString SessionModel::whyNotAside(const QString& file) const {
    if (!session_)
        return {};
    const auto names = [name = file.toStdString()](const auto& one) { return one.second == name; };
    if (session_->calibration == file.toStdString() ||
        std::ranges::any_of(session_->suit_calibrations, names))
        return tr("New takes are made with it. Use another calibration for them first.");
    return {};
}

bool SessionModel::putCalibrationAside(const QString& file) {
    return session_ &&
           push(
               tr("Put %1 aside").arg(file.section('.', 0, 0)),
               [this, file](Session& session) -> Status {
                   if (const QString why = whyNotAside(file); !why.isEmpty())
                       return Error{ErrorKind::kUsage, tr("%1 is in use").arg(file).toStdString(),
                                    why.chopped(1).toStdString()};
                   return moveCalibration(file, session.calibrationFolder(), session.asideFolder());
               },
               [file](Session& session) {
                   return moveCalibration(file, session.asideFolder(), session.calibrationFolder());
               });
}

void SessionModel::setBody(const SessionBody& body) {
    if (session_ && !(body == session_->body))
        push(tr("Change the body of the view"), setOf(&Session::body, body),
             setOf(&Session::body, session_->body));
}

void SessionModel::addPerformer(const Performer& performer) {
    if (!session_)
        return;
    const size_t index = session_->performers.size();
    push(tr("Add %1").arg(QString::fromStdString(performer.name)), insertPerformer(index, performer),
         erasePerformer(index));
}

void SessionModel::changePerformer(int index, const Performer& performer, const QString& what,
                                   const QString& merge_key) {
    if (!session_ || !isIndex(index, session_->performers.size()))
        return;
    const auto at = static_cast<size_t>(index);
    push(what, setPerformer(at, performer), setPerformer(at, session_->performers[at]), merge_key);
}

void SessionModel::removePerformer(int index) {
    if (!session_ || !isIndex(index, session_->performers.size()) || session_->performers.size() == 1)
        return;
    const auto at = static_cast<size_t>(index);
    const Performer removed = session_->performers[at];
    const std::string current = session_->current_performer;
    const auto redo = [erase = erasePerformer(at), removed](Session& session) -> Status {
        Status erased = erase(session);
        if (session.current_performer == removed.name)
            session.current_performer = session.performers.front().name;
        return erased;
    };
    const auto undo = [insert = insertPerformer(at, removed), current](Session& session) -> Status {
        session.current_performer = current;
        return insert(session);
    };
    push(tr("Remove %1").arg(QString::fromStdString(removed.name)), redo, undo);
}

void SessionModel::setCurrentPerformer(const QString& name) {
    if (session_ && name.toStdString() != session_->current_performer)
        push(tr("Choose %1").arg(name), setOf(&Session::current_performer, name.toStdString()),
             setOf(&Session::current_performer, session_->current_performer));
}

void SessionModel::setShots(std::vector<Shot> shots) {
    if (!session_)
        return;
    shots = withUnknownMembers(std::move(shots), session_->shots);
    if (shots != session_->shots)
        push(tr("Change the shot list"), setOf(&Session::shots, shots),
             setOf(&Session::shots, session_->shots));
}

void SessionModel::trashTake(int take) {
    if (!session_ || !isIndex(take, session_->takes.size()))
        return;
    const SessionTake trashed = session_->takes[static_cast<size_t>(take)];
    push(
        tr("Move %1 to the trash").arg(QString::fromStdString(trashed.name)),
        [this, name = trashed.name](Session& session) {
            const Status may = mayMove(name);
            return may ? noctule::trashTake(session, name) : may;
        },
        [trashed](Session& session) { return restoreTake(session, trashed); });
    if (session_->findTake(trashed.name) < 0)
        emit takeTrashed(QString::fromStdString(trashed.name));
}

std::shared_ptr<void> SessionModel::keepInPlace(const QString& take_path) {
    std::weak_ptr<void>& kept = kept_[QDir::cleanPath(take_path)];
    std::shared_ptr<void> token = kept.lock();
    if (!token)
        kept = token = std::make_shared<int>();
    return token;
}

Status SessionModel::mayMove(const std::string& take) const {
    const int index = session_->findTake(take);
    if (index < 0)
        return Done{};
    const auto kept = kept_.find(QDir::cleanPath(takePath(index)));
    if (kept == kept_.end() || kept->second.expired())
        return Done{};
    return Error{ErrorKind::kUsage, tr("A job works on %1").arg(QString::fromStdString(take)).toStdString(),
                 tr("Wait until it is done, or cancel it").toStdString()};
}

Status SessionModel::moveTake(Session& session, const std::string& from, const std::string& to) {
    if (const Status may = mayMove(from); !may)
        return may;
    const auto path_of = [&](const std::string& name) {
        const int index = session.findTake(name);
        return index < 0 ? QString() : takePath(index);
    };
    const QString before = path_of(from);
    Status renamed = noctule::renameTake(session, from, to);
    if (!renamed)
        return renamed;
    if (current_name_ == from)
        current_name_ = to;
    emit takeRenamed(before, path_of(to));
    return renamed;
}

void SessionModel::renameTake(int take, const QString& name) {
    if (!session_ || !isIndex(take, session_->takes.size()))
        return;
    const std::string before = session_->takes[static_cast<size_t>(take)].name;
    const std::string after = cleanTakeName(name.trimmed().toStdString());
    if (after != before && !name.trimmed().isEmpty())
        push(
            tr("Rename %1 to %2").arg(QString::fromStdString(before), QString::fromStdString(after)),
            [this, before, after](Session& session) { return moveTake(session, before, after); },
            [this, before, after](Session& session) { return moveTake(session, after, before); });
}

}  // namespace noctule::ui
