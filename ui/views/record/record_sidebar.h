// SPDX-License-Identifier: Apache-2.0
// Left dock of Record: the takes of the session with the one that is being recorded, the shot list, and the
// markers of the take that runs.
#pragma once

#include <QWidget>

#include "ui/models/studio.h"

namespace noctule::ui {

class MarkList;
class RecordRun;
class SectionHeader;
class ShotList;
class TakeList;

class RecordSidebar : public QWidget {
    Q_OBJECT
public:
    RecordSidebar(Studio& studio, RecordRun& run, QWidget* parent = nullptr);

    TakeList& takes() { return *takes_; }
    ShotList& shots() { return *shots_; }
    MarkList& marks() { return *marks_; }
    /// "turn_003"; empty: no take runs.
    QString runningTake() const;

private:
    class RunningTake;
    void refresh();

    Studio& studio_;
    RecordRun& run_;
    SectionHeader* header_;
    TakeList* takes_;
    RunningTake* running_;
    ShotList* shots_;
    MarkList* marks_;
};

}  // namespace noctule::ui
