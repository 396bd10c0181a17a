// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/finding_list.h"

#include <QVBoxLayout>

#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/wizards/finding_card.h"

namespace noctule::ui {
namespace {

constexpr int kMostFindings = 3;

}  // namespace

FindingList::FindingList(QWidget* parent) : QWidget(parent), column_(makeColumn(this, {12, 16, 12, 12}, 8)) {}

void FindingList::setFindings(const std::vector<Finding>& findings) {
    findings_ = findings;
    refresh();
}

void FindingList::refresh() {
    clearWidgets(*column_);
    int shown = 0;
    for (const Finding& finding : findings_) {
        ProblemCard* card = findingCard(finding, toneOf(finding));
        column_->addWidget(card);
        card->setVisible(shows_all_ || shown++ < kMostFindings);
    }
    const int hidden = static_cast<int>(findings_.size()) - kMostFindings;
    if (hidden > 0) {
        auto* more = makeButton(ButtonKind::kText,
                                shows_all_ ? tr("Show the worst only") : tr("%n more", "findings", hidden));
        connect(
            more, &QPushButton::clicked, this,
            [this] {
                shows_all_ = !shows_all_;
                refresh();
            },
            Qt::QueuedConnection);
        column_->addWidget(more, 0, Qt::AlignLeft);
    }
    if (findings_.empty())
        column_->addWidget(
            (new Label(tr("No board and no source stands out."), TextRole::kBody, Ink::kLabel))->wrapped());
    column_->addStretch();
}

}  // namespace noctule::ui
