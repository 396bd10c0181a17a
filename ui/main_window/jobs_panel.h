// SPDX-License-Identifier: Apache-2.0
// All jobs, newest on top: progress with Cancel while they run, afterwards the result or what went wrong and
// what to do. It opens over the bottom right of the window; what ended counts as seen when it closes.
#pragma once

#include <QFrame>
#include <QPointer>
#include <map>

#include "ui/jobs/jobs.h"

class QVBoxLayout;

namespace noctule::ui {

class JobRow;
class Label;
class Button;
class ScrollArea;

class JobsPanel : public QFrame {
    Q_OBJECT
public:
    /// A child of the window that it covers; hidden at first.
    JobsPanel(Jobs& jobs, QWidget* window);

    void toggle();
    int rowCount() const { return static_cast<int>(rows_.size()); }

signals:
    /// What ended has been seen.
    void closed();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow();
    void place();

    Jobs& jobs_;
    std::map<Job*, JobRow*> rows_;
    QWidget* list_;
    QVBoxLayout* column_;
    ScrollArea* area_;
    Label* none_;
    Button* clear_;
    QPointer<QWidget> focus_before_;
};

}  // namespace noctule::ui
