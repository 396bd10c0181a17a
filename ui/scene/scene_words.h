// SPDX-License-Identifier: Apache-2.0
// What a 3D view says in words: legends, the callout of what is chosen, and the description for those who
// cannot see it.
#pragma once

#include <QString>

#include "ui/scene/figure_scene.h"
#include "ui/scene/live_scene.h"
#include "ui/scene/scene_overlay.h"
#include "ui/scene/take_scene.h"

namespace noctule::ui {

/// "Result 2", and of what it is compared with. Beside another view a view always says which one it is.
std::vector<SceneLegend> takeLegends(TakeDocument& take, const ComposedScene& composed,
                                     const SceneLayers& layers, bool beside_other = false);
/// "Left shin, board 14" and the chosen pair's confidence; nothing when no board or source is chosen.
std::optional<SceneCallout> partCallout(const Suit& suit, const Selection& selection,
                                        const ComposedScene& composed, bool has_ranges);
std::optional<SceneCallout> figureCallout(const FigureScene& figure);
/// "Body at 0:17.4, 57 of 144 pairs good"
QString takeDescription(ReviewContext& review, const ComposedScene& composed,
                        const std::optional<SceneCallout>& callout);
/// "Live body, 57 of 144 pairs good"
QString liveDescription(const ComposedScene& composed, const std::optional<SceneCallout>& callout);
QString figureDescription(const FigureScene& figure);
/// Why there is no body to see; empty when there is one or it is coming.
QString whyEmpty(ReviewContext& review);
QString whyEmpty(const LiveScene& live);

/// A performer was lost while the rest pose was held: "Bea was lost at 0:02, before the rest pose ended".
struct LostWords {
    QString what, consequence;
};
LostWords lostInRest(const QString& performer, double at_s);

/// "46 mm ±5"; from a metre on "1.27 m ±0.01"; or "1.8″ ±0.2″". The error is one sigma, left out where it
/// rounds to zero.
QString distanceInWords(const ComposedScene::Distance& distance);
/// "right wrist of A to left wrist of B"
QString pairOfDistance(const ComposedScene::Distance& distance);

}  // namespace noctule::ui
