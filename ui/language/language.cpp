// SPDX-License-Identifier: Apache-2.0
#include "ui/language/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <array>

// A static library's resources reach the program only when they are named; the macro wants the global
// namespace.
static void nameTranslationResources() {
    Q_INIT_RESOURCE(translations);
}

namespace noctule::ui {
namespace {

constexpr const char* kKey = "language";
/// Qt's own words: its dialogs, menus and keys, and why a link failed. The package depends on
/// qttranslations5-l10n, which has them.
constexpr std::array kOfQt{"qtbase", "qtserialport", "qtwebsockets"};

struct Translators {
    QTranslator own;
    std::array<QTranslator, kOfQt.size()> of_qt;
};

Translators& translators() {
    static auto* installed = new Translators;  // lives as long as the application
    return *installed;
}

void install(QTranslator& translator, const char* name, const QString& folder) {
    QCoreApplication::removeTranslator(&translator);
    if (translator.load(QLocale(), name, "_", folder))
        QCoreApplication::installTranslator(&translator);
}

}  // namespace

void nameTranslations() {
    nameTranslationResources();
}

QStringList languages() {
    return {"en", "de"};
}

QString chosenLanguage(const QSettings& settings) {
    return settings.value(kKey).toString();
}

void chooseLanguage(QSettings& settings, const QString& code) {
    settings.setValue(kKey, code);
}

void applyLanguage(const QSettings& settings) {
    nameTranslations();
    const QString code = chosenLanguage(settings);
    const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
    QLocale::setDefault(locale.language() == QLocale::German ? locale : QLocale(QLocale::English));
    // Also for English: its plural forms stand in a translation.
    install(translators().own, "noctule", ":/noctule/translations");
    for (size_t i = 0; i < kOfQt.size(); ++i)
        install(translators().of_qt[i], kOfQt[i], QLibraryInfo::location(QLibraryInfo::TranslationsPath));
}

}  // namespace noctule::ui
