// SPDX-License-Identifier: Apache-2.0
// The studio's log: one line per event with its time in UTC. It lies in the user's state folder and never
// leaves the machine by itself. A full file (1 MB) becomes noctule.1.log; two of those older ones are kept.
#pragma once

#include <QFile>
#include <QMutex>
#include <QString>

namespace noctule::ui {

class LogFile {
public:
    static constexpr qint64 kLargest_bytes = 1'000'000;
    static constexpr int kKept = 2;  ///< full ones beside the one that is written

    /// Makes the folder. Where it cannot be written, or is empty, nothing is kept: a log is never a reason to
    /// fail.
    explicit LogFile(const QString& folder);

    /// `level` is one word, as "warning". Line breaks and control characters of `text` become spaces. May be
    /// called from any thread.
    void write(const char* level, const QString& text);
    /// The newest lines, oldest first, at most so many bytes.
    QString newest(qint64 bytes) const;
    QString path() const { return path_; }

private:
    void turnOver();
    QString olderPath(int age) const;

    mutable QMutex mutex_;
    QString folder_, path_;
    QFile file_;
};

/// $XDG_STATE_HOME/noctule, by default ~/.local/state/noctule.
QString stateFolder();

}  // namespace noctule::ui
