// SPDX-License-Identifier: Apache-2.0
// Making, opening, saving and rebuilding a session; its takes are in session_takes.cpp.
#include "core/session/session.h"

#include <algorithm>
#include <system_error>

#include "core/job/atomic_file.h"
#include "core/recording/take.h"
#include "core/session/session_json.h"
#include "core/session/take_folder.h"
#include "core/suit/default_suit.h"

namespace noctule {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "session.json";
constexpr const char* kFolders[] = {"calibration", "takes", "video", "exports"};

Performer performerNamed(const std::string& name) {
    Performer performer;
    performer.name = name;
    performer.suit = defaultSuit();
    return performer;
}

/// What is safe comes with what is wrong.
Error withTakesSafe(Error error, const fs::path& folder) {
    const size_t takes = takeFilesIn(folder / "takes").size();
    if (error.kind != ErrorKind::kUnreadable || takes == 0)
        return error;
    error.message += takes == 1 ? ". Its take is safe" : ". Its " + std::to_string(takes) + " takes are safe";
    error.remedy = "Rebuild the session from its takes; a damaged session.json is kept beside the new one";
    return error;
}

/// Removes what createSession() made, unless it succeeded.
class NewFolders {
public:
    Status make(const fs::path& folder) {
        std::error_code error;
        if (fs::create_directory(folder, error))
            made_.push_back(folder);
        if (error)
            return Error{ErrorKind::kDisk, folder.string() + ": cannot be made: " + error.message(),
                         "Choose a folder that you may write to"};
        return Done{};
    }
    void keep() { made_.clear(); }
    ~NewFolders() {
        std::error_code ignored;
        for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder)
            fs::remove(*folder, ignored);
    }

private:
    std::vector<fs::path> made_;
};

/// The performers named in the takes, each with the suit worn last.
std::vector<Performer> performersOfTakes(const Session& session) {
    std::vector<Performer> performers;
    for (const std::string& file : takeFilesIn(session.takesFolder())) {
        const Result<Take> take = Take::open((session.takesFolder() / file).string());
        if (!take)
            continue;
        const auto named = take->meta().find("performer");
        if (named == take->meta().end() || named->second.empty())
            continue;
        const auto known = std::find_if(performers.begin(), performers.end(),
                                        [&](const Performer& p) { return p.name == named->second; });
        Performer& performer =
            known == performers.end() ? performers.emplace_back(performerNamed(named->second)) : *known;
        if (const auto suit = take->suit())
            performer.suit = *suit;
        if (const auto actor = take->actorInForce(); actor && actor->value.height_m > 0)
            performer.measures.height_m = actor->value.height_m;
    }
    return performers;
}

Status setDamagedFileAside(const fs::path& folder) {
    if (!isThere(folder / kFile))
        return Done{};
    fs::path aside;
    for (int number = 1; aside.empty() || isThere(aside); ++number)
        aside = folder / (std::string(kFile) + ".damaged-" + std::to_string(number));
    return publishFile((folder / kFile).string(), aside.string(), false);
}

}  // namespace

Result<Session> readSession(const fs::path& folder) {
    const std::string path = (folder / kFile).string();
    const Result<std::string> text = readWholeFile(path);
    if (!text)
        return text.error();
    Result<Session> session = sessionFromText(*text, path);
    if (session)
        session->folder = folder;
    return session;
}

Result<Session> createSession(const fs::path& folder, const std::string& name, const std::string& created_utc,
                              const std::string& performer) {
    std::error_code error;
    if (isThere(folder) && !fs::is_empty(folder, error))
        return Error{ErrorKind::kUsage, folder.string() + ": is not empty", "Choose another name or folder"};
    Session session;
    session.folder = folder;
    session.name = name;
    session.created_utc = created_utc;
    session.performers = {performerNamed(performer)};
    session.current_performer = performer;
    NewFolders folders;
    if (!isThere(folder))
        if (const Status made = folders.make(folder); !made)
            return made.error();
    for (const char* part : kFolders)
        if (const Status made = folders.make(folder / part); !made)
            return made.error();
    if (const Status saved = saveSession(session); !saved)
        return saved.error();
    folders.keep();
    return session;
}

Status saveSession(const Session& session) {
    // Names of files may hold bytes that are no text; they must not keep the rest from being saved.
    const std::string text = toJson(session).dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    return writeFileAtomically((session.folder / kFile).string(), text + "\n", true);
}

Result<Session> openSession(const fs::path& folder, const JobContext& job) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored))
        return Error{ErrorKind::kUnreadable, folder.string() + ": there is no such folder",
                     "Choose the folder of a session"};
    const bool anything = isThere(folder / kFile) || !takeFilesIn(folder / "takes").empty();
    if (!anything)
        return Error{ErrorKind::kUnreadable, folder.string() + ": holds no session",
                     "Choose the folder of a session"};
    Result<Session> session = readSession(folder);
    if (!session)
        return withTakesSafe(session.error(), folder);
    for (const std::string& file : takeFilesIn(session->takesFolder()))
        if (session->findTake(fs::path(file).stem().string()) < 0) {
            SessionTake& take = session->takes.emplace_back();
            take.file = "takes/" + file;
            take.name = fs::path(file).stem().string();
        }
    double done = 0;
    for (SessionTake& take : session->takes) {
        if (job.cancelled())
            return JobContext::cancelledError();
        refreshTake(*session, take);
        job.progress(++done / static_cast<double>(session->takes.size()), "Looking at takes");
    }
    sortTakes(*session);
    return session;
}

bool canRebuildSession(const fs::path& folder) {
    const Result<Session> session = readSession(folder);
    return !session && session.error().kind == ErrorKind::kUnreadable &&
           !takeFilesIn(folder / "takes").empty();
}

Result<Session> rebuildSession(const fs::path& folder, const std::string& created_utc,
                               const JobContext& job) {
    if (!canRebuildSession(folder))
        return Error{ErrorKind::kUsage, folder.string() + ": is not a session with takes and a damaged list",
                     "Open it as it is"};
    Session session;
    session.folder = folder;
    session.name = fs::weakly_canonical(folder).filename().string();
    session.created_utc = created_utc;
    session.performers = performersOfTakes(session);
    if (session.performers.empty())
        session.performers = {performerNamed(kFirstPerformer)};
    session.current_performer = session.performers.front().name;
    if (const Status aside = setDamagedFileAside(folder); !aside)
        return aside.error();
    if (const Status saved = saveSession(session); !saved)
        return saved.error();
    return openSession(folder, job);
}

}  // namespace noctule
