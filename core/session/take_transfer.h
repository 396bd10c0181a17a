// SPDX-License-Identifier: Apache-2.0
// Takes that go from one session to another. The file brings results, markers, notes, calibration and actor
// with it; rating, notes, range and performer of the list go along too. Nothing is overwritten: where the
// name is taken, both are kept. Within a file system a file that moves gets another name and nothing is
// copied; else its copy is complete before the original goes to the trash of its session.
#pragma once

#include "core/session/session.h"

namespace noctule {

struct TakeTransfer {
    std::filesystem::path to;              ///< folder of the session
    std::string to_name;                   ///< of that session
    SessionTake original;                  ///< as the session that it leaves lists it
    SessionTake take;                      ///< as it will be listed there, perhaps under another name
    std::optional<Performer> performer{};  ///< who comes with it, because nobody there is called so
    bool is_copied = false;                ///< its file stands there already
    int64_t changes = 0;                   ///< of the original's file, when it was copied
    std::string uuid{};                    ///< of the take; empty: it cannot be opened

    std::filesystem::path path() const { return to / take.file; }
};

/// What a transfer would be; nothing is changed. kUsage when `to` is the session itself, kUnusable while the
/// take is being recorded or when it is not there.
Result<TakeTransfer> arrangeTransfer(const Session& from, const std::string& name,
                                     const std::filesystem::path& to);
/// Takes over what the list has said of the take since: rating, notes, range and performer.
void followList(const Session& from, TakeTransfer& transfer);
/// Both folders lie in one file system.
bool canBeRenamed(const Session& from, const TakeTransfer& transfer);
/// Copies the file aside, syncs and names it, and lists it there. Cancelled or failed, nothing is left.
/// kUnusable when somebody wrote into the take meanwhile.
Status copyThere(const Session& from, TakeTransfer& transfer, const JobContext& job);

/// Moves it, quickly: what must be copied was copied before. On an error it is listed here as before;
/// kUnusable when the take was changed since it was copied.
Status moveThere(Session& from, const TakeTransfer& transfer);
/// The way back; moveThere() may follow again.
Status moveBack(Session& from, const TakeTransfer& transfer);

}  // namespace noctule
