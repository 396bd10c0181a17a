// SPDX-License-Identifier: Apache-2.0
// Step Record: the live body, the record button and what has to be seen while a take runs. Without a suit the
// page says so and shows the ways to one.
#pragma once

#include <QPointer>

#include "ui/models/studio.h"
#include "ui/views/page.h"
#include "ui/views/record/record_run.h"

class QStackedWidget;

namespace noctule::ui {

class NoSuit;
class RecordActions;
class RecordCenter;
class RecordReadiness;
class RecordSidebar;

class RecordPage : public Page {
    Q_OBJECT
public:
    explicit RecordPage(Studio& studio, QWidget* parent = nullptr);
    ~RecordPage() override;

    QString title() const override { return tr("Record"); }
    QWidget* leftDock() override;
    QWidget* rightDock() override;
    QList<QAction*> menuActions() const override;
    void enter() override;
    /// A countdown ends, a take goes on.
    void leave() override;

    RecordRun& run() { return run_; }
    RecordCenter& center() { return *center_; }
    NoSuit& noSuit() { return *no_suit_; }
    RecordSidebar& sidebar();
    RecordReadiness& readiness();
    bool showsSuit() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void refresh();
    void tellTitles();

    Studio& studio_;
    RecordRun run_;
    RecordCenter* center_;
    NoSuit* no_suit_;
    QStackedWidget* stack_;
    QPointer<RecordSidebar> sidebar_;  // the docks may be owned by the main window
    QPointer<RecordReadiness> readiness_;
    RecordActions* actions_;
};

}  // namespace noctule::ui
