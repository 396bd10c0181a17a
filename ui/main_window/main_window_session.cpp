// SPDX-License-Identifier: Apache-2.0
// What is open: sessions and takes from the command line, the start page and the desktop; what is told when
// they cannot be read; and what is asked before the window closes.
#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMimeData>

#include "core/formats/motion_document.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/session_notices.h"
#include "ui/main_window/side_docks.h"
#include "ui/main_window/status_line.h"
#include "ui/main_window/top_bar.h"
#include "ui/models/recording_import.h"
#include "ui/style/words.h"
#include "ui/views/readiness_words.h"
#include "ui/views/session/session_commands.h"
#include "ui/widgets/question.h"
#include "ui/widgets/step_bar.h"

namespace noctule::ui {
namespace {

constexpr const char* kLooseTake = "loose take";

bool isTake(const QString& path) {
    return path.endsWith(".noctule", Qt::CaseInsensitive);
}

bool isMotion(const QString& path) {
    return isMotionFileName(path.toStdString());
}

bool isRecording(const QString& path) {
    return !isTake(path) && !isMotion(path) && !SessionCommands::canBeOpened(path) && mayBeRecording(path);
}

int endOfFirstSentence(const QString& text) {
    const int end = text.indexOf(". ");
    return end < 0 ? text.size() : end;
}
QString firstSentence(const QString& text) {
    return text.left(endOfFirstSentence(text));
}
QString otherSentences(const QString& text) {
    return text.mid(endOfFirstSentence(text) + 2);
}

QStringList localPaths(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile() &&
            (isTake(url.toLocalFile()) || isMotion(url.toLocalFile()) ||
             SessionCommands::canBeOpened(url.toLocalFile()) || mayBeRecording(url.toLocalFile())))
            paths.append(url.toLocalFile());
    return paths;
}

}  // namespace

void MainWindow::connectStudio() {
    connect(&studio_.session(), &SessionModel::exchanged, this, &MainWindow::onSessionExchanged);
    connect(&studio_.session(), &SessionModel::opened, this, &MainWindow::onSessionOpened);
    connect(&studio_.session(), &SessionModel::changed, this, &MainWindow::refreshTitle);
    connect(&studio_.session(), &SessionModel::takeAdded, this, [this] { goTo(Step::kReview); });
    const auto forgetWanted = [this] { recovery_wanted_.clear(); };
    connect(&studio_.session(), &SessionModel::failed, this, forgetWanted);
    connect(&studio_.session(), &SessionModel::damaged, this, forgetWanted);
    connect(&studio_.take(), &TakeDocument::opened, this, &MainWindow::onTakeOpened);
    connectNotices();
    studio_.suits().follow(&SuitCheck::changed, this, &MainWindow::showSuit);
    connect(&studio_.suits(), &LiveSuits::changed, this, &MainWindow::showSuit);
    showSuit();
    for (const Command command : {Command::kBody, Command::kShowFolder, Command::kCloseSession})
        (*actions_)[command]->setEnabled(studio_.session().isOpen());
}

/// What failed is told until it is tried anew, succeeds, or another one is there.
void MainWindow::connectNotices() {
    SessionModel& session = studio_.session();
    connect(&session, &SessionModel::failed, this,
            [this](const QString& message) { onMessage(message, About::kTakes); });
    connect(&session, &SessionModel::triedAnew, this, [this] { forget(About::kTakes); });
    connect(&session, &SessionModel::notSaved, this,
            [this](const QString& message) { onMessage(message, About::kSession); });
    connect(&session, &SessionModel::savedAgain, this,
            [this](const QString& message) { notices_->remove(firstSentence(message)); });
    connect(&studio_.take(), &TakeDocument::failed, this,
            [this](const QString& message) { onMessage(message, About::kTake); });
    connect(&studio_, &Studio::failed, this, &MainWindow::onFailure);
    connect(&studio_, &Studio::tornTake, this, &MainWindow::onTornTake);
    connect(&studio_, &Studio::warned, this, &MainWindow::onWarning);
    connect(&studio_, &Studio::settled, this, &MainWindow::forget);
}

