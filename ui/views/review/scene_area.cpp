// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/scene_area.h"

#include <QScopedValueRollback>

#include "ui/scene/scene_view.h"
#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {

SceneArea::SceneArea(ReviewContext& review, QWidget* parent)
    : QWidget(parent),
      review_(review),
      row_(makeRow(this, {}, 1)),
      shown_(new SceneView(review)),
      split_(new ToolButton("split", tr("Shown and compared result side by side"), {}, this)) {
    row_->addWidget(shown_, 1);
    split_->setCheckable(true);
    connect(split_, &QToolButton::clicked, this, &SceneArea::setSideBySide);
    connect(&review.take(), &TakeDocument::runsChanged, this, &SceneArea::refresh);
    connect(&Theme::get(), &Theme::changed, this, &SceneArea::placeTool);
    refresh();
}

bool SceneArea::isSideBySide() const {
    return compared_ && compared_->isVisibleTo(this);
}

bool SceneArea::canCompare() const {
    return review_.take().isOpen() && review_.take().comparedRun() != -1;
}

void SceneArea::setSideBySide(bool side_by_side) {
    const bool shows = side_by_side && canCompare();
    if (shows && !compared_)
        makeCompared();
    if (compared_)
        compared_->setVisible(shows);
    refresh();
    emit sideBySideChanged(shows);
}

void SceneArea::makeCompared() {
    compared_ = new SceneView(review_);
    compared_->setSubject(SceneSubject::kCompared);
    compared_->setCamera(shown_->camera());
    row_->addWidget(compared_, 1);
    connect(shown_, &SceneView::viewChanged, this, [this] { shareCamera(*shown_, *compared_); });
    connect(compared_, &SceneView::viewChanged, this, [this] { shareCamera(*compared_, *shown_); });
    split_->raise();
}

void SceneArea::shareCamera(SceneView& from, SceneView& to) {
    if (sharing_ || !isSideBySide())
        return;
    const QScopedValueRollback<bool> one_way(sharing_, true);
    to.setCamera(from.camera());
}

void SceneArea::refresh() {
    if (isSideBySide() && !canCompare())
        compared_->hide();
    split_->setChecked(isSideBySide());
    shown_->setBesideOther(isSideBySide());
    split_->setDisabledBecause(canCompare() ? QString()
                                            : tr("Choose a second result or the reference to compare with."));
    placeTool();
}

void SceneArea::placeTool() {
    const int inset = Theme::get().px(12), gap = Theme::get().px(8);
    split_->resize(split_->sizeHint());
    split_->move(width() - split_->width() - inset, inset);
    split_->raise();
    const int room = split_->width() + gap;
    shown_->setRoomBesideTools(isSideBySide() ? 0 : room);
    if (compared_)
        compared_->setRoomBesideTools(room);
}

void SceneArea::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    placeTool();
}

}  // namespace noctule::ui
