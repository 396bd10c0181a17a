// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/curve_names.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "ui/models/part_names.h"

namespace noctule::ui {
namespace {

struct FreedomWords {
    const char* freedom;
    const char* words;
};

constexpr FreedomWords kFreedoms[] = {
    {"flexion", QT_TRANSLATE_NOOP("CurveNames", "flexion")},
    {"elevation", QT_TRANSLATE_NOOP("CurveNames", "elevation")},
    {"protraction", QT_TRANSLATE_NOOP("CurveNames", "protraction")},
    {"pronation", QT_TRANSLATE_NOOP("CurveNames", "pronation")},
    {"deviation", QT_TRANSLATE_NOOP("CurveNames", "deviation")},
    {"inversion", QT_TRANSLATE_NOOP("CurveNames", "inversion")},
    {"x", QT_TRANSLATE_NOOP("CurveNames", "turn about x")},
    {"y", QT_TRANSLATE_NOOP("CurveNames", "turn about y")},
    {"z", QT_TRANSLATE_NOOP("CurveNames", "turn about z")},
    {"left", QT_TRANSLATE_NOOP("CurveNames", "to the left")},
    {"up", QT_TRANSLATE_NOOP("CurveNames", "height")},
    {"forward", QT_TRANSLATE_NOOP("CurveNames", "forward")},
    {"yaw", QT_TRANSLATE_NOOP("CurveNames", "heading")},
    {"pitch", QT_TRANSLATE_NOOP("CurveNames", "pitch")},
    {"roll", QT_TRANSLATE_NOOP("CurveNames", "roll")},
};

}  // namespace

QString freedomName(const std::string& freedom) {
    for (const FreedomWords& known : kFreedoms)
        if (freedom == known.freedom)
            return QCoreApplication::translate("CurveNames", known.words);
    return QString::fromStdString(freedom);
}

bool isOfRoot(const CurveChoice& choice) {
    constexpr std::array kOfRoot{"left", "up", "forward", "yaw", "pitch", "roll"};
    return std::find(kOfRoot.begin(), kOfRoot.end(), choice.freedom) != kOfRoot.end();
}

QString curveName(const CurveChoice& choice) {
    if (isOfRoot(choice))
        return QCoreApplication::translate("CurveNames", "Root, %1", "Root, height")
            .arg(freedomName(choice.freedom));
    return QCoreApplication::translate("CurveNames", "%1, %2", "Left knee, flexion")
        .arg(jointName(choice.joint), freedomName(choice.freedom));
}

}  // namespace noctule::ui
