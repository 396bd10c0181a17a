// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/field_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "ui/models/part_names.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

struct FieldText {
    Q_DECLARE_TR_FUNCTIONS(FieldText)
};

constexpr double kUpsideDown_deg = 120, kSideways_deg = 45;

/// Between the field as the sensor that has seen least sees it now, and the side that is empty.
std::optional<double> angleToEmpty_deg(const FieldGuide& guide) {
    const int least = guide.leastBoard();
    const auto empty = guide.sphere().emptySide();
    if (least < 0 || !empty)
        return std::nullopt;
    const Vector3d now = guide.turnOf(least).direction();
    if (!(now.norm() > 0))
        return std::nullopt;
    return degrees(std::acos(std::clamp(now.normalized().dot(directionOf(*empty)), -1.0, 1.0)));
}

LiveSentence missingDirections(const FieldGuide& guide) {
    const auto empty = guide.sphere().emptySide();
    const QString how = FieldText::tr(
        "Tip it over and roll it slowly. Keep it 1 m away from tables, radiators and telephones.");
    if (!empty)
        return {Tone::kAccent, FieldText::tr("All directions were seen: wait a moment"), how};
    const QString side = sideName(*empty);
    const QString first = side.left(1).toUpper() + side.mid(1);
    return {Tone::kAccent,
            guide.leastShare() > 0.6 ? FieldText::tr("%1 is missing, then it is done").arg(first)
                                     : FieldText::tr("Most is missing on this side: %1").arg(side),
            how};
}

/// While a step is right: it goes on by itself.
LiveSentence rightField(const FieldGuide& guide) {
    const Guidance& now = guide.guidance();
    if (now.step == FieldGuide::kSpot)
        return {Tone::kOk, FieldText::tr("The field is even here"),
                FieldText::tr("Go on carrying it about for a moment.")};
    if (now.step == FieldGuide::kTurn)
        return {Tone::kOk, FieldText::tr("Every sensor has enough"),
                FieldText::tr("The calibration begins by itself.")};
    if (!guide.spot().isBentAtFloor())
        return {Tone::kOk, FieldText::tr("The field is even down to the floor"),
                FieldText::tr("Hold it for a moment more.")};
    return {Tone::kWarn,
            FieldText::tr("Near the floor the field is %1").arg(strongerText(*guide.spot().floor_percent)),
            FieldText::tr("The floor holds steel. Turn the suit up here, at the height of your chest.")};
}

}  // namespace

QString sideName(FieldSide side) {
    switch (side) {
        case FieldSide::kRight:
            return FieldText::tr("the right side");
        case FieldSide::kLeft:
            return FieldText::tr("the left side");
        case FieldSide::kUpper:
            return FieldText::tr("the upper side");
        case FieldSide::kLower:
            return FieldText::tr("the lower side");
        case FieldSide::kFront:
            return FieldText::tr("the front");
        case FieldSide::kBack:
            break;
    }
    return FieldText::tr("the back");
}

QString microteslaText(double value_ut, std::optional<double> sigma_ut) {
    const QString value = numberText(value_ut, 1);
    return sigma_ut ? FieldText::tr("%1 µT ±%2").arg(value, numberText(*sigma_ut, 1))
                    : FieldText::tr("%1 µT").arg(value);
}

QString sensorName(const WizardRun& run, int board) {
    return FieldText::tr("%1 (sensor %2)")
        .arg(boardName(run.suit().boards[static_cast<size_t>(board)]))
        .arg(board + 1);
}

QString strongerText(double percent) {
    const QString share = percentText(std::abs(percent) / 100);
    return percent < 0 ? FieldText::tr("%1 weaker").arg(share) : FieldText::tr("%1 stronger").arg(share);
}

QString fieldFound(const FieldGuide& guide, int step) {
    if (!guide.isDone(step))
        return {};
    const SpotField& spot = guide.spot();
    if (step == FieldGuide::kSpot)
        return FieldText::tr("%1, even within %2")
            .arg(microteslaText(spot.strength_ut), percentText(spot.uneven_percent / 100, 1));
    if (step == FieldGuide::kFloor)
        return spot.floor_percent ? strongerText(*spot.floor_percent) : FieldText::tr("not looked at");
    return FieldText::tr("%1 of the directions").arg(percentText(guide.leastShare()));
}

