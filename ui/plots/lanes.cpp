// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/lanes.h"

#include <QCoreApplication>
#include <array>
#include <iterator>

namespace noctule::ui {

LanePen penOfIndex(size_t index) {
    constexpr std::array kPens{LanePen::kFirst, LanePen::kSecond, LanePen::kThird, LanePen::kFourth};
    return kPens[index % kPens.size()];
}

QString laneWords(const char* text) {
    return QCoreApplication::translate("Lanes", text);
}

QString missingWords(TakeDocument& take, const QString& otherwise) {
    if (take.isLoading())
        return laneWords(QT_TRANSLATE_NOOP("Lanes", "Reading the take"));
    if (take.shownRun() < 0 && take.processing())
        return laneWords(QT_TRANSLATE_NOOP("Lanes", "Processing…"));
    if (take.shownRun() < 0)
        return laneWords(QT_TRANSLATE_NOOP("Lanes", "Process the take to see its curves"));
    return take.problem().isEmpty() ? otherwise : take.problem();
}

bool isPlotOf(const TakeDocument& take, PlotTab tab) {
    switch (tab) {
        case PlotTab::kConfidence:
        case PlotTab::kRanges:
        case PlotTab::kRawSound:
            return take.hasSources();
        case PlotTab::kBetween:
            return take.isOfSeveral();
        case PlotTab::kInertial:
        case PlotTab::kJointAngles:
        case PlotTab::kRoot:
            break;
    }
    return true;
}

std::vector<LaneContent> allLanes(const LaneSources& sources) {
    using Make = std::vector<LaneContent> (*)(const LaneSources&);
    constexpr std::array<Make, kPlotTabs> kMakes{confidenceLanes, rangeLanes, soundLanes,  inertialLanes,
                                                 angleLanes,      rootLanes,  betweenLanes};
    std::vector<LaneContent> lanes;
    for (int tab = 0; tab < kPlotTabs; ++tab)
        if (const auto plot = static_cast<PlotTab>(tab);
            sources.channels.isOn(plot) && isPlotOf(sources.take, plot)) {
            std::vector<LaneContent> more = kMakes[static_cast<size_t>(tab)](sources);
            std::move(more.begin(), more.end(), std::back_inserter(lanes));
        }
    return lanes;
}

}  // namespace noctule::ui