void MainWindow::showSuit() {
    const auto hello = studio_.suit().status()->hello;
    if (studio_.suit().phase() == LiveSuit::Phase::kNone || !hello)
        return top_bar_->showSuit(Tone::kNeutral, {}, {});
    const SuitInUse& worst = worstOf(studio_.suits());
    const Readiness& readiness = worst.check.readiness();
    const int suits = static_cast<int>(studio_.suits().connected().size());
    const QString box =
        suits > 1 ? tr("%n box(es)", "connected", suits) : QString::fromStdString(hello->serial);
    if (worst.check.lostSince().isValid())
        return top_bar_->showSuit(Tone::kError, linkBrokenInShort(), box);
    if (readiness.verdict == Readiness::Verdict::kWaiting)
        return top_bar_->showSuit(Tone::kNeutral, tr("Looking"), box);
    const bool is_ready = readiness.verdict == Readiness::Verdict::kReady;
    const bool all_fine = std::ranges::all_of(readiness.boards, [](const BoardReadiness& board) {
        return board.state == BoardReadiness::State::kFine;
    });
    // The count is coloured by boards alone; what else there is marks the step Connect.
    const QString boards =
        tr("%1/%2 boards", "there, of all").arg(readiness.boards_there).arg(readiness.boards.size());
    top_bar_->showSuit(all_fine   ? Tone::kOk
                       : is_ready ? Tone::kWarn
                                  : Tone::kError,
                       boards, box, !readiness.problems.empty());
}

void MainWindow::open(const QString& path) {
    const QFileInfo file(path);
    if (file.exists() && isRecording(path)) {
        importRecording({path});
    } else if (!file.exists()) {
        emit studio_.failed(tr("%1 is not there").arg(QDir::toNativeSeparators(path)),
                            tr("It may have been moved, or its disk is not connected."), About::kFile);
    } else if (file.isDir()) {
        if (SessionCommands::canBeOpened(path))
            studio_.session().open(path);
        else
            emit studio_.failed(
                tr("%1 holds no session").arg(file.fileName()),
                tr("A session is a folder with a session.json in it. Choose that folder, or make a new "
                   "session."),
                About::kFile);
    } else if (isMotion(path)) {
        importMotion(path);
    } else if (file.fileName() == "session.json") {
        studio_.session().open(file.path());
    } else {
        openTake(file.absoluteFilePath());
    }
}

void MainWindow::openTake(const QString& path) {
    const QString folder = SessionCommands::sessionOfTake(path);
    if (folder.isEmpty()) {
        studio_.openLoose(path);
        return;
    }
    studio_.session().open(folder, QFileInfo(path).completeBaseName());
}

void MainWindow::recoverTake(const QString& path) {
    recovery_wanted_ = QFileInfo(path).absoluteFilePath();
    openTake(recovery_wanted_);
}

/// What another program has open it may be recording just now.
void MainWindow::recoverWanted(SessionMarker::Finding finding) {
    SessionModel& session = studio_.session();
    const QFileInfo wanted(std::exchange(recovery_wanted_, {}));
    if (finding == SessionMarker::Finding::kInUse)
        return;
    const int index = session.session().findTake(wanted.completeBaseName().toStdString());
    if (index < 0)
        return;
    const SessionTake& take = session.session().takes[static_cast<size_t>(index)];
    if (take.state == TakeState::kRecording && QFileInfo(session.takePath(index)) == wanted)
        session.recover(index);
}

/// What concerns the new session is told from opened() on.
void MainWindow::onSessionExchanged() {
    const SessionModel& session = studio_.session();
    const QString now =
        session.isOpen() ? QString::fromStdString(session.session().folder.string()) : QString();
    if (now == std::exchange(folder_, now))
        return;
    for (const About about : {About::kSession, About::kTakes, About::kCapture, About::kSuit, About::kTake,
                              About::kProcess, About::kFile})
        forget(about);
}

void MainWindow::onSessionOpened() {
    SessionModel& session = studio_.session();
    const bool open = session.isOpen();
    for (const Command command : {Command::kBody, Command::kShowFolder, Command::kCloseSession})
        (*actions_)[command]->setEnabled(open);
    if (!open) {
        marker_.release();
        session_notices_->forget();
        goTo(Step::kStart);
        return;
    }
    const QString folder = QString::fromStdString(session.session().folder.string());
    const SessionMarker::Finding finding = marker_.mark(folder);
    session.setReadOnly(finding == SessionMarker::Finding::kNoMarker);
    recoverWanted(finding);
    session_notices_->tellMarker(finding);
    recent_.remember(folder);
    const bool is_new = session.session().takes.empty();
    if (is_new && (step_ == Step::kRecord || step_ == Step::kCalibrate))
        return;  // it was made for what begins here
    goTo(is_new ? Step::kConnect : Step::kReview);
}

