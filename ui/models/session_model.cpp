// SPDX-License-Identifier: Apache-2.0
// Opening, closing and files; what the operator changes is in session_changes.cpp.
#include "ui/models/session_model.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include "core/session/take_folder.h"
#include "ui/language/core_words.h"
#include "ui/models/session_command.h"

namespace noctule::ui {
namespace {

constexpr const char* kCurrentTakes = "current_takes";

QString inWords(const Error& error) {
    return coreWords(error);
}

std::string nowUtc() {
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

std::filesystem::path pathOf(const QString& text) {
    return QDir::cleanPath(text).toStdString();
}

/// Folders are keys of their own in the settings: slashes would make groups of them.
QString keyOf(const Session& session) {
    return QString("%1/%2").arg(
        kCurrentTakes,
        QString::fromLatin1(QByteArray::fromStdString(session.folder.string()).toPercentEncoding()));
}

}  // namespace

SessionModel::SessionModel(Jobs& jobs, std::function<QString()> home, QObject* parent)
    : QObject(parent), jobs_(jobs), home_(std::move(home)), saver_(jobs) {
    connect(&saver_, &SessionSaver::failed, this, [this](const Error& error) {
        unsaved_ = whyNotHere();
        if (unsaved_.isEmpty())
            unsaved_ = failureText(tr("The session could not be saved. Your takes are safe; the changes are "
                                      "kept here and saved with the next one"),
                                   error);
        emit notSaved(unsaved_);
    });
    connect(&saver_, &SessionSaver::savedAgain, this,
            [this] { emit savedAgain(std::exchange(unsaved_, {})); });
}

SessionModel::~SessionModel() {
    leave();
}

void SessionModel::tell(const QString& what_failed, const Error& error) {
    if (error.kind != ErrorKind::kCancelled)
        emit failed(failureText(what_failed, error));
}

QString SessionModel::failureText(const QString& what_failed, const Error& error) {
    return tr("%1. %2", "what failed and what is safe; why and what to do").arg(what_failed, inWords(error));
}

QString SessionModel::whyNotHere() const {
    if (!isOpen() || QFileInfo::exists(QString::fromStdString(session_->folder.string())))
        return {};
    return tr("The folder of the session, %1, is not there any more. Put it back; what you change meanwhile "
              "is kept here and saved then.")
        .arg(QString::fromStdString(session_->folder.string()));
}

QString SessionModel::firstPerformer() {
    return tr("Performer 1");
}

bool SessionModel::create(const QString& folder, const QString& name) {
    emit triedAnew();
    auto made = createSession(pathOf(folder), name.toStdString(), nowUtc(), firstPerformer().toStdString());
    if (!made) {
        tell(tr("The session “%1” was not made").arg(name), made.error());
        return false;
    }
    adopt(std::move(*made), {});
    return true;
}

bool SessionModel::makeSure() {
    if (isOpen())
        return true;
    const QDir folder(home_());
    const QString date = QDate::currentDate().toString(Qt::ISODate);
    QString name = date;
    for (int number = 2; QFileInfo::exists(folder.filePath(name)); ++number)
        name = QStringLiteral("%1 (%2)").arg(date).arg(number);
    QDir().mkpath(folder.path());
    return create(folder.filePath(name), name);
}

void SessionModel::open(const QString& folder, const QString& take) {
    saveNow();  // it may be the same one
    openWith({tr("Opening session %1"), QDir(folder).dirName()}, folder, take,
             [folder = pathOf(folder)](const JobContext& job) { return openSession(folder, job); });
}

void SessionModel::rebuild(const QString& folder) {
    openWith(
        {tr("Rebuilding session %1"), QDir(folder).dirName()}, folder, {},
        [folder = pathOf(folder)](const JobContext& job) { return rebuildSession(folder, nowUtc(), job); });
}

void SessionModel::openWith(const JobTitle& title, const QString& folder, const QString& take,
                            std::function<Result<Session>(const JobContext&)> work) {
    emit triedAnew();
    if (opening_)
        opening_->cancel();
    struct Found {
        std::optional<Session> session;
        Error error;
        bool can_rebuild = false;
    };
    opening_ = jobs_.start<Found>(
        title,
        [work = std::move(work), path = pathOf(folder)](const JobContext& job) -> Result<Found> {
            auto session = work(job);
            if (session)
                return Found{std::move(*session), {}, false};
            if (session.error().kind == ErrorKind::kCancelled)
                return session.error();
            return Found{{}, session.error(), canRebuildSession(path)};
        },
        [model = QPointer(this), folder, take](Result<Found> found) -> QString {
            if (!model)
                return {};
            if (!found) {
                model->tell(tr("The session was not opened"), found.error());
            } else if (found->session) {
                model->adopt(std::move(*found->session), take);
            } else {
                if (found->can_rebuild)
                    emit model->damaged(folder, coreWords(found->error.message));
                else
                    emit model->failed(inWords(found->error));
                return inWords(found->error);
            }
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void SessionModel::adopt(Session session, const QString& take) {
    leave();
    session_ = std::move(session);
    const QString wanted = take.isEmpty() ? QSettings().value(keyOf(*session_)).toString() : take;
    const int known = session_->findTake(wanted.toStdString());
    current_ = known >= 0 ? known : static_cast<int>(session_->takes.size()) - 1;
    current_name_ = current_ < 0 ? "" : session_->takes[static_cast<size_t>(current_)].name;
    announce();
}

void SessionModel::leave() {
    undo_.clear();  // markers of a take that belongs to no session are on it too
    if (!session_)
        return;
    saveNow();
    saver_.forget();
    QSettings().setValue(keyOf(*session_), QString::fromStdString(current_name_));
    session_.reset();
    current_ = -1;
    current_name_.clear();
    is_read_only_ = false;
    recovering_.clear();
}

void SessionModel::announce() {
    emit exchanged();
    emit opened();
    emit changed();
    emit currentTakeChanged(current_);
}

void SessionModel::close() {
    if (opening_)
        opening_->cancel();
    if (!session_)
        return;
    leave();
    announce();
}

void SessionModel::setReadOnly(bool is_read_only) {
    if (std::exchange(is_read_only_, is_read_only) != is_read_only)
        emit changed();
}

QString SessionModel::takePath(int take) const {
    return QString::fromStdString(session_->pathOf(session_->takes.at(static_cast<size_t>(take))).string());
}

void SessionModel::setCurrentTake(int index) {
    if (!session_ || index < -1 || index >= static_cast<int>(session_->takes.size()) || index == current_)
        return;
    current_ = index;
    current_name_ = index < 0 ? "" : session_->takes[static_cast<size_t>(index)].name;
    emit currentTakeChanged(current_);
}

int SessionModel::indexOf(const QString& take_path) const {
    if (!session_ || take_path.isEmpty())
        return -1;
    const QString wanted = QFileInfo(take_path).canonicalFilePath();
    for (int i = 0; i < static_cast<int>(session_->takes.size()); ++i) {
        const QFileInfo take(takePath(i));
        if (take.fileName() == QFileInfo(wanted).fileName() && take.canonicalFilePath() == wanted)
            return i;
    }
    return -1;
}

void SessionModel::keepShownResult(int take, const QString& result) {
    if (!session_ || take < 0 || take >= static_cast<int>(session_->takes.size()))
        return;
    std::string& shown = session_->takes[static_cast<size_t>(take)].shown_result;
    if (shown == result.toStdString())
        return;
    shown = result.toStdString();
    if (!is_read_only_)
        saver_.schedule(*session_);
}

void SessionModel::followCurrentTake() {
    if (current_ < 0)
        return;
    const int now = session_->findTake(current_name_);
    if (now == current_)
        return;
    // When it has gone, its neighbour is the current one.
    current_ = now >= 0 ? now : std::min(current_, static_cast<int>(session_->takes.size()) - 1);
    current_name_ = current_ < 0 ? "" : session_->takes[static_cast<size_t>(current_)].name;
    emit currentTakeChanged(current_);
}

void SessionModel::noteChange() {
    saver_.schedule(*session_);
    emit changed();
    followCurrentTake();
}

void SessionModel::saveNow() {
    if (session_)
        saver_.flush();
}

void SessionModel::refresh(const QString& take_path) {
    if (!session_ || addTake(*session_, take_path.toStdString()) < 0)
        return;
    noteChange();
}

void SessionModel::importTakes(const QStringList& paths) {
    if (!session_ || paths.isEmpty())
        return;
    emit triedAnew();
    struct Imported {
        std::vector<std::filesystem::path> files;
        QStringList problems;
    };
    const auto work = [paths, copy = *session_](const JobContext& job) mutable -> Result<Imported> {
        Imported imported;
        for (const QString& path : paths) {
            const auto take = importTake(copy, path.toStdString(), job);
            if (take)
                imported.files.push_back(copy.pathOf(*take));
            else if (take.error().kind == ErrorKind::kCancelled)
                break;  // what has been copied stays
            else
                imported.problems.append(inWords(take.error()));
        }
        if (imported.files.empty() && job.cancelled())
            return JobContext::cancelledError();
        return imported;
    };
    const auto done = [model = QPointer(this),
                       folder = session_->folder](Result<Imported> imported) -> QString {
        const bool same = model && model->session_ && model->session_->folder == folder;
        if (!imported || !same)
            return {};
        for (const auto& file : imported->files) {
            model->refresh(QString::fromStdString(file.string()));
            model->setCurrentTake(model->session_->findTake(file.stem().string()));
            emit model->takeAdded(QString::fromStdString(file.stem().string()));
        }
        for (const QString& problem : imported->problems)
            emit model->failed(problem);
        return imported->problems.isEmpty() ? tr("%n take(s) copied into the session", nullptr,
                                                 static_cast<int>(imported->files.size()))
                                            : imported->problems.join('\n');
    };
    jobs_.start<Imported>(tr("Importing %n take(s)", nullptr, static_cast<int>(paths.size())),
                          std::function<Result<Imported>(const JobContext&)>(work), done);
}

void SessionModel::recover(int take) {
    if (!session_ || take < 0 || take >= static_cast<int>(session_->takes.size()))
        return;
    const std::string name = session_->takes[static_cast<size_t>(take)].name;
    if (!recovering_.insert(name).second)
        return;
    emit triedAnew();
    emit recoveryChanged(take);
    const JobTitle title{tr("Recovering %1"), QString::fromStdString(name)};
    struct Recovered {
        Session session;
        Recovery losses;
    };
    jobs_.start<Recovered>(
        title,
        [copy = *session_, name](const JobContext& job) mutable -> Result<Recovered> {
            const Result<Recovery> recovered = recoverTake(copy, name, job);
            if (!recovered)
                return recovered.error();
            return Recovered{copy, *recovered};
        },
        [model = QPointer(this), name,
         kept = keepInPlace(takePath(take))](Result<Recovered> recovered) -> QString {
            if (!model || !model->session_)
                return {};
            model->recovering_.erase(name);
            const auto tell_ended = [&] { emit model->recoveryChanged(model->session_->findTake(name)); };
            if (!recovered) {
                model->tell(tr("%1 could not be recovered; its file stays as it is")
                                .arg(QString::fromStdString(name)),
                            recovered.error());
                emit model->changed();
                tell_ended();
                return {};
            }
            const Session& copy = recovered->session;
            if (copy.folder != model->session_->folder)
                return {};
            for (const SessionTake& known : copy.takes)
                model->refresh(QString::fromStdString(copy.pathOf(known).string()));
            tell_ended();
            if (recovered->losses)
                emit model->warned(savedInWords(QString::fromStdString(name), *recovered->losses));
            return tr("%1 is recovered").arg(QString::fromStdString(name));
        });
}

QString SessionModel::savedInWords(const QString& take, const TakeLosses& losses) {
    return tr("%1 was damaged; what could be read of it is saved. %2.", "how much was saved of it")
        .arg(take, coreWords(savedText(losses)));
}

}  // namespace noctule::ui
