// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/mark_list.h"

#include <QVBoxLayout>

#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {
namespace {

QWidget* rowOf(const TakeMark& mark) {
    auto* row = new QWidget;
    auto* content = makeRow(row, {12, 0, 12, 0}, 8);
    const bool marker = mark.kind == TakeMark::Kind::kMarker;
    content->addWidget(new IconLabel(
        marker ? "marker" : "note", [] { return Theme::get().tokens().acc; }, 14));
    content->addWidget(new ElidedLabel(mark.text), 1);
    content->addWidget(new Label(timeText(mark.t_s), TextRole::kBody, Ink::kLabel));
    keepSize(*row, 0, 26);
    return row;
}

}  // namespace

MarkList::MarkList(RecordRun& run, QWidget* parent)
    : QWidget(parent),
      run_(run),
      header_(new SectionHeader(tr("Markers in this take"))),
      column_(makeColumn(this, {0, 8, 0, 12})) {
    addRow(column_, 0, {12, 0, 12, 0})->addWidget(header_);
    connect(&run, &RecordRun::marksChanged, this, &MarkList::refresh);
    refresh();
}

void MarkList::refresh() {
    if (run_.marks().size() < rows_.size()) {
        qDeleteAll(rows_);
        rows_.clear();
    }
    while (rows_.size() < run_.marks().size()) {
        rows_.push_back(rowOf(run_.marks()[rows_.size()]));
        column_->addWidget(rows_.back());
    }
    header_->setHint(rows_.empty() ? QString() : QString::number(count()));
    setVisible(!rows_.empty());
}

}  // namespace noctule::ui
