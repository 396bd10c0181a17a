// SPDX-License-Identifier: Apache-2.0
#include "ui/views/number_box.h"

#include <cmath>

namespace noctule::ui {
namespace {

const QChar kMinus(0x2212), kHyphen('-');

}  // namespace

QString NumberBox::textFromValue(double value) const {
    // What rounds to nothing has no sign.
    const bool nothing = std::abs(value) < 0.5 * std::pow(10, -decimals());
    return QDoubleSpinBox::textFromValue(nothing ? 0 : value).replace(kHyphen, kMinus);
}

double NumberBox::valueFromText(const QString& text) const {
    return QDoubleSpinBox::valueFromText(QString(text).replace(kMinus, kHyphen));
}

QValidator::State NumberBox::validate(QString& text, int& cursor) const {
    QString plain = QString(text).replace(kMinus, kHyphen);
    const QValidator::State state = QDoubleSpinBox::validate(plain, cursor);
    text = plain.replace(kHyphen, kMinus);
    return state;
}

}  // namespace noctule::ui
