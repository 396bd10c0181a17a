// SPDX-License-Identifier: Apache-2.0
#include "ui/style/lengths.h"

#include <QRegularExpression>
#include <QSettings>
#include <cmath>
#include <map>

#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr const char* kUnits = "units";
constexpr const char* kImperial = "imperial";
constexpr double kPerMetre = 1e6;  ///< typed lengths end in whole micrometres: 57 cm are 0.57
constexpr int kTenthsPerFoot = 120, kTenthsPerYard = 3 * kTenthsPerFoot;
const QChar kNoBreak(0x00A0), kPrime(0x2032), kDoublePrime(0x2033), kMinusSign(0x2212);

/// Of the settings, which are too slow to read for every length.
Units& unitsInForce() {
    static Units units =
        QSettings().value(kUnits).toString() == kImperial ? Units::kImperial : Units::kMetric;
    return units;
}

QString inches(qint64 tenths) {
    return numberText(static_cast<double>(tenths) / 10, tenths % 10 == 0 ? 0 : 1) + kDoublePrime;
}

QString feetAndInches(double metres) {
    if (!std::isfinite(metres))
        return kNoValue;
    const qint64 tenths = std::llround(std::abs(metres) / kMetresPerInch * 10);
    const QString text =
        tenths < kTenthsPerYard
            ? inches(tenths)
            : numberText(static_cast<double>(tenths / kTenthsPerFoot), 0) + kPrime +
                  (tenths % kTenthsPerFoot == 0 ? QString() : inches(tenths % kTenthsPerFoot));
    return metres < 0 && tenths > 0 ? kMinusSign + text : text;
}

QString inUnit(double value, int decimals, const char* unit) {
    return std::isfinite(value) ? numberText(value, decimals) + kNoBreak + unit : kNoValue;
}

/// As people type it, with one sign each for feet and inches.
QString plain(const QString& text) {
    static const QRegularExpression kSpaces(QStringLiteral("\\s"),
                                            QRegularExpression::UseUnicodePropertiesOption);
    static const QRegularExpression kFeet(QStringLiteral("[′’]|(ft|foot|feet|fuß|fuss)\\.?"));
    static const QRegularExpression kInches(QStringLiteral("[″”]|''|(inches|inch|in|zoll)\\.?"));
    return text.toLower()
        .remove(kSpaces)
        .replace(kFeet, QStringLiteral("'"))
        .replace(kInches, QStringLiteral("\""))
        .replace(',', '.');
}

}  // namespace

Units chosenUnits() {
    return unitsInForce();
}

void chooseUnits(Units units) {
    unitsInForce() = units;
    QSettings().setValue(kUnits, units == Units::kImperial ? kImperial : "metric");
}

QString lengthText(double metres, int decimals, Units units) {
    return units == Units::kImperial ? feetAndInches(metres) : inUnit(metres, decimals, "m");
}

QString shortLengthText(double metres) {
    return chosenUnits() == Units::kImperial ? feetAndInches(metres) : inUnit(100 * metres, 1, "cm");
}

std::optional<double> lengthFrom(const QString& text, double bare_m) {
    static const QRegularExpression kFeetAndInches(QStringLiteral(R"re(^(\d+\.?\d*)'(?:(\d+\.?\d*)"?)?$)re"));
    static const QRegularExpression kNumber(QStringLiteral(R"re(^(\d+\.?\d*|\.\d+)(mm|cm|m|"|)$)re"));
    const std::map<QString, double> units{
        {"", bare_m}, {"mm", 0.001}, {"cm", 0.01}, {"m", 1}, {"\"", kMetresPerInch}};
    const QString typed = plain(text);
    double length_m = 0;
    if (const auto feet = kFeetAndInches.match(typed); feet.hasMatch())
        length_m = (12 * feet.captured(1).toDouble() + feet.captured(2).toDouble()) * kMetresPerInch;
    else if (const auto number = kNumber.match(typed); number.hasMatch())
        length_m = number.captured(1).toDouble() * units.at(number.captured(2));
    else
        return std::nullopt;
    return std::round(length_m * kPerMetre) / kPerMetre;
}

}  // namespace noctule::ui
