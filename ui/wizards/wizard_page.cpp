// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_page.h"

#include <QApplication>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/models/part_names.h"
#include "ui/models/tones.h"
#include "ui/models/voice.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/progress_line.h"
#include "ui/wizards/field_live.h"
#include "ui/wizards/field_sensors.h"
#include "ui/wizards/result_side.h"
#include "ui/wizards/wizard_boards.h"
#include "ui/wizards/wizard_intro.h"
#include "ui/wizards/wizard_live.h"
#include "ui/wizards/wizard_rail.h"
#include "ui/wizards/wizard_result.h"

namespace noctule::ui {
namespace {

constexpr int kMostShown = 20;  ///< readings of one direction; more look the same

}  // namespace

WizardPage::WizardPage(Studio& studio, QWidget* parent)
    : QStackedWidget(parent),
      studio_(studio),
      intro_(new WizardIntro(studio)),
      live_(new WizardLive(studio)),
      field_(new FieldLive),
      solving_(new QWidget),
      progress_(new ProgressLine),
      result_(new WizardResult),
      rail_(new WizardRail),
      side_(new QStackedWidget),
      nothing_(new QWidget),
      boards_(new WizardBoards),
      field_sensors_(new FieldSensors),
      result_side_(new ResultSide(studio)) {
    auto* column = makeColumn(solving_, {32, 32, 32, 32}, 16);
    column->addStretch();
    column->addWidget(progress_);
    column->addStretch();
    for (QWidget* page : {static_cast<QWidget*>(intro_), static_cast<QWidget*>(live_),
                          static_cast<QWidget*>(field_), solving_, static_cast<QWidget*>(result_)})
        addWidget(page);
    for (QWidget* side : {nothing_, intro_->words(), static_cast<QWidget*>(boards_),
                          static_cast<QWidget*>(field_sensors_), static_cast<QWidget*>(result_side_)})
        side_->addWidget(side);
    connect(rail_, &WizardRail::leaveRequested, this, &WizardPage::leaveRequested);
    connect(rail_, &WizardRail::stepChosen, boards_, &WizardBoards::setStep);
    connect(result_side_, &ResultSide::leaveRequested, this, &WizardPage::leaveRequested);
    connect(result_side_, &ResultSide::repeatRequested, this, [this] { run_->resume(); });
    connect(progress_, &ProgressLine::cancelled, this, [this] {
        if (run_ && run_->job())
            run_->job()->cancel();
    });
}

/// Rail and side may have gone before, with the docks that hold them.
WizardPage::~WizardPage() = default;

QWidget* WizardPage::rail() {
    return rail_;
}

void WizardPage::setWayBack(const QString& words) {
    rail_->setWayBack(words);
    result_side_->setWayBack(words);
}

void WizardPage::open(WizardTask task) {
    close();
    run_ = std::make_unique<WizardRun>(studio_, task);
    was_right_ = false;
    intro_->setRun(run_.get());
    live_->setRun(run_.get());
    rail_->setRun(run_.get());
    boards_->setRun(run_.get());
    const bool turns = task == WizardTask::kMagnetometers;
    field_->setRun(turns ? run_.get() : nullptr);
    field_sensors_->setRun(turns ? run_.get() : nullptr);
    result_side_->setRun(run_.get());
    connect(run_.get(), &WizardRun::changed, this, &WizardPage::refresh);
    connect(run_.get(), &WizardRun::guided, this, &WizardPage::followGuide);
    connect(run_.get(), &WizardRun::stepKept, this, [this] {
        if (run_->tones())
            Tones::get().play();
        Voice::get().say(run_->guide()->isFinished() ? tr("Done")
                                                     : run_->stepWords(run_->step()).instruction);
    });
    refresh();
}

void WizardPage::close() {
    const std::unique_ptr<WizardRun> leaving = std::move(run_);
    if (leaving)
        leaving->blockSignals(true);
    intro_->setRun(nullptr);
    live_->setRun(nullptr);
    rail_->setRun(nullptr);
    boards_->setRun(nullptr);
    field_->setRun(nullptr);
    field_sensors_->setRun(nullptr);
    result_side_->setRun(nullptr);
}

void WizardPage::refresh() {
    using Phase = WizardRun::Phase;
    switch (run_->phase()) {
        case Phase::kIntro:
            setCurrentWidget(intro_);
            side_->setCurrentWidget(intro_->words());
            break;
        case Phase::kGuiding:
        case Phase::kTaking:
            if (run_->task() == WizardTask::kMagnetometers) {
                setCurrentWidget(field_);
                side_->setCurrentWidget(field_sensors_);
                break;
            }
            setCurrentWidget(live_);
            side_->setCurrentWidget(boards_);
            break;
        case Phase::kSolving:
            setCurrentWidget(solving_);
            side_->setCurrentWidget(nothing_);
            progress_->setText(tr("Calibrating: %1").arg(wordsOf(run_->task()).title));
            progress_->setFraction(-1);
            progress_->setCancellable(true);
            break;
        case Phase::kResult:
            if (currentWidget() != result_)
                showResult();
            setCurrentWidget(result_);
            side_->setCurrentWidget(result_side_);
            break;
    }
}

void WizardPage::showResult() {
    const CalibrationResult& result = *run_->result();
    result_->setDocument(result.document, partNames(run_->guide() ? run_->suit() : studio_.suit().suit()));
    const auto counts = result.json.find("sphere");
    if (counts == result.json.end() || counts->size() != FieldSphere::kCells)
        return;
    FieldSphere sphere;
    for (size_t cell = 0; cell < counts->size(); ++cell)
        for (int count = std::min((*counts)[cell].get<int>(), kMostShown); count > 0; --count)
            sphere.add(FieldSphere::cells()[cell].middle());
    result_->addSphere(sphere);
}

/// Heard with one's back to the screen: all is right, keep still.
void WizardPage::followGuide() {
    const bool right = run_->guide() && run_->guide()->guidance().isRight();
    if (right && !was_right_) {
        if (run_->tones())
            Tones::get().play();
        Voice::get().say(tr("Good"));
    }
    was_right_ = right;
}

bool WizardPage::handleKey(int key) {
    if (run_ && currentWidget() == field_) {
        if (key == Qt::Key_S)
            field_sensors_->skipSensor();
        else if (key == Qt::Key_V)
            run_->setTones(!run_->tones());
        else if (key == Qt::Key_Backspace)
            run_->goBack();
        return key == Qt::Key_S || key == Qt::Key_V || key == Qt::Key_Backspace;
    }
    if (!run_ || currentWidget() != live_)
        return false;
    switch (key) {
        case Qt::Key_R:
            boards_->repeatStep();
            return true;
        case Qt::Key_S:
            boards_->skipBoard();
            return true;
        case Qt::Key_Backspace:
            run_->goBack();
            return true;
        case Qt::Key_V:
            run_->setTones(!run_->tones());
            return true;
        default:
            return false;
    }
}

}  // namespace noctule::ui
