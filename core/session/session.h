// SPDX-License-Identifier: Apache-2.0
// A session is a folder: session.json, calibration/, takes/, video/, exports/. It can be copied and moved;
// paths inside are relative. session.json holds what the operator said (name, performers, suits, order,
// rating, notes of takes); what a take knows of itself stays in the take. Nothing is ever overwritten: files
// are written aside and renamed, takes get the next free number, deleted takes go to the trash of the
// session.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/body/actor.h"
#include "core/job/job.h"
#include "core/job/result.h"
#include "core/suit/suit.h"

namespace noctule {

/// A person with measures and the suit as it sits on that person.
struct Performer {
    std::string name;
    BodyMeasures measures;
    Suit suit;  ///< boards and sources placed on this body (Vlasic 2007, section 5.2: rigid transforms)
    std::string notes;
};

enum class TakeState { kComplete, kRecovered, kRecording, kDamaged };

struct SessionTake {
    std::string file;  ///< relative to the session's folder: "takes/walk_001.noctule"
    std::string name;  ///< "walk_001"
    std::string performer;
    int rating = 0;  ///< 0..5
    std::string notes;
    double in_s = 0, out_s = 0;  ///< chosen range; out 0: the end
    // Read from the take's file, not stored in session.json:
    TakeState state = TakeState::kComplete;
    double duration_s = 0;
    bool processed = false;
    std::string created_utc;
    std::string problem;  ///< one sentence; empty: fine
};

struct Session {
    std::filesystem::path folder;
    std::string name;
    std::string created_utc;
    std::vector<Performer> performers;
    std::vector<SessionTake> takes;  ///< in order of creation
    std::string current_performer;
    std::string notes;

    const Performer* findPerformer(const std::string& name) const;
    int findTake(const std::string& name) const;  ///< -1 when absent
    std::filesystem::path pathOf(const SessionTake& take) const { return folder / take.file; }
    std::filesystem::path exportsFolder() const { return folder / "exports"; }
};

/// Makes the folder, which must not exist or be empty, with one performer.
Result<Session> createSession(const std::filesystem::path& folder, const std::string& name,
                              const std::string& created_utc);
/// Reads session.json and looks at every take in takes/ (also those that session.json does not know). A
/// damaged session.json is an error that says what is safe; damaged takes are listed with their problem.
Result<Session> openSession(const std::filesystem::path& folder, const JobContext& job);
/// Writes session.json aside and renames it.
Status saveSession(const Session& session);

/// "walk_004": the next free number for a base name, looking at the folder and the session.
std::string nextTakeName(const Session& session, const std::string& base);
/// Copies a take from elsewhere into the session (next free name when taken) and adds it.
Result<SessionTake> importTake(Session& session, const std::filesystem::path& take, const JobContext& job);
/// Looks again at one take's file (after processing, say).
void refreshTake(const Session& session, SessionTake& take);
/// Moves a take's files to trash/ of the session; the way back is restoreTake.
Status trashTake(Session& session, const std::string& name);
Status restoreTake(Session& session, const SessionTake& take);

}  // namespace noctule
