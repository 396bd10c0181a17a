// SPDX-License-Identifier: Apache-2.0
// The file session.lock in an open session: it names the process that has it open. One that outlives its
// process tells the next start that the studio ended unexpectedly; one of a living process that the session
// is in use.
#pragma once

#include <QLockFile>
#include <QString>
#include <memory>

namespace noctule::ui {

class SessionMarker {
public:
    enum class Finding {
        kFree,        ///< opened and closed properly before
        kLeftBehind,  ///< the studio ended unexpectedly while it was open
        kInUse,       ///< another window or computer has it open
        kNoMarker,    ///< the folder cannot be written
    };

    /// Puts the marker into the folder; an earlier one of this object is taken away.
    Finding mark(const QString& session_folder);
    void release() { lock_.reset(); }
    bool isMarked() const { return lock_ != nullptr; }

    /// Whether a marker lies in the folder whose process is gone.
    static bool wasLeftBehind(const QString& session_folder);
    /// Whether another process has it open, here or on another computer.
    static bool isOpenElsewhere(const QString& session_folder);

private:
    std::unique_ptr<QLockFile> lock_;
};

}  // namespace noctule::ui
