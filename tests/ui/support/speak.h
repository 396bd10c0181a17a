// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/language/language.h"

namespace noctule::ui::test {

/// Makes it the language of the studio, as if chosen in the preferences. Tests end with "en".
inline void speak(const QString& code) {
    QSettings settings;
    chooseLanguage(settings, code);
    applyLanguage(settings);
}

}  // namespace noctule::ui::test
