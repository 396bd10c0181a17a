// SPDX-License-Identifier: Apache-2.0
// What is switched on in a 3D view, kept per step of the studio.
#pragma once

#include <QSettings>
#include <QString>
#include <array>

#include "ui/models/studio.h"

namespace noctule::ui {

enum class SceneLayer { kMesh, kSkeleton, kBoards, kRays, kTrails, kContacts, kGhost, kGrid };
inline constexpr int kSceneLayerCount = 8;

/// Which motion of the take under review a view shows.
enum class SceneSubject {
    kShown,     ///< the shown result, with the other one as its ghost
    kCompared,  ///< the compared result or the reference, alone: for a second view beside the first
};

struct SceneLayers {
    std::array<bool, kSceneLayerCount> shown{true, true, true, true, false, true, true, true};
    bool follow = false;

    bool has(SceneLayer layer) const { return shown[static_cast<size_t>(layer)]; }
    void set(SceneLayer layer, bool on) { shown[static_cast<size_t>(layer)] = on; }
};

/// Name in settings: "mesh", "ghost".
QString settingsName(SceneLayer layer);
/// The group of a step's 3D view: "scene/review".
QString settingsGroup(Step step);

SceneLayers loadLayers(QSettings& settings, Step step);
void saveLayers(QSettings& settings, Step step, const SceneLayers& layers);

}  // namespace noctule::ui
