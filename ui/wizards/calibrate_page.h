// SPDX-License-Identifier: Apache-2.0
// Step Calibrate: what is calibrated, how old and how good, for which parts, and what to do next; the wizard
// that is open; the calibrations made before, to go back to.
#pragma once

#include <QPointer>
#include <map>

#include "ui/models/studio.h"
#include "ui/views/page.h"
#include "ui/wizards/wizard_task.h"

class QStackedWidget;
class QVBoxLayout;

namespace noctule::ui {

class Button;
class RoomPage;
class SuitSwitch;
class TaskCard;
class ToolButton;
class VerdictHeader;
class WizardPage;

class CalibratePage : public Page {
    Q_OBJECT
public:
    explicit CalibratePage(Studio& studio, QWidget* parent = nullptr);
    ~CalibratePage() override;

    QString title() const override { return tr("Calibrate"); }
    QWidget* leftDock() override;
    QWidget* rightDock() override;
    void enter() override;
    void leave() override;

    void open(WizardTask task);
    /// The check at once, and back to step Record when it is left.
    void checkBeforeTake();
    /// Back to the overview, or to where it was opened from.
    void closeWizard();
    /// The survey of the room of the take that is open.
    void openRoom();
    WizardPage& wizard() { return *wizard_; }
    RoomPage& room() { return *room_; }
    /// Of the room; hidden where there are no anchors.
    TaskCard* roomCard() { return room_card_; }
    bool showsWizard() const;
    /// A wizard has begun, and its result is not kept yet. A check keeps its result by itself.
    bool isUnderWay() const;
    /// Whose calibration is shown, where several suits are connected.
    SuitSwitch& suits() { return *suits_; }
    TaskCard& card(WizardTask task) { return *cards_.at(task); }
    /// Opens the first page, whose own button begins.
    Button* startButton(WizardTask task);
    Button* wayOn() { return way_on_; }
    Button* importButton() { return import_; }
    Button* exportButton() { return export_; }
    /// Asks first where the file is another suit's, and says what came of it.
    void importFile(const QString& path);
    /// Of the calibrations in the list, newest first; null for the one in force.
    const std::vector<Button*>& useButtons() const { return use_; }
    /// In the same order: each puts its calibration aside.
    const std::vector<ToolButton*>& asideButtons() const { return aside_; }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    QWidget* makeSuits();
    QString whyNotOtherSuit();
    QWidget* makeOverview();
    QWidget* makeOverviewSide();
    QWidget* makeHistory();
    void goOn();
    QString sessionNow() const;
    QString keptWords(WizardTask task) const;
    void followSession();
    void refresh();
    void showHistory();
    void showOverview();
    QWidget* makeAsideButton(const QString& file);
    QWidget* makeFiles();
    void chooseImport();
    bool mayUseAnother(const QString& name, const QString& other);
    void chooseExport();

    Studio& studio_;
    SuitSwitch* suits_;
    QWidget* of_suit_;  ///< holds it
    QStackedWidget *centre_, *left_, *right_;
    WizardPage* wizard_;
    RoomPage* room_;
    QWidget* overview_;
    QString session_;  ///< that the wizard was opened in
    std::map<WizardTask, TaskCard*> cards_;
    TaskCard* room_card_ = nullptr;
    VerdictHeader* verdict_ = nullptr;
    Button* way_on_ = nullptr;
    std::optional<WizardTask> next_;
    bool back_to_record_ = false;
    QVBoxLayout* history_ = nullptr;
    Button *import_ = nullptr, *export_ = nullptr;
    std::vector<Button*> use_;
    std::vector<ToolButton*> aside_;
};

}  // namespace noctule::ui
