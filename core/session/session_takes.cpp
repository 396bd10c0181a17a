// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>

#include "core/recording/take.h"
#include "core/recording/take_copy.h"
#include "core/session/session.h"
#include "core/session/shot_list.h"
#include "core/session/take_folder.h"

namespace noctule {
namespace {

namespace fs = std::filesystem;

/// Messages name takes as the session does: "takes/walk_001.noctule".
std::string withoutFolder(std::string text, const fs::path& folder) {
    const std::string prefix = (folder / "").string();
    for (size_t at = 0; (at = text.find(prefix, at)) != std::string::npos;)
        text.erase(at, prefix.size());
    return text;
}

void readFrom(const Take& file, SessionTake& take) {
    const auto& meta = file.meta();
    const auto text = [&](const char* key) {
        const auto found = meta.find(key);
        return found == meta.end() ? std::string() : found->second;
    };
    take.created_utc = file.header().created_utc;
    if (take.performer.empty())
        take.performer = text("performer");
    take.shot = text(kShotKey);
    if (const auto duration_s = file.duration_s(); duration_s.ok())
        take.duration_s = *duration_s;
    const auto runs = file.derivedRuns();
    const auto is_result = [](const DerivedRun& run) { return run.kind == "pose"; };
    take.processed = runs.ok() && std::ranges::any_of(*runs, is_result);
    const auto is_shown = [&](const DerivedRun& run) {
        return is_result(run) && run.name == take.shown_result;
    };
    if (runs && std::ranges::none_of(*runs, is_shown))
        take.shown_result.clear();  // it was deleted
    const std::string state = text("state");
    if (state == "recording") {
        take.state = TakeState::kRecording;
        take.problem = take.name + ": the recording was not finished. What was written is safe; recover it.";
    } else if (state == "recovered") {
        take.state = TakeState::kRecovered;
    }
}

Error noSuchTake(const std::string& name) {
    return {ErrorKind::kUsage, name + ": is not a take of this session", "Choose another one"};
}

SessionTake takeNamed(const std::string& name) {
    SessionTake take;
    take.name = name;
    take.file = "takes/" + name + kTakeExtension;
    return take;
}

}  // namespace

const Performer* Session::findPerformer(const std::string& performer) const {
    const auto found = std::find_if(performers.begin(), performers.end(),
                                    [&](const Performer& p) { return p.name == performer; });
    return found == performers.end() ? nullptr : &*found;
}

int Session::findTake(const std::string& take) const {
    const auto found =
        std::find_if(takes.begin(), takes.end(), [&](const SessionTake& t) { return t.name == take; });
    return found == takes.end() ? -1 : static_cast<int>(found - takes.begin());
}

void sortTakes(Session& session) {
    const auto key = [](const SessionTake& take) {
        return std::tuple(take.created_utc.empty(), take.created_utc, take.name);
    };
    std::stable_sort(session.takes.begin(), session.takes.end(),
                     [&](const SessionTake& a, const SessionTake& b) { return key(a) < key(b); });
}

std::string nextTakeName(const Session& session, const std::string& base) {
    return numberedTakeName(base, [&](const std::string& name) { return isNameFree(session, name); });
}

void refreshTake(const Session& session, SessionTake& take) {
    take.state = TakeState::kComplete;
    take.duration_s = 0;
    take.processed = false;
    take.shot.clear();
    take.problem.clear();
    take.is_torn = false;
    const fs::path path = session.pathOf(take);
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        take.state = TakeState::kDamaged;
        take.problem = take.file + " is not there any more. Put it back, or remove the take from the list.";
        return;
    }
    const Result<Take> file = Take::open(path.string());
    if (file) {
        readFrom(*file, take);
    } else {
        take.state = TakeState::kDamaged;
        take.problem = withoutFolder(file.error().text(), session.folder) + ".";
        take.is_torn = file.error().is_damage;
    }
}

int addTake(Session& session, const fs::path& path) {
    std::error_code ignored;
    const std::string name = path.stem().string();
    const bool inside = fs::equivalent(path.parent_path(), session.takesFolder(), ignored);
    if (!inside || path.extension() != kTakeExtension || !fs::is_regular_file(path, ignored))
        return -1;
    if (const int known = session.findTake(name); known >= 0) {
        refreshTake(session, session.takes[static_cast<size_t>(known)]);
        return known;
    }
    SessionTake take = takeNamed(name);
    refreshTake(session, take);
    session.takes.push_back(std::move(take));
    sortTakes(session);
    return session.findTake(name);
}

