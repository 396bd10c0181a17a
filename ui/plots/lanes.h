// SPDX-License-Identifier: Apache-2.0
// The lanes of each tab, made of what has been loaded of the take so far; asking starts loading the rest.
#pragma once

#include <vector>

#include "ui/plots/lane_content.h"
#include "ui/plots/plot_channels.h"
#include "ui/plots/sound_source.h"
#include "ui/plots/time_window.h"

namespace noctule::ui {

/// What lanes are made of.
struct LaneSources {
    TakeDocument& take;
    const PlotChannels& channels;
    SoundSource& sound;
    const TimeWindow& window;
};

std::vector<LaneContent> confidenceLanes(const LaneSources& sources);
std::vector<LaneContent> rangeLanes(const LaneSources& sources);
std::vector<LaneContent> soundLanes(const LaneSources& sources);
std::vector<LaneContent> inertialLanes(const LaneSources& sources);
std::vector<LaneContent> angleLanes(const LaneSources& sources);
std::vector<LaneContent> rootLanes(const LaneSources& sources);
/// Distances between the people of the take; none in a take of one.
std::vector<LaneContent> betweenLanes(const LaneSources& sources);

/// Whether the take has what the tab plots: pairs need sources, distances between people several of them.
bool isPlotOf(const TakeDocument& take, PlotTab tab);
/// Of all tabs that are on, in their order.
std::vector<LaneContent> allLanes(const LaneSources& sources);

/// Colours of curves of one kind in one lane, in their order.
LanePen penOfIndex(size_t index);
/// Translated; the text is marked with QT_TRANSLATE_NOOP("Lanes", ...).
QString laneWords(const char* text);
/// Why nothing is there yet: being read, failed, or not processed; `otherwise` when none of it.
QString missingWords(TakeDocument& take, const QString& otherwise);

}  // namespace noctule::ui
