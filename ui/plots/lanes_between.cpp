// SPDX-License-Identifier: Apache-2.0
// How far the people of a take are from each other: pelvis to pelvis, and the hands that come nearest.
#include <QCoreApplication>
#include <algorithm>

#include "ui/models/part_names.h"
#include "ui/plots/lanes.h"
#include "ui/style/performer_disc.h"

namespace noctule::ui {
namespace {

using Whose = TakeDocument::Whose;
using Tracks = std::shared_ptr<const std::vector<BetweenTrack>>;

std::shared_ptr<const SeriesPyramid> curveOf(const Tracks& tracks, const BetweenTrack& track,
                                             SeriesPyramid MotionCurve::*member) {
    const SeriesPyramid& curve = track.distance.*member;
    return curve.empty() ? nullptr : std::shared_ptr<const SeriesPyramid>(tracks, &curve);
}

const BetweenTrack* findTrack(const Tracks& tracks, const BetweenTrack& like) {
    if (!tracks)
        return nullptr;
    const auto found = std::ranges::find_if(*tracks, [&](const BetweenTrack& track) {
        return track.joint == like.joint && track.other_joint == like.other_joint;
    });
    return found == tracks->end() ? nullptr : &*found;
}

/// Pelvis to pelvis, and the nearest of the other pairs.
std::vector<const BetweenTrack*> chosenTracks(const Tracks& tracks) {
    std::vector<const BetweenTrack*> chosen;
    if (const BetweenTrack* nearest = nearestHands(*tracks))
        chosen.push_back(nearest);
    for (const BetweenTrack& track : *tracks)
        if (track.joint == "Hips")
            chosen.push_back(&track);
    return chosen;
}

LaneContent laneOf(TakeDocument& take, int one, int other, const Tracks& tracks, const BetweenTrack& track) {
    LaneContent lane;
    lane.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "%1 of %2 to %3 of %4 (m)"))
                     .arg(jointName(track.joint), performerLetter(one),
                          jointName(track.other_joint, NameCase::kInside), performerLetter(other));
    lane.unit = {1, QStringLiteral("\u00A0m"), 3, false};
    lane.least_span = 0.02;
    const QString result =
        laneWords(QT_TRANSLATE_NOOP("Lanes", "result %1")).arg(take.numberOf(take.shownRun()));
    LaneCurve shown;
    shown.value = curveOf(tracks, track, &MotionCurve::value);
    shown.low = curveOf(tracks, track, &MotionCurve::low);
    shown.high = curveOf(tracks, track, &MotionCurve::high);
    shown.legend = shown.low ? laneWords(QT_TRANSLATE_NOOP("Lanes", "%1 with 2 sigma")).arg(result) : result;
    shown.column = laneWords(QT_TRANSLATE_NOOP("Lanes", "%1, %2")).arg(lane.title, result);
    shown.hold_s = kPoseHold_s;
    lane.curves.push_back(shown);
    if (!take.overview()->has_reference)
        return lane;
    const Tracks truth = take.betweenTracks(one, other, Whose::kReference);
    if (const BetweenTrack* same = findTrack(truth, track)) {
        LaneCurve reference;
        reference.value = curveOf(truth, *same, &MotionCurve::value);
        reference.legend = laneWords(QT_TRANSLATE_NOOP("Lanes", "reference"));
        reference.column = laneWords(QT_TRANSLATE_NOOP("Lanes", "%1, %2")).arg(lane.title, reference.legend);
        reference.readout = laneWords(QT_TRANSLATE_NOOP("Lanes", "ref %1"));
        reference.pen = LanePen::kReference;
        reference.hold_s = kPoseHold_s;
        lane.curves.push_back(reference);
    }
    return lane;
}

}  // namespace

std::vector<LaneContent> betweenLanes(const LaneSources& sources) {
    TakeDocument& take = sources.take;
    if (!take.isOfSeveral())
        return {};
    std::vector<LaneContent> lanes;
    const int people = static_cast<int>(take.subjects().size());
    for (int i = 0; i < people; ++i) {
        const int one = std::min(i, take.subject()), other = std::max(i, take.subject());
        const Tracks tracks = one == other ? nullptr : take.betweenTracks(one, other);
        if (!tracks)
            continue;
        for (const BetweenTrack* track : chosenTracks(tracks))
            lanes.push_back(laneOf(take, one, other, tracks, *track));
    }
    if (lanes.empty()) {
        LaneContent empty;
        empty.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "Between performers"));
        empty.empty = missingWords(
            take, laneWords(QT_TRANSLATE_NOOP("Lanes", "The shown result holds one performer only")));
        lanes.push_back(empty);
    }
    return lanes;
}

}  // namespace noctule::ui
