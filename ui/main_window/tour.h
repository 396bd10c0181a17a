// SPDX-License-Identifier: Apache-2.0
// Five short cards, one under each step of the top bar. It can be left at any time and never comes by itself
// again once its offer was answered.
#pragma once

#include <QFrame>
#include <QSettings>

#include "ui/models/shared_context.h"

namespace noctule::ui {

class Button;
class Label;
class MainWindow;
class TopBar;

class Tour : public QFrame {
    Q_OBJECT
public:
    Tour(MainWindow& window, TopBar& bar);

    /// Leaving it, the window is back at the step it was at.
    void start();
    int card() const { return card_; }

    /// True until the offer was answered: started or closed.
    static bool isDue(QSettings& settings);
    static void noteAnswer(QSettings& settings);

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    /// Tab stays on the card: what lies behind it is not for now.
    bool focusNextPrevChild(bool next) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show(int card);
    void place();
    void end();

    MainWindow& window_;
    TopBar& bar_;
    int card_ = 0;
    Step left_from_ = Step::kStart;
    int pointer_x_ = 0;
    Label *count_, *title_, *text_;
    Button *back_, *next_, *skip_;
};

}  // namespace noctule::ui
