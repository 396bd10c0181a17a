// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/performer_switch.h"

#include <QCoreApplication>

#include "ui/style/performer_disc.h"

namespace noctule::ui {

QString performerName(const TakeDocument& take, int index) {
    const std::string& name = take.subjects()[static_cast<size_t>(index)].name;
    return name.empty()
               ? QCoreApplication::translate("PerformerSwitch", "Performer %1").arg(performerLetter(index))
               : QString::fromStdString(name);
}

PerformerSwitch::PerformerSwitch(ReviewContext& review, QWidget* parent)
    : PerformerButtons(tr("Shown"), parent), review_(review) {
    connect(&review.take(), &TakeDocument::opened, this, &PerformerSwitch::refresh);
    connect(this, &PerformerButtons::chosen, this, [this](int index) {
        review_.take().setSubject(index);
        refresh();
    });
    refresh();
}

void PerformerSwitch::showNext(TakeDocument& take) {
    const int count = static_cast<int>(take.subjects().size());
    if (count > 1)
        take.setSubject((take.subject() + 1) % count);
}

void PerformerSwitch::refresh() {
    TakeDocument& take = review_.take();
    QStringList names;
    if (take.isOfSeveral())
        for (int i = 0; i < static_cast<int>(take.subjects().size()); ++i)
            names << performerName(take, i);
    setPerformers(names, take.subject());
}

}  // namespace noctule::ui
