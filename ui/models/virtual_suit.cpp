// SPDX-License-Identifier: Apache-2.0
#include "ui/models/virtual_suit.h"

#include <signal.h>
#include <sys/prctl.h>

#include <QDir>
#include <QTimer>

#include "core/job/atomic_file.h"
#include "core/recording/take.h"
#include "ui/language/core_words.h"

namespace noctule::ui {
namespace {

constexpr int kKillAfter_ms = 2000;

/// Told to end by the kernel when the studio is no more.
class ChildProcess : public QProcess {
protected:
    void setupChildProcess() override { prctl(PR_SET_PDEATHSIG, SIGTERM); }
};

struct SampleOfSuit {
    QString path;
    KnownWearing known;
};

/// Of the pair's take whose suit it is.
QString subjectOf(VirtualSuit::Role role) {
    return role == VirtualSuit::Role::kFirst ? "A" : role == VirtualSuit::Role::kSecond ? "B" : "";
}

Result<SampleOfSuit> readSample(const std::string& path, VirtualSuit::Role role) {
    auto take = Take::open(path);
    if (!take)
        return take.error();
    if (const auto subjects = take->subjects(); subjects && role != VirtualSuit::Role::kAlone)
        for (const TakeSubject& subject : *subjects)
            if (subject.name == subjectOf(role).toStdString())
                take->view(subject.suit());
    const auto calibration = take->calibrationInForce();
    const auto actor = take->actorInForce();
    const auto rest = take->restInterval();
    const auto rate_hz = take->sampleRate_hz();
    if (!calibration || !actor || !rest || !rate_hz)
        return Error{ErrorKind::kUnusable, path + ": does not say who wears the suit", "Delete it"};
    SampleOfSuit sample{QString::fromStdString(path), {}};
    sample.known.calibration = calibration->value;
    sample.known.actor = actor->value;
    if (*rest && (*rest)->first == 0)
        sample.known.rest_s = static_cast<double>((*rest)->last + 1) / static_cast<double>(*rate_hz);
    return sample;
}

/// One that cannot be read is made again.
Result<SampleOfSuit> sampleAt(const std::filesystem::path& path, const VirtualSuit::Parts& parts,
                              VirtualSuit::Role role, const JobContext& job) {
    if (auto kept = readSample(path.string(), role))
        return kept;
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    if (error)
        return Error{ErrorKind::kDisk, path.parent_path().string() + ": cannot be made: " + error.message(),
                     "Check that you may write there"};
    const std::string made = asidePath(path.string());
    const auto& make = role == VirtualSuit::Role::kAlone ? parts.make_take : parts.make_pair_take;
    if (const Status done = make(made, job); !done)
        return namedAs(done.error(), made, path.string());
    if (const Status published = publishFile(made, path.string(), true); !published)
        return published.error();
    return readSample(path.string(), role);
}

/// Files named sample-... or pair-... are from versions whose takes jumped at the loop; other names make the
/// program write them anew.
QString fileName(const std::string& software, VirtualSuit::Role role) {
    QString name = QString::fromStdString(software);
    for (QChar& letter : name)
        if (!letter.isLetterOrNumber() && letter != '.')
            letter = '-';
    return QStringLiteral("%1-%2.noctule")
        .arg(role == VirtualSuit::Role::kAlone ? "round" : "round-pair", name);
}

}  // namespace

VirtualSuit::VirtualSuit(Jobs& jobs, Parts parts, QObject* parent)
    : QObject(parent), jobs_(jobs), parts_(std::move(parts)) {}

VirtualSuit::~VirtualSuit() {
    QList<QProcess*> programs = findChildren<QProcess*>();  // that were told to end and have not yet
    if (program_)
        programs.append(program_.get());
    for (QProcess* program : programs) {
        program->disconnect(this);
        program->kill();
        program->waitForFinished();
    }
}

qint64 VirtualSuit::processId() const {
    return program_ ? program_->processId() : 0;
}

void VirtualSuit::setState(State state) {
    if (state == state_)
        return;
    state_ = state;
    emit changed();
}

void VirtualSuit::start(Role role) {
    if (state_ != State::kOff)
        return;
    role_ = role;
    if (!isAvailable()) {
        emit failed(tr("The virtual suit’s program is not part of this installation"),
                    tr("Install Noctule again"));
        return;
    }
    setState(State::kPreparing);
    const std::filesystem::path path =
        QDir(parts_.cache_folder).filePath(fileName(parts_.software, role)).toStdString();
    preparing_ = jobs_.start<SampleOfSuit>(
        tr("Preparing the virtual suit"),
        [path, parts = parts_, role](const JobContext& job) { return sampleAt(path, parts, role, job); },
        [self = QPointer(this)](Result<SampleOfSuit> sample) -> QString {
            if (!self || self->state_ != State::kPreparing)
                return {};
            if (sample) {
                self->known_ = sample->known;
                self->launch(sample->path);
                return {};
            }
            self->setState(State::kOff);
            if (sample.error().kind != ErrorKind::kCancelled)
                emit self->failed(coreWords(sample.error().message), coreWords(sample.error().remedy));
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void VirtualSuit::launch(const QString& take) {
    heard_.clear();
    complaints_.clear();
    address_.clear();
    control_.clear();
    program_ = std::make_unique<ChildProcess>();
    connect(program_.get(), &QProcess::readyReadStandardOutput, this, &VirtualSuit::hear);
    connect(program_.get(), &QProcess::readyReadStandardError, this, [this] {
        constexpr int kKeep = 2000;
        complaints_ = (complaints_ + program_->readAllStandardError()).right(kKeep);
    });
    connect(program_.get(), qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this,
            &VirtualSuit::ended);
    connect(program_.get(), &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            ended();
    });
    setState(State::kStarting);
    QStringList words{"--take", take, "--loop", "--tcp", "127.0.0.1:0", "--control", "127.0.0.1:0"};
    if (role_ != Role::kAlone)
        words << "--subject" << subjectOf(role_);
    program_->start(parts_.program, words);
}

void VirtualSuit::hear() {
    heard_ += program_->readAllStandardOutput();
    for (int end = heard_.indexOf('\n'); end >= 0; end = heard_.indexOf('\n')) {
        const QString line = QString::fromUtf8(heard_.left(end));
        heard_.remove(0, end + 1);
        if (line.startsWith("studio: "))
            address_ = line.mid(8);
        else if (line.startsWith("control: "))
            control_ = line.mid(9);
        else if (line.startsWith("worn otherwise: "))
            noteWornOtherwise();
    }
    // The control port is the last that it opens.
    if (state_ != State::kStarting || address_.isEmpty() || control_.isEmpty())
        return;
    setState(State::kOn);
    emit started();
}

void VirtualSuit::noteWornOtherwise() {
    known_.is_exact = false;
    emit wornOtherwise();
}

void VirtualSuit::stop() {
    if (preparing_)
        preparing_->cancel();
    if (program_) {
        // It may still have words for a client; one that does not listen is no reason to wait for it.
        QProcess* leaving = program_.release();
        leaving->disconnect(this);
        leaving->setParent(this);
        connect(leaving, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), leaving,
                &QObject::deleteLater);
        leaving->terminate();
        QTimer::singleShot(kKillAfter_ms, leaving, &QProcess::kill);
    }
    setState(State::kOff);
}

/// Unasked.
void VirtualSuit::ended() {
    const bool crashed = program_->exitStatus() == QProcess::CrashExit;
    const bool began = program_->error() != QProcess::FailedToStart;
    const QString last_words = QString::fromUtf8(complaints_).trimmed().section('\n', -1);
    const bool silently = last_words.isEmpty();
    program_.release()->deleteLater();
    setState(State::kOff);
    if (!began)
        emit failed(tr("The virtual suit’s program %1 could not be started").arg(parts_.program),
                    tr("Install Noctule again"));
    else if (crashed || silently)
        emit failed(tr("The virtual suit broke down"), tr("Start it again; takes of it are safe"));
    else
        emit failed(tr("The virtual suit ended by itself: %1", "its last words").arg(last_words),
                    tr("Start it again; takes of it are safe"));
}

}  // namespace noctule::ui
