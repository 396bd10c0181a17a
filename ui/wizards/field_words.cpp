// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/field_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

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

QString fieldInstruction(const WizardRun& run) {
    const FieldGuide* guide = run.fieldGuide();
    if (!guide || !guide->isDone(FieldGuide::kSpot))
        return FieldText::tr("Carry it about slowly");
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
        case Hindrance::kBentField:
            return {
                Tone::kWarn,
                FieldText::tr("The field of this spot is bent by %1").arg(percentText(now.value / 100)),
                FieldText::tr("Steel is near: a table, a radiator, the floor. Go 1 m away from it and carry "
                              "the suit about again.")};
        case Hindrance::kCarry:
            return {Tone::kNeutral, FieldText::tr("Lift it and carry it about a little"),
                    FieldText::tr("Half a metre to each side and up and down, without turning it.")};
        case Hindrance::kTurnOn:
            return missingDirections(*guide);
        case Hindrance::kNone:
            return {Tone::kOk,
                    now.step == FieldGuide::kSpot ? FieldText::tr("The field is even here")
                                                  : FieldText::tr("Every sensor has enough"),
                    now.step == FieldGuide::kSpot ? FieldText::tr("Go on carrying it about for a moment.")
                                                  : FieldText::tr("The calibration begins by itself.")};
        default:
            return {Tone::kError, FieldText::tr("No magnetometer is heard"),
                    FieldText::tr("Step Connect shows which sensor is missing and why.")};
    }
}

std::vector<LiveMeasure> fieldMeasures(const FieldGuide& guide) {
    const double uneven = guide.spot().uneven_percent, fastest = FieldGuide::kFastest_deg_per_s;
    const double turning = guide.turning_deg_per_s(), share = guide.leastShare();
    return {{FieldText::tr("Field even"),
             FieldText::tr("%1, limit %2")
                 .arg(percentText(uneven / 100, 1), numberText(SpotField::kMostUneven_percent, 0)),
             std::min(1.0, uneven / SpotField::kMostUneven_percent), guide.spot().isEven()},
            {FieldText::tr("Turning slowly"),
             FieldText::tr("%1°/s, limit %2").arg(numberText(turning, 0), numberText(fastest, 0)),
             std::min(1.0, turning / fastest), turning <= fastest},
            {FieldText::tr("Directions"), FieldText::tr("%1, good: over 90").arg(percentText(share)), share,
             share >= FieldTurnLimits::kEnoughShare}};
}

}  // namespace noctule::ui