Result<SessionTake> importTake(Session& session, const fs::path& original, const JobContext& job) {
    std::error_code ignored;
    // A take with a log beside it may be readable only where its copy will stand.
    if (!fs::exists(original.string() + "-wal", ignored))
        if (const Result<Take> opened = Take::open(original.string()); !opened)
            return opened.error();
    const std::string wanted = original.stem().string();
    const bool usable = cleanTakeName(wanted) == wanted;
    const std::string name = usable && isNameFree(session, wanted) ? wanted : nextTakeName(session, wanted);
    Result<TakeCopy> copy = TakeCopy::make(original.string(), takePath(session, name).string(), job);
    if (!copy)
        return copy.error();
    if (const Status folded = copy->foldLog(); !folded)
        return folded.error();
    if (const Result<Take> opened = Take::open(copy->path()); !opened)
        return copy->named(opened.error());
    if (const Status published = copy->publish(false); !published)
        return published.error();
    const int index = addTake(session, takePath(session, name));
    require(index >= 0, "a copied take stands in takes/");
    return session.takes[static_cast<size_t>(index)];
}

Status renameTake(Session& session, const std::string& name, const std::string& wanted) {
    const int index = session.findTake(name);
    if (index < 0)
        return noSuchTake(name);
    if (cleanTakeName(wanted) != wanted || wanted.find_first_not_of("_-") == std::string::npos)
        return Error{ErrorKind::kUsage, name + ": a take cannot be called \"" + wanted + "\"",
                     "Use letters, digits, hyphens and underscores"};
    if (wanted == name)
        return Done{};
    if (!isNameFree(session, wanted))
        return Error{ErrorKind::kUsage,
                     wanted + ": there is a take of that name already, or one in the trash",
                     "Choose another name"};
    SessionTake& take = session.takes[static_cast<size_t>(index)];
    if (const Status moved = moveTakeFiles(session.pathOf(take), takePath(session, wanted)); !moved)
        return moved;
    take.name = wanted;
    take.file = takeNamed(wanted).file;
    sortTakes(session);
    return Done{};
}

Status trashTake(Session& session, const std::string& name) {
    const int index = session.findTake(name);
    if (index < 0)
        return noSuchTake(name);
    const SessionTake& take = session.takes[static_cast<size_t>(index)];
    std::error_code ignored;
    if (fs::exists(session.pathOf(take), ignored))
        if (const Status moved = moveToTrash(session, take.file); !moved)
            return moved;
    session.takes.erase(session.takes.begin() + index);
    return Done{};
}

Status restoreTake(Session& session, const SessionTake& take) {
    if (session.findTake(take.name) >= 0)
        return Error{ErrorKind::kUsage, take.name + " is in the list already",
                     "Rename or remove the one that is there first"};
    const fs::path trashed = session.trashFolder() / fs::path(take.file).filename();
    std::error_code ignored;
    if (fs::exists(trashed, ignored))
        if (const Status moved = moveTakeFiles(trashed, session.pathOf(take)); !moved)
            return moved;
    session.takes.push_back(take);
    refreshTake(session, session.takes.back());
    sortTakes(session);
    return Done{};
}

Result<Recovery> recoverTake(Session& session, const std::string& name, const JobContext& job) {
    const int index = session.findTake(name);
    if (index < 0)
        return noSuchTake(name);
    SessionTake& take = session.takes[static_cast<size_t>(index)];
    const std::string recording = session.pathOf(take).string();
    // A finished one may be damaged where nobody looked when it was opened.
    std::optional<Error> damage;
    if (!take.canRecover()) {
        const Status sound = checkIntegrity(recording, job);
        if (!sound && sound.error().kind == ErrorKind::kCancelled)
            return sound.error();
        if (sound || !sound.error().is_damage)
            return Error{ErrorKind::kUsage, name + ": is finished already", "There is nothing to recover"};
        damage = sound.error();
    }
    const fs::path safe = takePath(session, nextTakeName(session, name + "_recovered"));
    Result<Recovery> recovered = recoverTake(recording, safe.string(), job, damage);
    if (!recovered)
        return recovered;
    // From here on nothing can be lost: at worst both stand side by side under their names.
    if (!moveToTrash(session, take.file).ok() || !moveTakeFiles(safe, session.pathOf(take)).ok()) {
        refreshTake(session, take);
        addTake(session, safe);
        return recovered;
    }
    refreshTake(session, take);
    return recovered;
}

}  // namespace noctule
