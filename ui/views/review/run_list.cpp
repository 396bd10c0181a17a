// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/run_list.h"

#include <QVBoxLayout>

#include "core/math/conventions.h"
#include "ui/style/words.h"
#include "ui/views/review/run_row.h"
#include "ui/views/review_words.h"
#include "ui/views/scaled_layout.h"

namespace noctule::ui {

RunList::RunList(ReviewContext& review, FullReport& report, QWidget* parent)
    : QWidget(parent), review_(review), report_(report), column_(makeColumn(this)) {
    setAccessibleName(tr("Results"));
    connect(&review.take(), &TakeDocument::opened, this, &RunList::rebuild);
    connect(&review.take(), &TakeDocument::runsChanged, this, &RunList::refresh);
    connect(&review.take(), &TakeDocument::reportChanged, this, &RunList::refresh);
    connect(&report, &FullReport::changed, this, &RunList::refresh);
    rebuild();
}

void RunList::rebuild() {
    qDeleteAll(rows_);
    rows_.clear();
    const auto overview = review_.take().overview();
    const int runs = overview ? static_cast<int>(overview->runs.size()) : 0;
    for (int run = 0; run < runs; ++run) {
        auto* row = new RunRow(runTitle(overview->runs[static_cast<size_t>(run)]));
        connect(row, &RunRow::clicked, this, [this, run, row] { setOn(run, !row->isChecked()); });
        column_->addWidget(row);
        rows_.push_back(row);
    }
    refresh();
}

void RunList::refresh() {
    const TakeDocument& take = review_.take();
    const auto overview = take.overview();
    if (!overview || count() != static_cast<int>(overview->runs.size()))
        return;  // the rows are of the take before; rebuild() follows
    for (int run = 0; run < count(); ++run) {
        row(run)->setChecked(run == take.shownRun() || run == take.comparedRun());
        row(run)->setState(take.numberOf(run), detail(run));
    }
}

QString RunList::detail(int run) const {
    const TakeDocument& take = review_.take();
    const ReviewRun& result = take.overview()->runs[static_cast<size_t>(run)];
    const QString use = useInWords(run), people = peopleInWords(result);
    if (!people.isEmpty())
        return tr("%1; %2", "use of a result, performers").arg(use, people);
    return result.settings.root_given ? tr("%1, root given").arg(use) : use;
}

QString RunList::useInWords(int run) const {
    const TakeDocument& take = review_.take();
    const auto mean_deg = report_.meanError_deg(run);
    const QString error = mean_deg ? degreesText(radians(*mean_deg)) : QString();
    if (run == take.shownRun())
        return mean_deg ? tr("%1 mean, shown").arg(error) : tr("shown");
    if (run == take.comparedRun())
        return mean_deg ? tr("%1 mean, compared").arg(error) : tr("compared");
    return mean_deg ? tr("%1 mean, hidden").arg(error) : tr("hidden");
}

void RunList::setOn(int run, bool on) {
    TakeDocument& take = review_.take();
    if (on && take.shownRun() < 0)
        take.setShownRun(run);
    else if (on)
        take.setComparedRun(run);
    else if (run == take.comparedRun())
        take.setComparedRun(-1);
    else if (take.comparedRun() >= 0) {
        const int other = take.comparedRun();
        take.setComparedRun(-1);
        take.setShownRun(other);
    }
    refresh();
}

}  // namespace noctule::ui
