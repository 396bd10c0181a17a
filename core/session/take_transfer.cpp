// SPDX-License-Identifier: Apache-2.0
#include "core/session/take_transfer.h"

#include <sys/stat.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "core/recording/database.h"
#include "core/recording/recover_take.h"
#include "core/recording/take.h"
#include "core/recording/take_copy.h"
#include "core/session/take_folder.h"

namespace noctule {
namespace {

namespace fs = std::filesystem;

/// None: it cannot be asked about.
std::optional<dev_t> fileSystemOf(const fs::path& folder) {
    struct stat found {};
    return stat(folder.c_str(), &found) == 0 ? std::optional(found.st_dev) : std::nullopt;
}

/// The list of a session is read, changed and written as one: two takes may be copied there at once.
std::unique_lock<std::mutex> lists() {
    static std::mutex one_at_a_time;
    return std::unique_lock(one_at_a_time);
}

Status listThere(const TakeTransfer& transfer) {
    const auto held = lists();
    auto there = readSession(transfer.to);
    if (!there)
        return there.error();
    std::erase_if(there->takes, [&](const SessionTake& take) { return take.name == transfer.take.name; });
    there->takes.push_back(transfer.take);
    if (transfer.performer && !there->findPerformer(transfer.performer->name))
        there->performers.push_back(*transfer.performer);
    return saveSession(*there);
}

/// Removes the take's line, and the performer who came with it unless current there or in another take.
Status unlistThere(const TakeTransfer& transfer) {
    const auto held = lists();
    auto there = readSession(transfer.to);
    if (!there)
        return there.error();
    std::erase_if(there->takes, [&](const SessionTake& take) { return take.name == transfer.take.name; });
    if (transfer.performer && there->current_performer != transfer.performer->name &&
        std::ranges::none_of(there->takes, [&](const SessionTake& take) {
            return take.performer == transfer.performer->name;
        }))
        std::erase_if(there->performers,
                      [&](const Performer& one) { return one.name == transfer.performer->name; });
    return saveSession(*there);
}

/// Another one after each change of the file.
Result<int64_t> changesOf(const fs::path& take) {
    // A write that broke off is taken back first, which reading alone cannot do.
    const bool broke_off = isThere(take.string() + "-journal");
    const auto file = Database::open(take.string(), broke_off ? Access::kReadWrite : Access::kRead);
    return file ? file->changeCounter() : Result<int64_t>(file.error());
}

/// Nothing was written into the take since `changes`, and nothing is being written.
Status isUnchanged(const fs::path& take, int64_t changes) {
    const bool is_written = isThere(take.string() + "-journal");
    const auto now = changesOf(take);
    if (!now)
        return now.error();
    if (is_written || *now != changes)
        return Error{ErrorKind::kUnusable, take.stem().string() + ": was changed after copying began",
                     "Move or copy it again"};
    return Done{};
}

/// By now another take may have its name there.
Status isTheOne(const TakeTransfer& transfer, const fs::path& file) {
    const auto take = Take::open(file.string());
    if ((take ? take->header().uuid : "") != transfer.uuid)
        return Error{ErrorKind::kUsage, transfer.take.name + ": another take has this name by now",
                     "Rename that one first"};
    return Done{};
}

/// Where moveToTrash() puts it.
fs::path trashedThere(const TakeTransfer& transfer) {
    return transfer.to / "trash" / fs::path(transfer.take.file).filename();
}

}  // namespace

Result<TakeTransfer> arrangeTransfer(const Session& from, const std::string& name, const fs::path& to) {
    const int index = from.findTake(name);
    if (index < 0)
        return Error{ErrorKind::kUsage, name + ": is not a take of this session", "Choose another one"};
    std::error_code ignored;
    if (fs::equivalent(from.folder, to, ignored))
        return Error{ErrorKind::kUsage, name + ": is in this session already", "Choose another session"};
    auto there = readSession(to);
    if (!there)
        return there.error();
    TakeTransfer transfer;
    transfer.to = to;
    transfer.to_name = there->name;
    transfer.original = from.takes[static_cast<size_t>(index)];
    const fs::path file = from.pathOf(transfer.original);
    if (!isThere(file))
        return Error{ErrorKind::kUnusable, transfer.original.file + ": is not there any more", "Put it back"};
    if (transfer.original.state == TakeState::kRecording)
        return Error{ErrorKind::kUnusable, name + ": the recording was not finished", "Recover it first"};
    if (isBeingWritten(file.string()))
        return beingRecorded(file.string());
    if (const auto take = Take::open(file.string()))  // a damaged one goes along as it is
        transfer.uuid = take->header().uuid;
    fs::create_directories(to / "takes", ignored);  // what cannot be made is told when the take is written
    transfer.take = transfer.original;
    transfer.take.name = isNameFree(*there, name) ? name : nextTakeName(*there, name);
    transfer.take.file = "takes/" + transfer.take.name + kTakeExtension;
    const Performer* performer = from.findPerformer(transfer.take.performer);
    if (performer && !there->findPerformer(performer->name))
        transfer.performer = *performer;
    return transfer;
}

void followList(const Session& from, TakeTransfer& transfer) {
    const int index = from.findTake(transfer.original.name);
    if (index < 0)
        return;
    const SessionTake& now = from.takes[static_cast<size_t>(index)];
    const Performer* performer = from.findPerformer(now.performer);
    if (performer && (transfer.performer || now.performer != transfer.original.performer))
        transfer.performer = *performer;
    const SessionTake arranged = std::exchange(transfer.take, now);
    transfer.take.name = arranged.name;
    transfer.take.file = arranged.file;
    transfer.original = now;
}

bool canBeRenamed(const Session& from, const TakeTransfer& transfer) {
    const auto here = fileSystemOf(from.takesFolder()), there = fileSystemOf(transfer.to / "takes");
    return here && here == there;
}

Status copyThere(const Session& from, TakeTransfer& transfer, const JobContext& job) {
    const fs::path here = from.pathOf(transfer.original);
    const auto changes = changesOf(here);
    if (!changes)
        return changes.error();
    auto copy = TakeCopy::make(here.string(), transfer.path().string(), job);
    if (!copy)
        return copy.error();
    if (Status unchanged = isUnchanged(here, *changes); !unchanged)
        return unchanged;
    transfer.changes = *changes;
    if (Status folded = copy->foldLog(); !folded)
        return folded;
    if (const auto opened = Take::open(copy->path()); !opened)
        return copy->named(opened.error());
    if (Status published = copy->publish(false); !published)
        return published;
    transfer.is_copied = true;
    Status listed = listThere(transfer);
    std::error_code ignored;
    if (!listed)
        fs::remove(transfer.path(), ignored);
    return listed;
}

Status moveThere(Session& from, const TakeTransfer& transfer) {
    const fs::path here = from.pathOf(transfer.original), there = transfer.path();
    const fs::path source = transfer.is_copied ? trashedThere(transfer) : here;
    const bool is_moved = !transfer.is_copied || !isThere(there);  // else it was copied just before
    if (transfer.is_copied)
        if (Status unchanged = isUnchanged(here, transfer.changes); !unchanged)
            return unchanged;
    if (transfer.is_copied)
        if (Status ours = isTheOne(transfer, is_moved ? source : there); !ours)
            return ours;
    if (is_moved)
        if (Status moved = moveTakeFiles(source, there); !moved)
            return moved;
    if (Status listed = listThere(transfer); !listed) {
        if (is_moved)
            (void)moveTakeFiles(there, source);
        return listed;
    }
    if (transfer.is_copied) {
        Status trashed = trashTake(from, transfer.original.name);
        if (!trashed && is_moved) {
            (void)unlistThere(transfer);
            (void)moveTakeFiles(there, source);
        }
        return trashed;
    }
    std::erase_if(from.takes, [&](const SessionTake& take) { return take.name == transfer.original.name; });
    return Done{};
}

Status moveBack(Session& from, const TakeTransfer& transfer) {
    if (from.findTake(transfer.original.name) >= 0)
        return Error{ErrorKind::kUsage, transfer.original.name + " is in the list already",
                     "Rename or remove the one that is there first"};
    if (isThere(transfer.path()))
        if (Status ours = isTheOne(transfer, transfer.path()); !ours)
            return ours;
    if (transfer.is_copied) {
        Session there;
        there.folder = transfer.to;
        if (isThere(transfer.path()))
            if (Status trashed = moveToTrash(there, transfer.take.file); !trashed)
                return trashed;
        if (Status restored = restoreTake(from, transfer.original); !restored) {
            (void)moveTakeFiles(trashedThere(transfer), transfer.path());
            return restored;
        }
        (void)unlistThere(transfer);  // a line too many does no harm, the take is back
        return Done{};
    }
    if (Status moved = moveTakeFiles(transfer.path(), from.pathOf(transfer.original)); !moved)
        return moved;
    (void)unlistThere(transfer);
    from.takes.push_back(transfer.original);
    refreshTake(from, from.takes.back());
    sortTakes(from);
    return Done{};
}

}  // namespace noctule
