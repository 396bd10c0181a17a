// SPDX-License-Identifier: Apache-2.0
#include "ui/views/length_box.h"

#include <cmath>

#include "ui/style/lengths.h"

namespace noctule::ui {
namespace {

constexpr int kEveryBit = 17;  ///< decimals with which no value of a length is rounded
constexpr double kStepsPerMetre = 1e6;

}  // namespace

LengthBox::LengthBox(double least_m, double most_m, Metric metric, QWidget* parent)
    : QDoubleSpinBox(parent), metric_(metric) {
    setKeyboardTracking(false);  // "50" would be taken of "50 kg"
    setDecimals(kEveryBit);
    setRange(least_m, most_m);
    setSingleStep(chosenUnits() == Units::kImperial ? kMetresPerInch : 0.01);
}

QString LengthBox::textFromValue(double value_m) const {
    return metric_ == Metric::kCentimetres ? shortLengthText(value_m) : lengthText(value_m);
}

std::optional<double> LengthBox::read(const QString& text) const {
    if (!specialValueText().isEmpty() && text == specialValueText())
        return minimum();
    if (text == textFromValue(value()))
        return value();
    return lengthFrom(text, chosenUnits() == Units::kImperial ? kMetresPerInch
                            : metric_ == Metric::kCentimetres ? 0.01
                                                              : 1);
}

double LengthBox::valueFromText(const QString& text) const {
    return read(text).value_or(value());
}

void LengthBox::stepBy(int steps) {
    interpretText();
    setValue(std::round((value() + steps * singleStep()) * kStepsPerMetre) / kStepsPerMetre);
    selectAll();
}

/// Whatever is no length, or not yet, may be typed on; the box goes back to its value when it is left.
QValidator::State LengthBox::validate(QString& text, int&) const {
    const auto length_m = read(text);
    return length_m && *length_m >= minimum() && *length_m <= maximum() ? QValidator::Acceptable
                                                                        : QValidator::Intermediate;
}

}  // namespace noctule::ui
