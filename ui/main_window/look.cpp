// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/look.h"

#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr const char* kScheme = "look/scheme";
constexpr const char* kScale = "look/scale";
constexpr const char* kReduceMotion = "look/reduce_motion";
const QStringList kSchemes{"dark", "light", "desktop", "contrast"};  // in the order of Scheme

}  // namespace

void applyLook(const QSettings& settings) {
    Theme& theme = Theme::get();
    if (const int scheme = static_cast<int>(kSchemes.indexOf(settings.value(kScheme).toString()));
        scheme >= 0)
        theme.setScheme(static_cast<Scheme>(scheme));
    if (const double scale = settings.value(kScale).toDouble(); scale >= 0.75 && scale <= 1.5)
        theme.setScale(scale);
    if (settings.contains(kReduceMotion))
        theme.setReduceMotion(settings.value(kReduceMotion).toBool());
}

void keepLook(QSettings& settings) {
    const Theme& theme = Theme::get();
    settings.setValue(kScheme, kSchemes.at(static_cast<int>(theme.scheme())));
    settings.setValue(kScale, theme.scale());
    settings.setValue(kReduceMotion, theme.reduceMotion());
}

}  // namespace noctule::ui
