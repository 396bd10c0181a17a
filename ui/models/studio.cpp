// SPDX-License-Identifier: Apache-2.0
#include "ui/models/studio.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTemporaryFile>
#include <algorithm>
#include <chrono>

#include "core/mesh/import/glb_reader.h"
#include "core/recording/take.h"
#include "ui/language/core_words.h"
#include "ui/models/virtual_session.h"

namespace noctule::ui {
namespace {

constexpr const char* kBody = ":/noctule/bodies/mannequin.glb";

QString words(const std::string& text) {
    return QString::fromStdString(text);
}

/// assimp reads files of the disk only; the body is part of the program.
Result<SkinnedMesh> readBody() {
    QFile resource(kBody);
    QTemporaryFile file(QDir::temp().filePath("noctule-XXXXXX.glb"));
    const bool opened = resource.open(QIODevice::ReadOnly) && file.open();
    const QByteArray bytes = opened ? resource.readAll() : QByteArray();
    if (!opened || file.write(bytes) != bytes.size() || !file.flush())
        return Error{ErrorKind::kDisk, Studio::tr("The body could not be unpacked").toStdString(),
                     Studio::tr("Free some space on the disk; until then a skeleton is shown").toStdString()};
    return readSkinnedMesh(file.fileName().toStdString());
}

/// Several people whose suits have sources.
bool mayHearEachOther(const Take& take) {
    const auto subjects = take.subjects();
    return subjects && std::ranges::count_if(*subjects, [&](const TakeSubject& subject) {
                           const auto sources = take.sourceCount(subject.suit());
                           return !subject.room && sources && *sources > 0;
                       }) > 1;
}

VirtualSuit::Parts virtualSuitParts(const StudioParts& parts) {
    return {words(parts.virtual_suit_program),
            QStandardPaths::writableLocation(QStandardPaths::CacheLocation), parts.software,
            parts.make_sample_take, parts.make_pair_take};
}

/// Waits for its turn and still hears Cancel; false: cancelled.
bool waitForTurn(std::unique_lock<std::timed_mutex>& turn, const JobContext& job) {
    constexpr std::chrono::milliseconds kLook(50);
    while (!turn.try_lock_for(kLook)) {
        if (job.cancelled())
            return false;
        job.progress(0, Studio::tr("Waits for another take").toStdString());
    }
    return true;
}

}  // namespace

Studio::Studio(StudioParts parts, QObject* parent)
    : QObject(parent),
      parts_(std::move(parts)),
      session_(jobs_),
      shown_body_(jobs_, session_),
      take_(jobs_, time_),
      changes_(jobs_, session_, take_),
      markers_(changes_, take_),
      contacts_(changes_, take_, time_),
      finder_(settings_),
      suits_(jobs_, session_, {parts_.software, parts_.utc_now, [this] { return sessionsFolder(); }},
             {[this] { return takesFolder(); }, suitsFolder()}),
      virtual_suit_(jobs_, virtualSuitParts(parts_)),
      second_virtual_suit_(jobs_, virtualSuitParts(parts_)),
      remote_start_(settings_),
      processing_(std::make_shared<std::timed_mutex>()) {
    connect(&session_, &SessionModel::currentTakeChanged, this, &Studio::openTakeUnderReview);
    connect(&session_, &SessionModel::recoveryChanged, this, [this](int take) {
        if (take >= 0 && take == session_.currentTake())
            openTakeUnderReview(take);
    });
    connect(&session_, &SessionModel::takeRenamed, this, [this](const QString& before, const QString& now) {
        if (take_.path() == before)
            take_.followMove(now);
    });
    connect(&shown_body_, &ShownBody::failed, this, &Studio::failed);
    connect(&changes_, &TakeChanges::failed, this, &Studio::failed);
    connectSuits();
    connectVirtualSuits();
    loadBody();
}

void Studio::connectSuits() {
    connect(&suits_, &LiveSuits::failed, this, &Studio::failed);
    connect(&suits_, &LiveSuits::warned, this, &Studio::warned);
    connect(&suits_, &LiveSuits::checkedChanged, this, &Studio::checkedChanged);
    connect(&suits_, &LiveSuits::takeOfSeveral, this,
            [this](const QString& path) { process(accurateRequest(path.toStdString())); });
    suits_.forEach(this, [this](SuitInUse& worn) {
        connect(&worn.suit, &LiveSuit::phaseChanged, this, [this, &worn] { followSuit(worn); });
        CalibrationShelf& shelf = worn.calibrations;
        connect(&shelf, &CalibrationShelf::warned, this, &Studio::warned);
        connect(&shelf, &CalibrationShelf::told, this, &Studio::said);
        connect(&shelf, &CalibrationShelf::changed, this, [this, &worn] { suits_.setChecked(worn, {}); });
        connect(&shelf, &CalibrationShelf::saved, this, [this, &worn](const QString& task, bool is_good) {
            // A rest pose that was found just now is as good as a check of it.
            if (task == QLatin1String("rest-pose"))
                suits_.setChecked(worn, CheckedSuit{QDateTime::currentDateTime(), is_good});
        });
    });
}

void Studio::connectVirtualSuits() {
    connect(&virtual_suit_, &VirtualSuit::failed, this, &Studio::failed);
    connect(&second_virtual_suit_, &VirtualSuit::failed, this, &Studio::failed);
    connect(&virtual_suit_, &VirtualSuit::started, this, [this] {
        if (virtual_suit_.role() == VirtualSuit::Role::kAlone && !suits_.areSeveral())
            return suit().connectTo(virtual_suit_.address(), virtual_suit_.known());
        suits_.add(virtual_suit_.address(), virtual_suit_.known());
        if (std::exchange(second_virtual_suit_waits_, false))
            suits_.add(second_virtual_suit_.address(), second_virtual_suit_.known());
    });
    connect(&second_virtual_suit_, &VirtualSuit::started, this, [this] {
        second_virtual_suit_waits_ = virtual_suit_.role() != VirtualSuit::Role::kFirst ||
                                     virtual_suit_.state() != VirtualSuit::State::kOn;
        if (!second_virtual_suit_waits_)
            return suits_.add(second_virtual_suit_.address(), second_virtual_suit_.known());
        virtual_suit_.stop();
        virtual_suit_.start(VirtualSuit::Role::kFirst);
    });
    connect(&virtual_suit_, &VirtualSuit::changed, this, &Studio::followVirtualSuits);
    connect(&second_virtual_suit_, &VirtualSuit::changed, this, &Studio::followVirtualSuits);
}

void Studio::loadBody() {
    jobs_.start<SkinnedMesh>(
        tr("Loading the body"), [](const JobContext&) { return readBody(); },
        [this](Result<SkinnedMesh> mesh) -> QString {
            if (mesh)
                body_ = std::make_shared<const SkinnedMesh>(std::move(*mesh));
            body_ended_ = true;
            emit bodyLoaded();
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void Studio::whenBodyIsThere(QObject* context, std::function<void()> act) {
    if (body_ended_)
        act();
    else
        connect(this, &Studio::bodyLoaded, context, std::move(act));
}

QString Studio::sessionsFolder() const {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return settings_.value("folders/sessions", QDir(documents).filePath("Noctule")).toString();
}

QString Studio::suitsFolder() const {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return settings_.value("folders/suits", QDir(data).filePath("suits")).toString();
}

QString Studio::takesFolder() const {
    return session_.isOpen() ? words(session_.session().folder.string()) : sessionsFolder();
}

/// The take chosen in the session is the one under review; a damaged one is listed only.
void Studio::openTakeUnderReview(int index) {
    const SessionTake* chosen = index < 0 ? nullptr : &session_.session().takes[static_cast<size_t>(index)];
    // Read while its file is replaced it would not be there.
    if (!chosen || chosen->state == TakeState::kDamaged || session_.isRecovering(chosen->name)) {
        take_.close();
        return;
    }
    const QString path = words(session_.session().pathOf(*chosen).string());
    if (take_.path() != path)
        take_.open(path);
}

void Studio::startVirtualSuit() {
    const bool on = virtual_suit_.state() == VirtualSuit::State::kOn;
    if (on && suits_.at(virtual_suit_.address()))
        return;
    if (!on)
        virtual_suit_.start();
    else if (suits_.areSeveral())
        suits_.add(virtual_suit_.address(), virtual_suit_.known());
    else
        suit().connectTo(virtual_suit_.address(), virtual_suit_.known());
}

void Studio::startSecondVirtualSuit() {
    if (suits_.isTakeOpen()) {
        emit failed(tr("A take is being recorded"), tr("Start the second virtual suit when it has ended"));
        return;
    }
    if (second_virtual_suit_.state() != VirtualSuit::State::kOn)
        return second_virtual_suit_.start(VirtualSuit::Role::kSecond);
    suits_.add(second_virtual_suit_.address(), second_virtual_suit_.known());
}

void Studio::stopVirtualSuit() {
    if (second_virtual_suit_.state() != VirtualSuit::State::kOff)
        stopSecondVirtualSuit();
    virtual_suit_ends_ = true;
    if (SuitInUse* worn = suits_.at(virtual_suit_.address()))
        worn->suit.disconnectSuit();
    followVirtualSuits();
}

void Studio::stopSecondVirtualSuit() {
    second_virtual_suit_ends_ = true;
    if (SuitInUse* worn = suits_.at(second_virtual_suit_.address()))
        worn->suit.disconnectSuit();
    followVirtualSuits();
}

void Studio::setChecked(const std::optional<CheckedSuit>& checked) {
    suits_.setChecked(suits_.current(), checked);
}

void Studio::followSuit(SuitInUse& worn) {
    if (worn.suit.phase() == LiveSuit::Phase::kNone)
        suits_.setChecked(worn, {});
    followVirtualSuits();
    const QString& address = worn.suit.address();
    const bool is_virtual = address == virtual_suit_.address() || address == second_virtual_suit_.address();
    if (worn.suit.phase() == LiveSuit::Phase::kReady && !is_virtual && worn.suit.status()->hello)
        finder_.remember(words(worn.suit.status()->hello->serial));
}

void Studio::followVirtualSuits() {
    const auto follow = [this](VirtualSuit& program, bool& ends) {
        SuitInUse* worn = program.address().isEmpty() ? nullptr : suits_.at(program.address());
        if (program.state() == VirtualSuit::State::kOff && worn) {
            // Nobody is there to connect to again; what the others record goes on.
            if (!worn->suit.isLent())
                worn->suit.disconnectSuit();
        } else if (ends && !worn) {
            ends = false;
            program.stop();
        }
    };
    follow(virtual_suit_, virtual_suit_ends_);
    follow(second_virtual_suit_, second_virtual_suit_ends_);
}

Job* Studio::tryVirtualSuit() {
    if (trying_ && trying_->state() == Job::State::kRunning)
        return trying_;
    VirtualSessionRequest request;
    request.sessions_folder = sessionsFolder().toStdString();
    request.session_name = tr("Virtual suit").toStdString();
    request.take_base = tr("sample", "name of takes").toStdString();
    request.software = parts_.software;
    request.created_utc = parts_.utc_now();
    request.make_take = parts_.make_sample_take;
    trying_ = jobs_.start<VirtualSession>(
        tr("Virtual suit"), [request](const JobContext& job) { return makeVirtualSession(request, job); },
        [this](Result<VirtualSession> made) -> QString {
            if (!made) {
                if (made.error().kind != ErrorKind::kCancelled)
                    emit failed(coreWords(made.error().message), coreWords(made.error().remedy));
                return {};
            }
            session_.open(words(made->folder.string()), words(made->take));
            goTo(Step::kReview);
            return tr("%1 is ready").arg(words(made->take));
        });
    return trying_;
}

Job* Studio::importMotion(std::shared_ptr<const figure::UnderstoodMotion> motion,
                          const std::string& scenario) {
    if (!makeSureOfSession())
        return nullptr;
    VirtualSessionRequest request;
    request.take_base = motion->clip.name;
    request.software = parts_.software;
    request.created_utc = parts_.utc_now();
    request.make_take = [make = parts_.make_motion_take, motion, scenario](const std::string& path,
                                                                           const JobContext& job) {
        return make(*motion, scenario, path, job);
    };
    return jobs_.start<std::string>(
        tr("Importing %1").arg(words(motion->clip.name)),
        [request, session = session_.session()](const JobContext& job) {
            return makeSimulatedTake(request, session, job);
        },
        [this, folder = session_.session().folder](Result<std::string> made) -> QString {
            if (!made) {
                if (made.error().kind != ErrorKind::kCancelled)
                    emit failed(coreWords(made.error().message), coreWords(made.error().remedy));
                return {};
            }
            if (session_.isOpen() && session_.session().folder == folder) {
                session_.refresh(words((session_.session().takesFolder() / (*made + ".noctule")).string()));
                session_.setCurrentTake(session_.session().findTake(*made));
                goTo(Step::kReview);
            }
            return tr("%1 is ready").arg(words(*made));
        });
}

ProcessRequest Studio::accurateRequest(const std::string& take_path) {
    ProcessRequest request;
    request.take_path = take_path;
    if (const auto take = Take::open(take_path); take && mayHearEachOther(*take))
        return request;  // smoothers go over one body only; pulses are told apart by carrier
    request.tracker.smoother = Smoother::kFull;
    request.detector = Detector::kMatched;
    return request;
}

Job* Studio::process(ProcessRequest request) {
    request.software = parts_.software;
    request.created_utc = parts_.utc_now();
    const QString path = words(request.take_path);
    const QString take = QFileInfo(path).completeBaseName();
    return jobs_.start<ProcessSummary>(
        tr("Processing %1").arg(take),
        [request = std::move(request), turns = processing_](const JobContext& job) -> Result<ProcessSummary> {
            std::unique_lock turn(*turns, std::defer_lock);
            if (!waitForTurn(turn, job))
                return JobContext::cancelledError();
            return processTake(request, job);
        },
        [this, path, take, kept = session_.keepInPlace(path)](Result<ProcessSummary> summary) -> QString {
            if (!summary) {
                if (summary.error().kind != ErrorKind::kCancelled)
                    emit failed(words(summary.error().message), words(summary.error().remedy));
                return {};
            }
            session_.refresh(path);
            if (take_.path() == path)
                take_.reload(true);
            QString result = tr("%1 of %2 is ready: %n pose(s)", "name of the result, of the take",
                                static_cast<int>(summary->poses))
                                 .arg(words(summary->run_name), take);
            emit said(result);
            return result;
        });
}

void Studio::processInTurn(std::vector<ProcessRequest> requests) {
    if (requests.empty())
        return;
    ProcessRequest first = std::move(requests.front());
    requests.erase(requests.begin());
    connect(process(std::move(first)), &Job::ended, this,
            [this, rest = std::move(requests)] { processInTurn(rest); });
}

}  // namespace noctule::ui
