// SPDX-License-Identifier: Apache-2.0
#include "ui/models/log_file.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <algorithm>

namespace noctule::ui {
namespace {

constexpr int kLongestLine = 2000;

QString inOneLine(QString text) {
    for (QChar& c : text)
        if (!c.isPrint())
            c = ' ';
    return text.left(kLongestLine);
}

}  // namespace

LogFile::LogFile(const QString& folder) : folder_(folder), path_(folder + "/noctule.log"), file_(path_) {
    if (folder.isEmpty() || !QDir().mkpath(folder) || !file_.open(QIODevice::Append))
        return;
    file_.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
}

void LogFile::write(const char* level, const QString& text) {
    const QMutexLocker lock(&mutex_);
    if (!file_.isOpen())
        return;
    if (file_.size() > kLargest_bytes)
        turnOver();
    const QString time = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs);
    file_.write(QStringLiteral("%1 %2 %3\n").arg(time, QLatin1String(level), inOneLine(text)).toUtf8());
    file_.flush();
}

QString LogFile::olderPath(int age) const {
    return QStringLiteral("%1/noctule.%2.log").arg(folder_).arg(age);
}

void LogFile::turnOver() {
    file_.close();
    QFile::remove(olderPath(kKept));
    for (int age = kKept - 1; age >= 1; --age)
        QFile::rename(olderPath(age), olderPath(age + 1));
    QFile::rename(path_, olderPath(1));
    file_.open(QIODevice::Append);
    file_.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
}

QString LogFile::newest(qint64 bytes) const {
    const QMutexLocker lock(&mutex_);
    QByteArray lines;
    for (int age = 0; age <= kKept && lines.size() < bytes; ++age) {
        QFile file(age == 0 ? path_ : olderPath(age));
        if (!file.open(QIODevice::ReadOnly))
            break;
        file.seek(std::max<qint64>(0, file.size() - (bytes - lines.size())));
        lines.prepend(file.readAll());
    }
    if (lines.size() >= bytes)
        lines.remove(0, lines.indexOf('\n') + 1);  // the first line may be cut
    return QString::fromUtf8(lines);
}

QString stateFolder() {
    const QString state = qEnvironmentVariable("XDG_STATE_HOME");
    const bool is_usable = QFileInfo(state).isAbsolute();
    return (is_usable ? state : QDir::homePath() + "/.local/state") + "/noctule";
}

}  // namespace noctule::ui
