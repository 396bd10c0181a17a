// SPDX-License-Identifier: Apache-2.0
// Results of the open take: what each was made from, how good it is, and which one is shown and which one
// compared with it. Two at most are on; one is always shown.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/models/review_context.h"
#include "ui/views/report/full_report.h"

class QVBoxLayout;

namespace noctule::ui {

class RunRow;

class RunList : public QWidget {
    Q_OBJECT
public:
    RunList(ReviewContext& review, FullReport& report, QWidget* parent = nullptr);

    int count() const { return static_cast<int>(rows_.size()); }
    RunRow* row(int index) const { return rows_[static_cast<size_t>(index)]; }
    /// On or off by the operator.
    void setOn(int run, bool on);

private:
    void rebuild();
    void refresh();
    QString detail(int run) const;
    QString useInWords(int run) const;

    ReviewContext& review_;
    FullReport& report_;
    QVBoxLayout* column_;
    std::vector<RunRow*> rows_;
};

}  // namespace noctule::ui
