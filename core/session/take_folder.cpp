// SPDX-License-Identifier: Apache-2.0
#include "core/session/take_folder.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <system_error>

#include "core/job/atomic_file.h"

namespace noctule {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDefaultBase = "take";
constexpr const char* kBeside[] = {"-wal", "-journal", "-shm"};

fs::path beside(const fs::path& take, const char* ending) {
    return take.string() + ending;
}

Status makeFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return Error{ErrorKind::kDisk, folder.string() + ": cannot be made: " + error.message(),
                     "Check that you may write there"};
    return Done{};
}

}  // namespace

bool isThere(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

std::vector<std::string> takeFilesIn(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code ignored;
    for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
        const std::string file = entry->path().filename().string();
        if (entry->path().extension() == kTakeExtension && !file.starts_with('.') &&
            entry->is_regular_file(ignored))
            files.push_back(file);
    }
    std::sort(files.begin(), files.end());
    return files;
}

fs::path takePath(const Session& session, const std::string& name) {
    return session.takesFolder() / (name + kTakeExtension);
}

bool isNameFree(const Session& session, const std::string& name) {
    return session.findTake(name) < 0 && !isThere(takePath(session, name)) &&
           !isThere(session.trashFolder() / (name + kTakeExtension));
}

std::string cleanTakeName(const std::string& name) {
    std::string clean;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool fine = byte >= 0x80 || std::isalnum(byte) || c == '-' || c == '_';
        clean += fine ? c : '_';
    }
    return clean;
}

std::string takeBaseName(const std::string& name) {
    std::string base = cleanTakeName(name);
    const size_t before_digits = base.find_last_not_of("0123456789");
    if (before_digits != std::string::npos && before_digits + 1 < base.size() && base[before_digits] == '_')
        base.erase(before_digits);
    const bool nothing = base.find_first_not_of('_') == std::string::npos;
    return nothing ? kDefaultBase : base;
}

std::string numberedTakeName(const std::string& base,
                             const std::function<bool(const std::string&)>& is_free) {
    const std::string stem = takeBaseName(base);
    for (int number = 1;; ++number) {
        char digits[16];
        std::snprintf(digits, sizeof digits, "_%03d", number);
        if (is_free(stem + digits))
            return stem + digits;
    }
}

fs::path nextTakePath(const fs::path& folder, const std::string& base) {
    const auto isFree = [](const fs::path& path) { return !isThere(path) && !isThere(beside(path, "-wal")); };
    // "takes", "takes/" and "." all stand in the folder that holds the trash.
    const fs::path trash = fs::absolute(folder / "").lexically_normal().parent_path().parent_path() / "trash";
    const std::string name = numberedTakeName(base, [&](const std::string& candidate) {
        const std::string file = candidate + kTakeExtension;
        return isFree(folder / file) && isFree(trash / file);
    });
    return folder / (name + kTakeExtension);
}

Status moveTakeFiles(const fs::path& from, const fs::path& to) {
    std::vector<const char*> moved;
    const auto moveOne = [&](const fs::path& source, const fs::path& target) {
        return publishFile(source.string(), target.string(), false);
    };
    // The log goes first: a take without its log looks whole and is not, a log without its take is nothing.
    for (const char* ending : kBeside) {
        if (!isThere(beside(from, ending)))
            continue;
        if (const Status done = moveOne(beside(from, ending), beside(to, ending)); !done) {
            for (const char* back : moved)
                (void)moveOne(beside(to, back), beside(from, back));
            return done;
        }
        moved.push_back(ending);
    }
    const Status done = moveOne(from, to);
    if (!done)
        for (const char* back : moved)
            (void)moveOne(beside(to, back), beside(from, back));
    return done;
}

Status moveToTrash(const Session& session, const std::string& file) {
    const fs::path name = fs::path(file).filename();
    const fs::path target = session.trashFolder() / name;
    if (const Status made = makeFolder(session.trashFolder()); !made)
        return made;
    if (isThere(target)) {
        fs::path older;
        for (int number = 1; older.empty() || isThere(older); ++number)
            older = session.trashFolder() /
                    (name.stem().string() + "." + std::to_string(number) + kTakeExtension);
        if (const Status moved = moveTakeFiles(target, older); !moved)
            return moved;
    }
    return moveTakeFiles(session.folder / file, target);
}

}  // namespace noctule
