// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/diagnosis.h"

#include <QDateTime>
#include <QDir>
#include <QGuiApplication>
#include <QLocale>
#include <QScreen>
#include <QSysInfo>
#include <QThread>

#include "ui/main_window/licences.h"
#include "ui/models/personal_data.h"
#include "ui/views/session/recent_sessions.h"

namespace noctule::ui {
namespace {

constexpr qint64 kLog_bytes = 200'000;

QString section(const QString& title, const QStringList& lines) {
    return "== " + title + '\n' + (lines.isEmpty() ? "(nothing)" : lines.join('\n')) + "\n\n";
}

QStringList versions(const Studio& studio) {
    QStringList lines{QString::fromStdString(studio.parts().software),
                      QSysInfo::prettyProductName() + ", " + QSysInfo::kernelVersion() + ", " +
                          QSysInfo::currentCpuArchitecture(),
                      QStringLiteral("%1 processors").arg(QThread::idealThreadCount()),
                      "language " + QLocale().name()};
    for (const LinkedWork& work : linkedWorks())
        lines += QStringLiteral("%1 %2").arg(work.name, work.version).trimmed();
    for (const QScreen* screen : QGuiApplication::screens())
        lines += QStringLiteral("screen %1 x %2 at %3")
                     .arg(screen->geometry().width())
                     .arg(screen->geometry().height())
                     .arg(screen->devicePixelRatio());
    return lines;
}

/// Layouts are bytes of Qt's, and lists of recent things are the user's own business.
QStringList settingsOf(const QSettings& settings) {
    QStringList lines;
    for (const QString& key : settings.allKeys()) {
        const QVariant value = settings.value(key);
        const bool is_text = value.type() != QVariant::ByteArray && value.canConvert<QString>();
        const bool is_own = key.contains("recent", Qt::CaseInsensitive) || key.startsWith("layout/") ||
                            key.startsWith("sound/device");  // headphones have their owner's name
        if (is_text && !is_own)
            lines += key + " = " + (QDir::isAbsolutePath(value.toString()) ? "[path]" : value.toString());
    }
    return lines;
}

QStringList healthOf(Studio& studio) {
    const auto hello = studio.suit().status()->hello;
    if (!hello)
        return {"no suit is connected"};
    const Readiness& readiness = studio.check().readiness();
    QStringList lines{QStringLiteral("box %1, %2 boards, %3 Hz")
                          .arg(QString::fromStdString(hello->serial))
                          .arg(hello->boardCount())
                          .arg(hello->sample_rate_hz),
                      QStringLiteral("%1 boards are there, %2 sources are heard, %3 pairs are good")
                          .arg(readiness.boards_there)
                          .arg(readiness.sources_heard)
                          .arg(readiness.good_pairs)};
    for (const ReadinessProblem& problem : readiness.problems)
        lines += QStringLiteral("problem %1: board %2, source %3, value %4")
                     .arg(static_cast<int>(problem.kind))
                     .arg(problem.board)
                     .arg(problem.source)
                     .arg(problem.value);
    return lines;
}

/// Of the open session and of all that the studio remembers: the log may tell of any of them.
QStringList knownNames(Studio& studio) {
    QStringList names;
    if (studio.session().isOpen())
        names = namesOf(studio.session().session());
    for (const QString& folder : RecentSessions::foldersIn(studio.settings()))
        names += namesInFolder(folder);
    return names;
}

}  // namespace

QString diagnosisText(Studio& studio, const LogFile& log) {
    const QString time = QDateTime::currentDateTimeUtc().toString(Qt::ISODate);
    const QString personal =
        section("settings", settingsOf(studio.settings())) +
        section("log, newest last", log.newest(kLog_bytes).split('\n', Qt::SkipEmptyParts));
    return section("Noctule's diagnosis, " + time, versions(studio)) + section("suit", healthOf(studio)) +
           withoutPersonalData(personal, knownNames(studio));
}

}  // namespace noctule::ui
