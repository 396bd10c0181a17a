// SPDX-License-Identifier: Apache-2.0
// Performer and suit: left who it is and how tall, in the middle the body with the suit on it, right where
// every board and source sits. What is dragged, typed and undone shows at once everywhere.
#pragma once

#include "ui/models/review_context.h"
#include "ui/views/page.h"

class QStackedWidget;

namespace noctule::ui {

class EmptyState;
class PerformerEditor;
class PerformerListPanel;
class PerformerMeasuresPanel;
class PerformerPlacementPanel;
class SceneView;

class PerformerPage : public Page {
    Q_OBJECT
public:
    explicit PerformerPage(ReviewContext& review, QWidget* parent = nullptr);

    QString title() const override { return tr("Performer and suit"); }
    QWidget* leftDock() override { return left_; }
    QWidget* rightDock() override;

    PerformerEditor& editor() { return *editor_; }
    SceneView& scene() { return *scene_; }
    PerformerMeasuresPanel& measures() { return *measures_; }
    PerformerPlacementPanel& placement() { return *placement_; }

private:
    QWidget* makeLeft();
    void addActions();
    void showPerformer();
    void showPart();

    PerformerEditor* editor_;
    QStackedWidget* centre_;
    EmptyState* empty_;
    SceneView* scene_;
    PerformerListPanel* performers_ = nullptr;
    PerformerMeasuresPanel* measures_ = nullptr;
    PerformerPlacementPanel* placement_;
    QWidget *left_, *right_;
};

}  // namespace noctule::ui
