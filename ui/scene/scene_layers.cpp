// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene_layers.h"

namespace noctule::ui {

namespace {

constexpr std::array kNames{"mesh", "skeleton", "boards", "rays", "trails", "contacts", "ghost", "grid"};

QString key(Step step, const QString& name) {
    return settingsGroup(step) + QLatin1Char('/') + name;
}

}  // namespace

QString settingsName(SceneLayer layer) {
    return QString::fromLatin1(kNames[static_cast<size_t>(layer)]);
}

QString settingsGroup(Step step) {
    constexpr std::array kSteps{"start",  "connect", "calibrate", "record",
                                "review", "export",  "performer", "robot"};
    return QStringLiteral("scene/") + QString::fromLatin1(kSteps[static_cast<size_t>(step)]);
}

SceneLayers loadLayers(QSettings& settings, Step step) {
    SceneLayers layers;
    for (int i = 0; i < kSceneLayerCount; ++i) {
        const auto layer = static_cast<SceneLayer>(i);
        layers.set(layer, settings.value(key(step, settingsName(layer)), layers.has(layer)).toBool());
    }
    // Who is recorded walks about; a take under review is looked at as a whole.
    layers.follow = settings.value(key(step, QStringLiteral("follow")), step == Step::kRecord).toBool();
    return layers;
}

void saveLayers(QSettings& settings, Step step, const SceneLayers& layers) {
    for (int i = 0; i < kSceneLayerCount; ++i) {
        const auto layer = static_cast<SceneLayer>(i);
        settings.setValue(key(step, settingsName(layer)), layers.has(layer));
    }
    settings.setValue(key(step, QStringLiteral("follow")), layers.follow);
}

}  // namespace noctule::ui
