// SPDX-License-Identifier: Apache-2.0
// Joint angles and the root, of the shown run with what it thinks of its own error, of the compared run and
// of the reference.
#include <QCoreApplication>
#include <array>

#include "ui/plots/curve_names.h"
#include "ui/plots/lanes.h"

namespace noctule::ui {
namespace {

using Whose = TakeDocument::Whose;

std::shared_ptr<const SeriesPyramid> partOf(const std::shared_ptr<const MotionCurve>& curve,
                                            SeriesPyramid MotionCurve::*member) {
    if (!curve || (curve.get()->*member).empty())
        return nullptr;
    return {curve, &(curve.get()->*member)};
}

struct Wearer {
    Whose whose;
    QString legend, readout;
    LanePen pen;
};

/// The shown result first; the compared one and the reference where there are some.
std::vector<Wearer> wearersOf(const TakeDocument& take) {
    const auto result = [&](int run) {
        return laneWords(QT_TRANSLATE_NOOP("Lanes", "result %1")).arg(take.numberOf(run));
    };
    std::vector<Wearer> wearers{
        {Whose::kShown, result(take.shownRun()), QStringLiteral("%1"), LanePen::kFirst}};
    if (take.comparedRun() >= 0)
        wearers.push_back({Whose::kCompared, result(take.comparedRun()),
                           QStringLiteral("%1: %2").arg(take.numberOf(take.comparedRun()), "%1"),
                           LanePen::kSecond});
    if (take.overview()->has_reference)
        wearers.push_back({Whose::kReference, laneWords(QT_TRANSLATE_NOOP("Lanes", "reference")),
                           laneWords(QT_TRANSLATE_NOOP("Lanes", "ref %1")), LanePen::kReference});
    return wearers;
}

/// One curve of everybody who has it.
void appendCurves(LaneContent& lane, TakeDocument& take, const CurveChoice& choice) {
    for (const Wearer& wearer : wearersOf(take)) {
        const auto motion_curve = take.motionCurve(choice, wearer.whose);
        LaneCurve curve;
        curve.value = partOf(motion_curve, &MotionCurve::value);
        if (!curve.value)
            continue;
        if (wearer.whose == Whose::kShown) {
            curve.low = partOf(motion_curve, &MotionCurve::low);
            curve.high = partOf(motion_curve, &MotionCurve::high);
        }
        const bool metres = motion_curve->unit == CurveUnit::kMetres;
        lane.unit = metres ? LaneUnit{1, QStringLiteral("\u00A0m"), 3, false}
                           : LaneUnit{1, QStringLiteral("°"), 1, true};
        lane.least_span = metres ? 0.02 : 1;
        curve.legend = curve.low ? laneWords(QT_TRANSLATE_NOOP("Lanes", "%1 with 2 sigma")).arg(wearer.legend)
                                 : wearer.legend;
        curve.column = laneWords(metres ? QT_TRANSLATE_NOOP("Lanes", "%1 (m), %2")
                                        : QT_TRANSLATE_NOOP("Lanes", "%1 (deg), %2"))
                           .arg(curveName(choice), wearer.legend);
        curve.pen = wearer.pen;
        curve.readout = wearer.readout;
        curve.hold_s = kPoseHold_s;
        lane.curves.push_back(std::move(curve));
    }
}

}  // namespace

std::vector<LaneContent> angleLanes(const LaneSources& sources) {
    LaneContent empty;
    empty.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "Joint angles"));
    empty.empty = laneWords(
        QT_TRANSLATE_NOOP("Lanes", "Choose a joint in the report or add one with + to see its angles"));
    const auto motion = sources.take.isOpen() ? sources.take.shownMotion() : nullptr;
    if (!motion) {
        if (sources.take.isOpen())
            empty.empty = missingWords(sources.take, empty.empty);
        return {empty};
    }
    std::vector<LaneContent> lanes;
    for (const CurveChoice& choice : sources.channels.angles(motion->skeleton)) {
        LaneContent lane;
        lane.title = curveName(choice);
        appendCurves(lane, sources.take, choice);
        lane.empty =
            missingWords(sources.take, laneWords(QT_TRANSLATE_NOOP("Lanes", "Nothing was seen of it")));
        lanes.push_back(std::move(lane));
    }
    if (lanes.empty())
        lanes.push_back(empty);
    return lanes;
}

std::vector<LaneContent> rootLanes(const LaneSources& sources) {
    LaneContent empty;
    empty.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "Root"));
    empty.empty = laneWords(QT_TRANSLATE_NOOP("Lanes", "Nothing was seen of the root"));
    const auto motion = sources.take.isOpen() ? sources.take.shownMotion() : nullptr;
    if (!motion) {
        if (sources.take.isOpen())
            empty.empty = missingWords(sources.take, empty.empty);
        return {empty};
    }
    std::vector<LaneContent> lanes;
    for (const CurveChoice& choice : curveChoices(motion->skeleton)) {
        if (choice.joint != motion->skeleton.joint(0).name || choice.freedom == "pitch" ||
            choice.freedom == "roll")
            continue;
        LaneContent lane;
        lane.title = curveName(choice);
        appendCurves(lane, sources.take, choice);
        lane.empty = missingWords(sources.take, empty.empty);
        if (!lane.unit.on_ticks && !lane.curves.empty())
            lane.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "%1 (m)")).arg(lane.title);
        lanes.push_back(std::move(lane));
    }
    return lanes;
}

}  // namespace noctule::ui
