// SPDX-License-Identifier: Apache-2.0
// Left dock of Review: the takes of the session, and below them what belongs to the open take: its results,
// its reference, its notes and what it was made with.
#pragma once

#include <QWidget>

#include "ui/models/studio.h"

class QBoxLayout;
class QMenu;

namespace noctule::ui {

class Button;
class FullReport;
class JobProgress;
class NotesPanel;
class ReferencePanel;
class RunList;
class SectionHeader;
class ToolButton;
class TakeList;

class ReviewSidebar : public QWidget {
    Q_OBJECT
public:
    ReviewSidebar(Studio& studio, FullReport& report, QWidget* parent = nullptr);

    TakeList& takes() { return *takes_; }
    /// Names of those that wait for their first result.
    QStringList unprocessedTakes() const;
    RunList& runs() { return *runs_; }
    ReferencePanel& reference() { return *reference_; }
    NotesPanel& notes() { return *notes_; }
    Button* reprocessButton() { return reprocess_; }
    JobProgress& progress() { return *progress_; }

signals:
    void processingWanted();

private:
    ToolButton* makeMenu();
    QWidget* makeTakeParts(FullReport& report);
    void fillMenu(QMenu& menu);
    void refresh();

    Studio& studio_;
    TakeList* takes_;
    QWidget* of_take_ = nullptr;
    SectionHeader* results_ = nullptr;
    RunList* runs_ = nullptr;
    Button* reprocess_ = nullptr;
    JobProgress* progress_ = nullptr;
    QString followed_;  ///< the take whose jobs it shows
    ReferencePanel* reference_ = nullptr;
    NotesPanel* notes_ = nullptr;
};

}  // namespace noctule::ui
