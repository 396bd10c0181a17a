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

QTranslator& installed(int index) {
    static auto* translators = new std::array<QTranslator, 2>;  // live as long as the application
    return (*translators)[static_cast<size_t>(index)];
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
    QTranslator &own = installed(0), &qt = installed(1);
    QCoreApplication::removeTranslator(&own);
    QCoreApplication::removeTranslator(&qt);
    QLocale::setDefault(locale.language() == QLocale::German ? locale : QLocale(QLocale::English));
    // Also for English: its plural forms stand in a translation.
    const bool found = own.load(QLocale(), "noctule", "_", ":/noctule/translations");
    if (found)
        QCoreApplication::installTranslator(&own);
    if (found && qt.load(QLocale(), "qtbase", "_", QLibraryInfo::location(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&qt);
}

}  // namespace noctule::ui
