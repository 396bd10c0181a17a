// SPDX-License-Identifier: Apache-2.0
#include "ui/models/studio_log.h"

namespace noctule::ui {
namespace {

const char* phaseName(LiveSuit::Phase phase) {
    switch (phase) {
        case LiveSuit::Phase::kNone:
            return "is not connected";
        case LiveSuit::Phase::kConnecting:
            return "is being connected";
        case LiveSuit::Phase::kReady:
            return "is connected";
        case LiveSuit::Phase::kLooking:
            return "is looked at";
        case LiveSuit::Phase::kStarting:
            return "begins a take";
        case LiveSuit::Phase::kRecording:
            return "records";
        case LiveSuit::Phase::kSaving:
            return "saves its take";
        case LiveSuit::Phase::kRefused:
            return "refused";
    }
    return "";
}

QString ended(const Job& job) {
    switch (job.state()) {
        case Job::State::kRunning:
            break;
        case Job::State::kDone:
            return "done";
        case Job::State::kCancelled:
            return "cancelled";
        case Job::State::kFailed:
            return "failed: " + job.outcome();
    }
    return "runs";
}

}  // namespace

StudioLog::StudioLog(Studio& studio, LogFile& log, QObject* parent)
    : QObject(parent), studio_(studio), log_(log) {
    log_.write("info", "started, " + QString::fromStdString(studio.parts().software));
    connect(&studio, &Studio::failed, this, [this](const QString& what, const QString& remedy) {
        log_.write("error", what + " | " + remedy);
    });
    connect(&studio, &Studio::warned, this, [this](const QString& what) { log_.write("warning", what); });
    const auto error = [this](const QString& what) { log_.write("error", what); };
    connect(&studio.session(), &SessionModel::failed, this, error);
    connect(&studio.session(), &SessionModel::notSaved, this, error);
    connect(&studio.take(), &TakeDocument::failed, this, error);
    connect(&studio, &Studio::tornTake, this,
            [this](const QString& path, const QString& why) { log_.write("error", path + " | " + why); });
    connect(&studio.session(), &SessionModel::opened, this, [this] {
        const auto& session = studio_.session();
        log_.write("info",
                   session.isOpen()
                       ? QStringLiteral("session opened, %1 takes").arg(session.session().takes.size())
                       : QStringLiteral("session closed"));
    });
    connect(&studio.take(), &TakeDocument::opened, this,
            [this] { log_.write("info", studio_.take().isOpen() ? "take opened" : "take closed"); });
    connect(&studio.jobs(), &Jobs::started, this, [this](Job* job) { follow(*job); });
    studio.suits().forEach(this, [this](SuitInUse& worn) {
        connect(&worn.suit, &LiveSuit::phaseChanged, this, [this, &worn] { tellPhase(worn.suit); });
    });
}

void StudioLog::follow(Job& job) {
    log_.write("info", "job begins: " + job.title());
    connect(&job, &Job::ended, this, [this, &job] {
        log_.write(job.state() == Job::State::kFailed ? "error" : "info",
                   "job " + ended(job) + ": " + job.title());
    });
}

void StudioLog::tellPhase(const LiveSuit& suit) {
    const auto hello = suit.status()->hello;
    const QString serial = hello ? QString::fromStdString(hello->serial) + ' ' : QString();
    log_.write("info", "suit " + serial + phaseName(suit.phase()));
}

}  // namespace noctule::ui
