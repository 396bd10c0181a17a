// SPDX-License-Identifier: Apache-2.0
// Markers and notes of the take that is being recorded, each with its time.
#pragma once

#include <QWidget>

#include "ui/views/record/record_run.h"

class QVBoxLayout;

namespace noctule::ui {

class SectionHeader;

class MarkList : public QWidget {
    Q_OBJECT
public:
    explicit MarkList(RecordRun& run, QWidget* parent = nullptr);

    int count() const { return static_cast<int>(rows_.size()); }

private:
    void refresh();

    RecordRun& run_;
    SectionHeader* header_;
    QVBoxLayout* column_;
    std::vector<QWidget*> rows_;
};

}  // namespace noctule::ui
