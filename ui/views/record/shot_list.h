// SPDX-License-Identifier: Apache-2.0
// What is to be recorded: a row per shot with how many of its takes are there, and the one that the next take
// is for. A click chooses a shot, another one leaves it.
#pragma once

#include <QListWidget>
#include <QWidget>

#include "ui/models/capture_context.h"

namespace noctule::ui {

class Button;
class Label;
class RecordRun;
class SectionHeader;

class ShotList : public QWidget {
    Q_OBJECT
public:
    ShotList(CaptureContext& capture, RecordRun& run, QWidget* parent = nullptr);

    QListWidget& rows() { return *rows_; }
    Button& pasteButton() { return *paste_; }
    Button& editButton() { return *edit_; }

private:
    void refresh();
    void choose(int row);
    void edit(const QString& text, bool pasted);

    CaptureContext& capture_;
    RecordRun& run_;
    SectionHeader* header_;
    QListWidget* rows_;
    Label* empty_;
    Button* paste_;
    Button* edit_;
};

}  // namespace noctule::ui
