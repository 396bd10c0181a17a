// SPDX-License-Identifier: Apache-2.0
// The language of the studio: the desktop's, or the one chosen in the preferences. What has been made before
// keeps its words, so windows are made anew after a change.
#pragma once

#include <QSettings>
#include <QString>
#include <QStringList>

namespace noctule::ui {

/// Codes of the languages there are: "en", "de".
QStringList languages();
/// As it was chosen; empty: the desktop's.
QString chosenLanguage(const QSettings& settings);
void chooseLanguage(QSettings& settings, const QString& code);
/// Makes :/noctule/translations readable, which a static library does not do by itself.
void nameTranslations();
/// Installs the translation for the chosen language, and its decimal sign.
void applyLanguage(const QSettings& settings);

}  // namespace noctule::ui
