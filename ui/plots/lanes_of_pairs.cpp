// SPDX-License-Identifier: Apache-2.0
// Confidence and ranges of source-board pairs.
#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "ui/models/part_names.h"
#include "ui/plots/confidence_legend.h"
#include "ui/plots/heard_switch.h"
#include "ui/plots/lanes.h"

namespace noctule::ui {
namespace {

bool exists(const RangeTable& table, const Suit& suit, PairChannel pair) {
    return pair.source < table.source_count && pair.board < table.board_count &&
           pair.source < static_cast<int>(suit.sources.size()) &&
           pair.board < static_cast<int>(suit.boards.size());
}

/// "Hat to left hand"; where the source is another's, "B to A: hat to left hand".
QString heardName(const TakeDocument& take, PairChannel pair) {
    const QString name = pairName(*take.pairSuit(), pair.source, pair.board);
    return take.showsOwnPairs() ? name
                                : laneWords(QT_TRANSLATE_NOOP("Lanes", "%1: %2")).arg(heardWords(take), name);
}

/// Points of one column of a pair's ranges.
LaneCurve pointsOf(const std::shared_ptr<const RangeTable>& table, PairChannel pair,
                   const std::vector<float>& value, const QString& column) {
    const PairTrack& track = table->pair(pair.source, pair.board);
    LaneCurve curve;
    curve.column = column;
    curve.value = std::make_shared<SeriesPyramid>(Series{track.t_s, value});
    curve.fate = {table, &track.fate};
    curve.hold_s = kPairHold_s;
    return curve;
}

/// What the kept ranges need, so that one that is off by a metre does not flatten the others.
std::pair<double, double> residualRange(const PairTrack& track) {
    double most_m = 0.005;
    for (size_t i = 0; i < track.t_s.size(); ++i) {
        const bool kept = track.fate[i] == RangeFate::kUsed || track.fate[i] == RangeFate::kWeighted;
        if (kept && std::isfinite(track.innovation_m[i]))
            most_m = std::max(most_m, std::abs(double{track.innovation_m[i]}));
    }
    return {-1.2 * most_m, 1.2 * most_m};
}

/// Distance; and, where an estimator tried the ranges, how far they were from what it expected.
void appendRangeLanes(std::vector<LaneContent>& lanes, const std::shared_ptr<const RangeTable>& table,
                      PairChannel pair, const QString& name) {
    const PairTrack& track = table->pair(pair.source, pair.board);
    LaneContent distance;
    distance.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "Range (m), %1")).arg(name);
    distance.empty = laneWords(QT_TRANSLATE_NOOP("Lanes", "This board never heard this source"));
    distance.unit = {1, QStringLiteral("\u00A0m"), 3};
    distance.least_span = 0.02;
    if (!track.t_s.empty())
        distance.curves.push_back(
            pointsOf(table, pair, track.distance_m,
                     laneWords(QT_TRANSLATE_NOOP("Lanes", "range (m) of %1")).arg(name)));
    lanes.push_back(distance);
    const bool tried = std::any_of(track.innovation_m.begin(), track.innovation_m.end(),
                                   [](float value) { return std::isfinite(value); });
    if (!tried)
        return;
    LaneContent residual;
    residual.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "Measured minus expected (mm), %1")).arg(name);
    residual.unit = {1000, QStringLiteral("\u00A0mm"), 1};
    residual.range = residualRange(track);
    residual.curves.push_back(
        pointsOf(table, pair, track.innovation_m,
                 laneWords(QT_TRANSLATE_NOOP("Lanes", "measured minus expected (m) of %1")).arg(name)));
    lanes.push_back(std::move(residual));
}

}  // namespace

std::vector<LaneContent> confidenceLanes(const LaneSources& sources) {
    LaneContent lane;
    lane.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "Confidence"));
    lane.empty = laneWords(QT_TRANSLATE_NOOP("Lanes", "Choose a pair in the heat map to see its confidence"));
    lane.range = {{-0.04, 1.04}};  // 0 and 1 are not cut in half
    lane.unit.tick_decimals = ConfidenceLegend::kDecimals;
    const auto overview = sources.take.overview();
    const auto table = sources.take.ranges();
    if (!overview)
        return {lane};
    if (!table)
        lane.empty = missingWords(sources.take, lane.empty);
    size_t index = 0;
    for (const PairChannel pair : sources.channels.pairs()) {
        if (!table || !exists(*table, *sources.take.pairSuit(), pair))
            continue;
        LaneCurve curve;
        curve.value = sources.take.rangeCurve(pair.source, pair.board, RangeQuantity::kConfidence);
        curve.legend = heardName(sources.take, pair);
        curve.column = laneWords(QT_TRANSLATE_NOOP("Lanes", "confidence of %1")).arg(curve.legend);
        curve.pen = penOfIndex(index++);
        curve.hold_s = kPairHold_s;
        if (curve.value)
            lane.curves.push_back(std::move(curve));
        else
            lane.empty = missingWords(sources.take, lane.empty);
    }
    return {lane};
}

std::vector<LaneContent> rangeLanes(const LaneSources& sources) {
    LaneContent empty;
    empty.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "Ranges"));
    empty.empty = laneWords(QT_TRANSLATE_NOOP("Lanes", "Choose a pair in the heat map to see its ranges"));
    const auto overview = sources.take.overview();
    const auto table = sources.take.ranges();
    if (!overview || !table) {
        if (overview)
            empty.empty = missingWords(sources.take, empty.empty);
        return {empty};
    }
    std::vector<LaneContent> lanes;
    for (const PairChannel pair : sources.channels.pairs())
        if (exists(*table, *sources.take.pairSuit(), pair))
            appendRangeLanes(lanes, table, pair, heardName(sources.take, pair));
    if (lanes.empty())
        lanes.push_back(empty);
    return lanes;
}

}  // namespace noctule::ui
