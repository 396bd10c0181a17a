// SPDX-License-Identifier: Apache-2.0
// A session is a folder: session.json, calibration/, takes/, video/, exports/ (README.md). It can be copied
// and moved; paths inside are relative. session.json holds what the operator said (name, performers, suits,
// rating, notes of takes); what a take knows of itself stays in the take. Nothing is ever overwritten: files
// are written aside and renamed, takes get the next free number, deleted takes go to the trash of the
// session.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/body/actor.h"
#include "core/job/job.h"
#include "core/job/result.h"
#include "core/recording/recover_take.h"
#include "core/session/session_body.h"
#include "core/suit/suit.h"

namespace noctule {

/// Members of session.json that this program does not know; written back as they were.
using UnknownMembers = nlohmann::json;

/// A person with measures and the suit as it sits on that person.
struct Performer {
    std::string name;
    BodyMeasures measures;
    Suit suit;  ///< boards and sources placed on this body (Vlasic 2007, section 5.2: rigid transforms)
    std::string notes;
    UnknownMembers unknown = UnknownMembers::object();
};

/// One line of the shot list: what is to be recorded, and how many takes of it are wanted.
struct Shot {
    std::string name;
    int wanted = 1;
    UnknownMembers unknown = UnknownMembers::object();
    bool operator==(const Shot&) const = default;
};

enum class TakeState { kComplete, kRecovered, kRecording, kDamaged };

struct SessionTake {
    std::string file;  ///< relative to the session's folder: "takes/walk_001.noctule"
    std::string name;  ///< "walk_001"
    std::string performer;
    int rating = 0;  ///< 0..5
    std::string notes;
    double in_s = 0, out_s = 0;  ///< chosen range; out 0: the end
    std::string shown_result;    ///< name of the result that Review shows; empty: the last one
    UnknownMembers unknown = UnknownMembers::object();
    // Read from the take's file, not stored in session.json:
    TakeState state = TakeState::kComplete;  ///< kRecording: it was not finished; see recoverTake()
    double duration_s = 0;
    bool processed = false;
    std::string created_utc;
    std::string shot;      ///< of the shot list it was recorded for; empty: none
    std::string problem;   ///< whole sentences; empty: fine
    bool is_torn = false;  ///< damaged, but recoverTake() may find something to read in it

    bool canRecover() const { return state == TakeState::kRecording || is_torn; }
};

struct Session {
    std::filesystem::path folder;
    std::string name;
    std::string created_utc;
    std::vector<Performer> performers;
    std::vector<SessionTake> takes;  ///< in order of creation
    std::vector<Shot> shots;         ///< in the order in which they are recorded
    std::string current_performer;
    std::string calibration;  ///< file in calibration/ that new takes are made with; empty: none
    /// Of suits that are worn beside each other, by the serial number of the box: instead of `calibration`.
    std::map<std::string, std::string> suit_calibrations;
    SessionBody body;
    std::string notes;
    UnknownMembers unknown = UnknownMembers::object();

    const Performer* findPerformer(const std::string& performer) const;
    int findTake(const std::string& take) const;  ///< -1 when absent
    std::filesystem::path pathOf(const SessionTake& take) const { return folder / take.file; }
    std::filesystem::path takesFolder() const { return folder / "takes"; }
    std::filesystem::path calibrationFolder() const { return folder / "calibration"; }
    /// Calibrations that the operator has put aside, each with its report.
    std::filesystem::path asideFolder() const { return calibrationFolder() / "put aside"; }
    /// Short takes that calibrations were made from.
    std::filesystem::path evidenceFolder() const { return calibrationFolder() / "evidence"; }
    std::filesystem::path trashFolder() const { return folder / "trash"; }
    std::filesystem::path exportsFolder() const { return folder / "exports"; }
};

/// Until somebody names the performer.
inline constexpr const char* kFirstPerformer = "Performer 1";

/// Makes the folder, which must not exist or be empty, with one performer.
Result<Session> createSession(const std::filesystem::path& folder, const std::string& name,
                              const std::string& created_utc, const std::string& performer = kFirstPerformer);
/// Reads session.json and looks at every take in takes/ (also those that session.json does not know). A
/// damaged session.json is an error that says what is safe; damaged takes are listed with their problem.
Result<Session> openSession(const std::filesystem::path& folder, const JobContext& job);
/// What session.json says; takes are not looked at.
Result<Session> readSession(const std::filesystem::path& folder);
/// Writes session.json aside and renames it.
Status saveSession(const Session& session);

/// Whether rebuildSession() is the way on: session.json is missing or damaged, and there are takes.
bool canRebuildSession(const std::filesystem::path& folder);
/// A new session.json from what the takes know of themselves (performers with the suits they wore). The old
/// one is kept beside it as session.json.damaged-1.
Result<Session> rebuildSession(const std::filesystem::path& folder, const std::string& created_utc,
                               const JobContext& job);

// takes (session_takes.cpp)

/// "walk_004": the next free number for a base name, looking at the folder, its trash and the session.
std::string nextTakeName(const Session& session, const std::string& base);
/// Copies a take from elsewhere into the session (next free name when taken) and adds it.
Result<SessionTake> importTake(Session& session, const std::filesystem::path& take, const JobContext& job);
/// Looks again at one take's file (after processing, say).
void refreshTake(const Session& session, SessionTake& take);
/// Adds a take that has come into takes/ since the session was opened; its index, or -1 when it is none.
int addTake(Session& session, const std::filesystem::path& take);
/// Another name for a take and its file. kUsage when a take of the session or its trash is called so, or none
/// can be: nothing is overwritten.
Status renameTake(Session& session, const std::string& name, const std::string& wanted);
/// Moves a take's files to trash/ of the session and leaves it out of the list; the way back is restoreTake.
Status trashTake(Session& session, const std::string& name);
Status restoreTake(Session& session, const SessionTake& take);
/// Finishes a recording that broke off, or saves what can be read of a damaged take. The result takes its
/// place; the file itself goes to the trash once the result is safe. Nobody may be writing it.
Result<Recovery> recoverTake(Session& session, const std::string& name, const JobContext& job);

}  // namespace noctule
