// SPDX-License-Identifier: Apache-2.0
#include "ui/models/studio_log.h"

#include "ui/models/personal_data.h"

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
    write("info", "started, " + QString::fromStdString(studio.parts().software));
    connect(&studio, &Studio::failed, this,
            [this](const QString& what, const QString& remedy) { write("error", what + " | " + remedy); });
    connect(&studio, &Studio::warned, this, [this](const QString& what) { write("warning", what); });
    const auto error = [this](const QString& what) { write("error", what); };
    connect(&studio.session(), &SessionModel::failed, this, error);
    connect(&studio.session(), &SessionModel::notSaved, this, error);
    connect(&studio.take(), &TakeDocument::failed, this, error);
    connect(&studio, &Studio::tornTake, this,
            [this](const QString& path, const QString& why) { write("error", path + " | " + why); });
    connect(&studio.session(), &SessionModel::opened, this, [this] {
        const auto& session = studio_.session();
        write("info", session.isOpen()
                          ? QStringLiteral("session opened, %1 takes").arg(session.session().takes.size())
                          : QStringLiteral("session closed"));
    });
    connect(&studio.take(), &TakeDocument::opened, this,
            [this] { write("info", studio_.take().isOpen() ? "take opened" : "take closed"); });
    connect(&studio.jobs(), &Jobs::started, this, [this](Job* job) { follow(*job); });
    studio.suits().forEach(this, [this](SuitInUse& worn) {
        connect(&worn.suit, &LiveSuit::phaseChanged, this, [this, &worn] { tellPhase(worn.suit); });
    });
}

void StudioLog::write(const char* level, const QString& text) {
    if (studio_.session().isOpen())
        learn(namesOf(studio_.session().session()));
    log_.write(level, withoutPersonalData(text, names_));
}

void StudioLog::learn(const QStringList& names) {
    for (const QString& name : names)
        if (!names_.contains(name))
            names_ += name;
}

void StudioLog::follow(Job& job) {
    learn(job.namesInTitle());
    write("info", "job begins: " + job.title());
    connect(&job, &Job::ended, this, [this, &job] {
        write(job.state() == Job::State::kFailed ? "error" : "info",
              "job " + ended(job) + ": " + job.title());
    });
}

void StudioLog::tellPhase(const LiveSuit& suit) {
    const auto hello = suit.status()->hello;
    const QString serial = hello ? QString::fromStdString(hello->serial) + ' ' : QString();
    write("info", "suit " + serial + phaseName(suit.phase()));
}

}  // namespace noctule::ui
