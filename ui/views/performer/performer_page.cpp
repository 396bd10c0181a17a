// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer/performer_page.h"

#include <QStackedWidget>

#include "ui/scene/scene_view.h"
#include "ui/views/performer/performer_editor.h"
#include "ui/views/performer/performer_list_panel.h"
#include "ui/views/performer/performer_measures_panel.h"
#include "ui/views/performer/performer_placement_panel.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {

PerformerPage::PerformerPage(ReviewContext& review, QWidget* parent)
    : Page(parent),
      editor_(new PerformerEditor(review.shared().session(), this)),
      centre_(new QStackedWidget),
      empty_(new EmptyState(tr("Performers belong to a session. Make one or open one first."),
                            tr("Go to Start"))),
      scene_(new SceneView(review, nullptr, Step::kPerformer)),
      placement_(new PerformerPlacementPanel(*editor_)),
      left_(makeLeft()),
      right_(new ScrollArea(placement_)) {
    makeColumn(this)->addWidget(centre_);
    centre_->addWidget(scene_);
    centre_->addWidget(empty_);
    addActions();
    setDockTitles(tr("Performers"), tr("Boards and sources"));
    connect(empty_, &EmptyState::activated, this, [&review] { review.shared().goTo(Step::kStart); });
    connect(scene_, &SceneView::partChosen, editor_, &PerformerEditor::choosePart);
    connect(scene_, &SceneView::placementDragged, editor_, &PerformerEditor::drag);
    connect(scene_, &SceneView::dragEnded, editor_, &PerformerEditor::endDrag);
    connect(editor_, &PerformerEditor::performerChanged, this, &PerformerPage::showPerformer);
    connect(editor_, &PerformerEditor::partChanged, this, &PerformerPage::showPart);
    showPerformer();
}

QWidget* PerformerPage::rightDock() {
    return right_;
}

QWidget* PerformerPage::makeLeft() {
    auto* content = new QWidget;
    auto* column = makeColumn(content);
    performers_ = new PerformerListPanel(*editor_);
    measures_ = new PerformerMeasuresPanel(*editor_);
    column->addWidget(performers_);
    column->addWidget(new Divider);
    addRow(column, 0, {12, 8, 12, 4})->addWidget(new SectionHeader(tr("Measures")));
    column->addWidget(measures_);
    column->addStretch();
    return new ScrollArea(content);
}

void PerformerPage::addActions() {
    auto* mirror = new QAction(tr("Mirror to the other side"), this);
    connect(mirror, &QAction::triggered, editor_, &PerformerEditor::mirror);
    auto* back = new QAction(tr("Back to the suit’s place"), this);
    connect(back, &QAction::triggered, editor_, &PerformerEditor::backToSuit);
    QWidget::addActions({mirror, back});
}

void PerformerPage::showPerformer() {
    const bool any = editor_->hasPerformer();
    centre_->setCurrentWidget(any ? static_cast<QWidget*>(scene_) : empty_);
    left_->setEnabled(any);
    right_->setEnabled(any);
    if (any)
        scene_->setFigure(editor_->actor(), editor_->performer().suit);
}

void PerformerPage::showPart() {
    if (editor_->hasPerformer() && scene_->chosenPart() != editor_->part())
        scene_->setChosenPart(editor_->part());
}

}  // namespace noctule::ui