void MainWindow::onTakeOpened() {
    TakeDocument& take = studio_.take();
    const bool open = take.isOpen();
    top_bar_->steps().setState(TopBar::indexOf(Step::kRecord),
                               open ? StepBar::State::kDone : StepBar::State::kOpen);
    notices_->remove(kLooseTake);
    if (!open || (studio_.session().isOpen() && studio_.session().currentTake() >= 0))
        return;
    notices_->add(
        {Tone::kNeutral, tr("%1 belongs to no session").arg(QFileInfo(take.path()).completeBaseName()),
         tr("It can be seen, processed and exported as it is. Ratings, notes and performers are kept in a "
            "session."),
         tr("Import into a session"),
         [this, path = take.path()] { SessionCommands::import(this, studio_, {path}); }, kLooseTake});
}

void MainWindow::forget(About about) {
    for (const QString& topic : std::exchange(told_[about], {}))
        notices_->remove(topic);
}

void MainWindow::onFailure(const QString& what, const QString& remedy, About about) {
    if (about == About::kFile)
        forget(about);  // of files the latest counts
    told_[about] += what;
    notices_->add({Tone::kError, what, remedy, {}, {}, {}});
}

void MainWindow::onTornTake(const QString& path, const QString& why) {
    const QString title = tr("%1 is damaged").arg(QFileInfo(path).completeBaseName());
    told_[About::kTake] += title;
    notices_->add({Tone::kError,
                   title,
                   tr("%1 What can be read goes into a new take; the damaged file is kept.", "why")
                       .arg(withFullStop(why)),
                   tr("Save what can be read"),
                   [this, path] { studio_.saveReadable(path); },
                   {}});
}

/// The model words the whole: what happened, what is safe, what to do; its first sentence becomes the title.
void MainWindow::onMessage(const QString& message, About about) {
    onFailure(firstSentence(message), otherSentences(message), about);
}

void MainWindow::onWarning(const QString& message, About about) {
    told_[about] += firstSentence(message);
    notices_->add({Tone::kWarn, firstSentence(message), otherSentences(message), {}, {}, {}});
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!localPaths(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QStringList paths = localPaths(*event->mimeData());
    event->acceptProposedAction();
    if (paths.isEmpty())
        return;
    const bool all_takes = std::all_of(paths.begin(), paths.end(), isTake);
    if (all_takes && studio_.session().isOpen())
        studio_.session().importTakes(paths);
    else if (all_takes && paths.size() > 1)
        SessionCommands::import(this, studio_, paths);
    else if (std::all_of(paths.begin(), paths.end(), isRecording))
        importRecording(paths);
    else
        open(paths.first());
}

bool MainWindow::mayClose() {
    QStringList running;
    for (const Job* job : studio_.jobs().all())
        if (job->state() == Job::State::kRunning)
            running.append(job->title());
    if (running.isEmpty())
        return true;
    return isAnsweredYes(
        {tr("Close Noctule"), tr("%n job(s) are still running", nullptr, running.size()),
         tr("%1\n\nCancelled jobs leave their takes as they were.", "list of jobs").arg(running.join('\n')),
         tr("Go on working"), tr("Cancel jobs and close")},
        this);
}

void MainWindow::endInGoodOrder() {
    asks_nothing_ = true;
    // A question that stands is answered with its safe answer; each dialog may have one below it.
    for (QWidget* dialog = QApplication::activeModalWidget(); dialog && dialog->close();)
        dialog = QApplication::activeModalWidget();
    close();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayStopTake() || (!closes_after_take_ && !asks_nothing_ && !mayClose())) {
        event->ignore();
        return;
    }
    for (Job* job : studio_.jobs().all())
        job->cancel();
    studio_.session().saveNow();
    docks_->keep();
    studio_.settings().setValue("window/geometry", saveGeometry());
    studio_.settings().setValue("window/maximised", isMaximized());
    marker_.release();
    event->accept();
}

}  // namespace noctule::ui