QString fieldInstruction(const WizardRun& run) {
    const FieldGuide* guide = run.fieldGuide();
    if (!guide)
        return {};
    if (!guide->isDone(FieldGuide::kTurn) && run.step() != FieldGuide::kTurn)
        return run.stepWords(run.step()).instruction;
    if (guide->turning_deg_per_s() > FieldGuide::kFastest_deg_per_s)
        return FieldText::tr("Turn it more slowly");
    const auto angle_deg = angleToEmpty_deg(*guide);
    if (!angle_deg)
        return FieldText::tr("Roll it slowly");
    return *angle_deg > kUpsideDown_deg ? FieldText::tr("Turn it upside down")
           : *angle_deg > kSideways_deg ? FieldText::tr("Tip it onto another side")
                                        : FieldText::tr("Roll it slowly");
}

LiveSentence fieldSentence(const WizardRun& run) {
    const FieldGuide* guide = run.fieldGuide();
    if (run.isWaitingForSuit() || !guide)
        return sentenceOf(run);
    const Guidance& now = guide->guidance();
    switch (now.hindrance) {
        case Hindrance::kNoReadings:
            return {Tone::kError, FieldText::tr("No sensor is heard"),
                    FieldText::tr("Step Connect shows which one is missing and why.")};
        case Hindrance::kNoField:
            return {Tone::kError, FieldText::tr("No magnetometer is heard"),
                    FieldText::tr("The sensors are heard, but send no field. Step Connect shows what they "
                                  "are.")};
        case Hindrance::kAbsent:
            return {Tone::kError, FieldText::tr("%1 is not heard").arg(sensorName(run, now.board)),
                    FieldText::tr("Push its plug in until it clicks, or skip it. %n sensor(s) are missing.",
                                  nullptr, now.hindering)};
        case Hindrance::kTilted:
            return {Tone::kNeutral, FieldText::tr("It is tilted by %1").arg(degreesText(now.value, 0)),
                    FieldText::tr("Hold it as it was when this step began; it is turned later.")};
        case Hindrance::kBentField:
            return {
                Tone::kWarn,
                FieldText::tr("The field of this spot is bent by %1").arg(percentText(now.value / 100)),
                FieldText::tr("Steel is near: a table, a radiator, the floor. Go 1 m away from it and carry "
                              "the suit about again.")};
        case Hindrance::kCarry:
            return {Tone::kNeutral, FieldText::tr("Lift it and carry it about a little"),
                    FieldText::tr("Half a metre to each side and up and down, without turning it.")};
        case Hindrance::kLower:
            return {Tone::kNeutral, FieldText::tr("Hold it a hand’s width above the floor"),
                    FieldText::tr("Without turning it, until the ring is full. Then lift it again.")};
        case Hindrance::kTurnOn:
            return missingDirections(*guide);
        case Hindrance::kDone:
            return {Tone::kOk, FieldText::tr("Every sensor has been turned"),
                    FieldText::tr("Start one anew, begin anew, or use those that are done.")};
        case Hindrance::kNone:
            return rightField(*guide);
        default:
            return sentenceOf(run);
    }
}

/// Directions are counted from when it is turned.
std::vector<LiveMeasure> fieldMeasures(const FieldGuide& guide) {
    const double uneven = guide.spot().uneven_percent, fastest = FieldGuide::kFastest_deg_per_s;
    const double turning = guide.turning_deg_per_s(), share = guide.leastShare();
    const Guidance& now = guide.guidance();
    std::vector<LiveMeasure> measures = {
        {FieldText::tr("Field even"),
         FieldText::tr("%1, limit %2")
             .arg(percentText(uneven / 100, 1), numberText(SpotField::kMostUneven_percent, 0)),
         std::min(1.0, uneven / SpotField::kMostUneven_percent), guide.spot().isEven()},
        {FieldText::tr("Turning slowly"),
         FieldText::tr("%1°/s, limit %2").arg(numberText(turning, 0), numberText(fastest, 0)),
         std::min(1.0, turning / fastest), turning <= fastest}};
    if (guide.isDone(FieldGuide::kFloor))
        measures.push_back({FieldText::tr("Directions"),
                            FieldText::tr("%1, good: over 90").arg(percentText(share)), share,
                            share >= FieldTurnLimits::kEnoughShare});
    else
        measures.push_back({FieldText::tr("Sensors heard"),
                            FieldText::tr("%1 of %2").arg(now.right_boards).arg(now.asked_boards),
                            static_cast<double>(now.right_boards) / std::max(1, now.asked_boards),
                            now.asked_boards > 0 && now.right_boards == now.asked_boards});
    return measures;
}

}  // namespace noctule::ui
