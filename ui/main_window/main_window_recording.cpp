// SPDX-License-Identifier: Apache-2.0
// What the window knows of a take that is being recorded, whatever page is shown.
#include "ui/main_window/main_window.h"
#include "ui/main_window/top_bar.h"
#include "ui/style/words.h"
#include "ui/views/record/record_page.h"
#include "ui/widgets/question.h"

namespace noctule::ui {

void MainWindow::connectSuit() {
    // The page has to hear of every take, also of one that was begun elsewhere.
    connect(&studio_.suits(), &LiveSuits::changed, this, [this] {
        if (studio_.suits().isTakeOpen())
            page(Step::kRecord);
        showRecording();
    });
    connect(
        &studio_.remoteStart(), &RemoteStart::startWanted, this,
        [this](const QString& name, const QString& notes) { recordRun().beginFromElsewhere(name, notes); });
    connect(&studio_.remoteStart(), &RemoteStart::stopWanted, this,
            [this] { recordRun().stopFromElsewhere(); });
    connect(
        &studio_.suits(), &LiveSuits::recordingEnded, this,
        [this] {
            if (closes_after_take_)
                close();
        },
        Qt::QueuedConnection);
    connect(&studio_.placeReset(), &PlaceReset::changed, this, &MainWindow::showPlaceReset);
    showPlaceReset();
    showRecording();
}

void MainWindow::showPlaceReset() {
    const QString why_not = studio_.placeReset().whyNot();
    const bool counts = studio_.placeReset().isCounting();
    for (const Command command : {Command::kResetPlace, Command::kResetPlaceLater}) {
        const bool ends = counts && command == Command::kResetPlaceLater;  // it can always be ended
        (*actions_)[command]->setEnabled(ends || why_not.isEmpty());
        (*actions_)[command]->setToolTip(ends ? QString() : why_not);  // empty: its text
    }
}

RecordRun& MainWindow::recordRun() {
    return dynamic_cast<RecordPage&>(page(Step::kRecord)).run();
}

void MainWindow::recordOrStop() {
    RecordRun& run = recordRun();
    // A robot that is driven would hold when its page is left.
    const bool drives = step_ == Step::kRobot && (run.state() == RecordRun::State::kReady ||
                                                  run.state() == RecordRun::State::kCountdown);
    if (run.state() != RecordRun::State::kRecording && !drives)
        goTo(Step::kRecord);
    if (run.state() != RecordRun::State::kNoSuit)
        run.press();
}

void MainWindow::showRecording() {
    const LiveSuits& suits = studio_.suits();
    top_bar_->showRecording(suits.isTakeOpen() ? std::optional(suits.recordedSeconds()) : std::nullopt);
}

/// Asks when a take is being recorded. Stopped, it becomes complete first; then the window closes by itself.
bool MainWindow::mayStopTake() {
    LiveSuits& suits = studio_.suits();
    if (!suits.isTakeOpen())
        return true;
    if (suits.phase() != LiveSuit::Phase::kSaving && !closes_after_take_ && !asks_nothing_) {
        const Question question{tr("Close Noctule"), tr("The take is being recorded"),
                                tr("It runs for %1. Stopped now, it is complete up to here.")
                                    .arg(timeText(suits.recordedSeconds(), 0)),
                                tr("Cancel"), tr("Stop and close")};
        if (!isAnsweredYes(question, this) || !mayClose())
            return false;
    }
    if (!suits.isTakeOpen())
        return true;  // it ended while the question stood
    closes_after_take_ = true;
    suits.stopRecording();
    return false;
}

}  // namespace noctule::ui
