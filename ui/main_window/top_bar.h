// SPDX-License-Identifier: Apache-2.0
// The bar on top of the window, 52 px: mark, menus, the five steps in the centre, and at right the state of
// the suit and the way to Record. Below 1180 px the menus fold into one button. On the start page there are
// no steps yet.
#pragma once

#include <QKeySequence>
#include <QWidget>
#include <optional>

#include "ui/models/studio.h"
#include "ui/style/ink.h"

class QMenu;
class QMenuBar;

namespace noctule::ui {

class Button;
class Chip;
class StepBar;
class ToolButton;

class TopBar : public QWidget {
    Q_OBJECT
public:
    explicit TopBar(QWidget* parent = nullptr);

    QMenuBar& menuBar() { return *menus_; }
    StepBar& steps() { return *steps_; }
    /// The same menus behind one button.
    void fold(const QList<QMenu*>& menus);
    bool isFolded() const;
    void showStep(Step step);
    /// The step "Robot" stands there once a robot has been chosen.
    void showRobot(bool shown);
    /// How long the take runs; absent: none does. Seen on every page but Record, which has the clock itself.
    void showRecording(std::optional<double> seconds);
    Button& recordButton() { return *record_; }
    /// "17/18 boards", and the box; without a name no suit is connected. `needs_attention`: the step Connect
    /// is marked, also where the boards are good.
    void showSuit(Tone tone, const QString& state, const QString& name, bool needs_attention = false);

    /// Position of a step in the bar, -1 for pages that are none.
    static int indexOf(Step step);
    static Step stepAt(int index);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void stepRequested(noctule::ui::Step step);
    void recordRequested();
    void preferencesRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeLeft();
    QWidget* makeRight();
    void foldWhereNarrow();
    void showRecordButton();
    void showRecordKey();

    QMenuBar* menus_;
    ToolButton* folded_;
    StepBar* steps_;
    Chip *suit_, *box_;
    Button* record_;
    ToolButton* preferences_;
    QWidget *left_, *right_;
    Step step_ = Step::kStart;
    bool records_ = false;
    QKeySequence record_key_;
};

}  // namespace noctule::ui
