// SPDX-License-Identifier: Apache-2.0
// Raw sound and inertial channels of boards.
#include <QCoreApplication>
#include <array>

#include "core/math/conventions.h"
#include "ui/models/part_names.h"
#include "ui/plots/lanes.h"

namespace noctule::ui {
namespace {

std::vector<int> boardsOf(const LaneSources& sources, const TakeOverview& overview) {
    std::vector<int> boards = sources.channels.boards();
    std::erase_if(boards, [&](int board) { return board >= static_cast<int>(overview.suit.boards.size()); });
    return boards;
}

void appendPulses(LaneContent& lane, const SoundSource::Sound& sound) {
    LaneMarks sent{
        LaneMarks::Kind::kSent, laneWords(QT_TRANSLATE_NOOP("Lanes", "pulse sent, by source")), {}, {}};
    LaneMarks heard{
        LaneMarks::Kind::kArrival, laneWords(QT_TRANSLATE_NOOP("Lanes", "arrival detected")), {}, {}};
    for (const SoundWindow::PulseMark& pulse : sound.pulses) {
        sent.t_s.push_back(pulse.sent_s);
        sent.text.push_back(QString::number(pulse.source + 1));
        if (pulse.arrival_s)
            heard.t_s.push_back(*pulse.arrival_s);
    }
    lane.marks = {std::move(heard), std::move(sent)};
}

LaneContent soundLane(const LaneSources& sources, const TakeOverview& overview, int board) {
    LaneContent lane;
    const QString place = boardInside(overview.suit, board);
    lane.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "Raw sound of %1")).arg(place);
    lane.unit = {1, {}, 3};
    lane.least_span = 0.01;
    const auto sound = sources.sound.sound(board, sources.window.from(), sources.window.to());
    if (!sound) {
        lane.empty = sources.sound.problem().isEmpty()
                         ? laneWords(QT_TRANSLATE_NOOP("Lanes", "Reading the sound"))
                         : sources.sound.problem();
        return lane;
    }
    LaneCurve curve;
    curve.value = sound->curve;
    curve.legend = sound->samples
                       ? laneWords(QT_TRANSLATE_NOOP("Lanes", "samples, full scale 1"))
                       : laneWords(QT_TRANSLATE_NOOP("Lanes", "loudest and quietest, full scale 1"));
    curve.column = laneWords(QT_TRANSLATE_NOOP("Lanes", "sound of %1 (full scale 1)")).arg(place);
    if (!sound->samples)
        curve.readout.clear();
    lane.curves.push_back(std::move(curve));
    appendPulses(lane, *sound);
    return lane;
}

LaneContent readingLane(const LaneSources& sources, const ReadingTable& table, int board, int first_axis,
                        const QString& title, const QString& column, const LaneUnit& unit) {
    LaneContent lane;
    lane.title = title;
    lane.unit = unit;
    constexpr std::array kPens{LanePen::kX, LanePen::kY, LanePen::kZ};
    constexpr std::array kLetters{"X", "Y", "Z"};
    for (int axis = 0; axis < 3; ++axis) {
        const auto index = static_cast<size_t>(axis);
        LaneCurve curve;
        curve.value = sources.take.readingCurve(board, first_axis + axis);
        curve.legend = QLatin1String(kLetters[index]);
        curve.column = column.arg(curve.legend);
        curve.pen = kPens[index];
        curve.readout = curve.legend + QStringLiteral(" %1");
        if (curve.value)
            lane.curves.push_back(std::move(curve));
    }
    if (lane.curves.empty())
        lane.empty =
            missingWords(sources.take, laneWords(QT_TRANSLATE_NOOP("Lanes", "This board sent nothing")));
    const BoardTrack& track = table.boards[static_cast<size_t>(board)];
    lane.marks = {
        {LaneMarks::Kind::kLost, laneWords(QT_TRANSLATE_NOOP("Lanes", "lost")), track.lost_s, {}},
        {LaneMarks::Kind::kClipped, laneWords(QT_TRANSLATE_NOOP("Lanes", "clipped")), track.clipped_s, {}}};
    return lane;
}

}  // namespace

std::vector<LaneContent> soundLanes(const LaneSources& sources) {
    LaneContent empty;
    empty.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "Raw sound"));
    empty.empty =
        laneWords(QT_TRANSLATE_NOOP("Lanes", "Choose a pair in the heat map to see the sound of its board"));
    const auto overview = sources.take.overview();
    if (!overview)
        return {empty};
    if (overview->level == TakeLevel::kReadings) {
        empty.empty = laneWords(QT_TRANSLATE_NOOP(
            "Lanes", "This take holds ranges and readings, but not the sound they were taken from"));
        return {empty};
    }
    std::vector<LaneContent> lanes;
    for (const int board : boardsOf(sources, *overview))
        lanes.push_back(soundLane(sources, *overview, board));
    if (lanes.empty())
        lanes.push_back(empty);
    return lanes;
}

std::vector<LaneContent> inertialLanes(const LaneSources& sources) {
    LaneContent empty;
    empty.title = laneWords(QT_TRANSLATE_NOOP("Lanes", "Inertial"));
    empty.empty =
        laneWords(QT_TRANSLATE_NOOP("Lanes", "Choose a pair in the heat map to see how its board moved"));
    const auto overview = sources.take.overview();
    const std::vector<int> boards = overview ? boardsOf(sources, *overview) : std::vector<int>();
    if (boards.empty())
        return {empty};  // a long take has a million readings: they are read when somebody wants to see them
    const auto table = sources.take.readings();
    if (!table) {
        empty.empty = missingWords(sources.take, empty.empty);
        return {empty};
    }
    std::vector<LaneContent> lanes;
    for (const int board : boards) {
        if (board >= static_cast<int>(table->boards.size()))
            continue;
        const QString place = boardInside(overview->suit, board);
        lanes.push_back(
            readingLane(sources, *table, board, 0,
                        laneWords(QT_TRANSLATE_NOOP("Lanes", "Turning rate (°/s) of %1")).arg(place),
                        laneWords(QT_TRANSLATE_NOOP("Lanes", "gyroscope %2 (rad/s) of %1"))
                            .arg(place, QStringLiteral("%1")),
                        {degrees(1), QStringLiteral("°/s"), 0}));
        lanes.push_back(
            readingLane(sources, *table, board, 3,
                        laneWords(QT_TRANSLATE_NOOP("Lanes", "Acceleration (m/s²) of %1")).arg(place),
                        laneWords(QT_TRANSLATE_NOOP("Lanes", "accelerometer %2 (m/s2) of %1"))
                            .arg(place, QStringLiteral("%1")),
                        {1, QStringLiteral("\u00A0m/s²"), 1}));
    }
    if (lanes.empty())
        lanes.push_back(empty);
    return lanes;
}

}  // namespace noctule::ui
