// SPDX-License-Identifier: Apache-2.0
// The row of tools on a 3D picture: layers, follow, picture export and the choice of view. What does not fit
// moves into a menu at its end.
#pragma once

#include <QWidget>
#include <vector>

#include "core/render/camera.h"
#include "ui/scene/scene_layers.h"

class QComboBox;
class QMenu;

namespace noctule::ui {

class ToolButton;

class SceneTools : public QWidget {
    Q_OBJECT
public:
    explicit SceneTools(QWidget* parent);

    void setLayers(const SceneLayers& layers);
    void setView(CameraView view);
    /// Layers that make no sense here (rays of a figure at rest) are left out.
    void setOffered(const std::vector<SceneLayer>& layers, bool follow);
    /// Shows as much as fits and takes that much room.
    void fitInto(int width_px);

signals:
    void layerToggled(noctule::ui::SceneLayer layer, bool shown);
    void followToggled(bool follow);
    void viewChosen(noctule::CameraView view);
    void pictureWanted();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct LayerTool {
        SceneLayer layer;
        ToolButton* button;
        QString name;
        bool offered = true;
    };
    void addLayers();
    void addFollowAndCamera();
    void addViews();
    void fillMore();
    int widthNeeded() const;

    std::vector<LayerTool> layers_;
    ToolButton* follow_ = nullptr;
    ToolButton* camera_ = nullptr;
    ToolButton* more_ = nullptr;
    QMenu* more_menu_ = nullptr;
    QComboBox* views_ = nullptr;
};

}  // namespace noctule::ui
