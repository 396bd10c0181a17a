// SPDX-License-Identifier: Apache-2.0
// The body of the shown result, and beside it, when asked for, that of the compared one, seen through the
// same camera.
#pragma once

#include <QWidget>

#include "ui/models/review_context.h"

class QBoxLayout;

namespace noctule::ui {

class SceneView;
class ToolButton;

class SceneArea : public QWidget {
    Q_OBJECT
public:
    explicit SceneArea(ReviewContext& review, QWidget* parent = nullptr);

    SceneView& shown() { return *shown_; }
    /// Null until side by side was asked for once.
    SceneView* compared() { return compared_; }
    bool isSideBySide() const;
    void setSideBySide(bool side_by_side);
    bool canCompare() const;

signals:
    void sideBySideChanged(bool side_by_side);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeCompared();
    void shareCamera(SceneView& from, SceneView& to);
    void refresh();
    void placeTool();

    ReviewContext& review_;
    QBoxLayout* row_;
    SceneView* shown_;
    SceneView* compared_ = nullptr;
    ToolButton* split_;
    bool sharing_ = false;
};

}  // namespace noctule::ui
