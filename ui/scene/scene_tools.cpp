// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene_tools.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {

namespace {

/// What gives way first when the row is short of room, and what goes after the choice of view.
constexpr std::array kFirstToGo{SceneLayer::kGrid,     SceneLayer::kContacts, SceneLayer::kTrails,
                                SceneLayer::kSkeleton, SceneLayer::kGhost,    SceneLayer::kBoards};
constexpr std::array kLastToGo{SceneLayer::kRays, SceneLayer::kMesh};

}  // namespace

SceneTools::SceneTools(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setSizeConstraint(QLayout::SetNoConstraint);
    addLayers();
    addFollowAndCamera();
    addViews();
    const auto restyle = [row] {
        const Theme& theme = Theme::get();
        row->setContentsMargins(theme.px(2), theme.px(2), theme.px(2), theme.px(2));
        row->setSpacing(theme.px(2));
    };
    restyle();
    connect(&Theme::get(), &Theme::changed, this, restyle);
}

void SceneTools::addLayers() {
    struct Row {
        SceneLayer layer;
        const char* icon;
        QString name;
        QKeySequence keys;
    };
    const std::array rows{
        Row{SceneLayer::kMesh, "mesh", tr("Body"), {}},
        Row{SceneLayer::kSkeleton, "skeleton", tr("Skeleton"), {}},
        Row{SceneLayer::kBoards, "board", tr("Boards and sources"), {}},
        Row{SceneLayer::kRays, "rays", tr("Rays"), QKeySequence(Qt::Key_R)},
        Row{SceneLayer::kTrails, "trail", tr("Trails of hands and feet"), {}},
        Row{SceneLayer::kContacts, "foot", tr("Ground contacts"), {}},
        Row{SceneLayer::kGhost, "ghost", tr("Second motion as ghost"), QKeySequence(Qt::Key_G)},
        Row{SceneLayer::kGrid, "grid", tr("Grid"), {}}};
    for (const Row& row : rows) {
        auto* button = new ToolButton(QString::fromLatin1(row.icon), row.name, row.keys, this);
        button->setCheckable(true);
        layout()->addWidget(button);
        layers_.push_back({row.layer, button, row.name});
        connect(button, &QAbstractButton::clicked, this,
                [this, layer = row.layer](bool shown) { emit layerToggled(layer, shown); });
    }
    more_ = new ToolButton(QStringLiteral("more"), tr("More layers"), {}, this);
    more_menu_ = new QMenu(more_);
    more_->setMenu(more_menu_);
    more_->setPopupMode(QToolButton::InstantPopup);
    layout()->addWidget(more_);
}

void SceneTools::addFollowAndCamera() {
    follow_ = new ToolButton(QStringLiteral("follow"), tr("Follow the body"), QKeySequence("Shift+F"), this);
    follow_->setCheckable(true);
    layout()->addWidget(follow_);
    connect(follow_, &QAbstractButton::clicked, this, &SceneTools::followToggled);
    camera_ = new ToolButton(QStringLiteral("camera"), tr("Save as picture"), {}, this);
    layout()->addWidget(camera_);
    connect(camera_, &QAbstractButton::clicked, this, &SceneTools::pictureWanted);
}

void SceneTools::addViews() {
    views_ = new QComboBox(this);
    views_->setAccessibleName(tr("View"));
    views_->setToolTip(tr("View from the front (1), the side (3) or above (7)"));
    views_->addItem(tr("Free view"), static_cast<int>(CameraView::kFree));
    views_->addItem(tr("Front"), static_cast<int>(CameraView::kFront));
    views_->addItem(tr("Side"), static_cast<int>(CameraView::kSide));
    views_->addItem(tr("Top"), static_cast<int>(CameraView::kTop));
    views_->setFrame(false);
    views_->setFocusPolicy(Qt::TabFocus);  // a click leaves Space to the page: it plays, or records
    layout()->addWidget(views_);
    connect(views_, QOverload<int>::of(&QComboBox::activated), this,
            [this] { emit viewChosen(static_cast<CameraView>(views_->currentData().toInt())); });
}

void SceneTools::setLayers(const SceneLayers& layers) {
    for (const LayerTool& tool : layers_)
        tool.button->setChecked(layers.has(tool.layer));
    follow_->setChecked(layers.follow);
    fillMore();
}

void SceneTools::setView(CameraView view) {
    const QSignalBlocker blocker(views_);
    views_->setCurrentIndex(views_->findData(static_cast<int>(view)));
}

void SceneTools::setOffered(const std::vector<SceneLayer>& layers, bool follow) {
    for (LayerTool& tool : layers_)
        tool.offered = std::find(layers.begin(), layers.end(), tool.layer) != layers.end();
    follow_->setVisible(follow);
}

int SceneTools::widthNeeded() const {
    int width = layout()->contentsMargins().left() + layout()->contentsMargins().right();
    for (int i = 0; i < layout()->count(); ++i) {
        const QWidget* widget = layout()->itemAt(i)->widget();
        if (!widget->isHidden())
            width += widget->sizeHint().width() + layout()->spacing();
    }
    return width - layout()->spacing();
}

void SceneTools::fitInto(int width_px) {
    for (const LayerTool& tool : layers_)
        tool.button->setVisible(tool.offered);
    more_->setVisible(false);
    views_->setVisible(true);
    const auto give_up = [this, width_px](SceneLayer layer) {
        if (widthNeeded() <= width_px)
            return;
        more_->setVisible(true);
        for (const LayerTool& tool : layers_)
            if (tool.layer == layer)
                tool.button->setVisible(false);
    };
    std::ranges::for_each(kFirstToGo, give_up);
    if (widthNeeded() > width_px)
        views_->setVisible(false);
    std::ranges::for_each(kLastToGo, give_up);
    fillMore();
    resize(widthNeeded(), sizeHint().height());
}

void SceneTools::fillMore() {
    more_menu_->clear();
    for (const LayerTool& tool : layers_) {
        if (!tool.offered || !tool.button->isHidden())
            continue;
        QAction* action = more_menu_->addAction(tool.name);
        action->setCheckable(true);
        action->setChecked(tool.button->isChecked());
        connect(action, &QAction::triggered, this,
                [this, layer = tool.layer](bool shown) { emit layerToggled(layer, shown); });
    }
}

void SceneTools::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    QColor surface = Theme::get().tokens().panel;
    surface.setAlphaF(0.82);
    paintBox(painter, rect(), Theme::get().px(6), surface);
}

}  // namespace noctule::ui
