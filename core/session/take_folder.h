// SPDX-License-Identifier: Apache-2.0
// The files behind a session's takes: which there are, which names are free, and moving one with what SQLite
// keeps beside it. Names are those of files, "walk_001.noctule".
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/job/result.h"
#include "core/session/session.h"

namespace noctule {

inline constexpr const char* kTakeExtension = ".noctule";

/// False, too, where the path cannot be asked about.
bool isThere(const std::filesystem::path& path);

/// Of all takes in a folder, sorted; empty when the folder is missing.
std::vector<std::string> takeFilesIn(const std::filesystem::path& folder);

/// The take's file in takes/.
std::filesystem::path takePath(const Session& session, const std::string& name);

/// Whether nothing in the session, its takes/ and its trash/ has the name "walk_001".
bool isNameFree(const Session& session, const std::string& name);

/// What was typed as a take's name with "_" for all that cannot be part of a file's name everywhere; other
/// letters than ASCII may stay.
std::string cleanTakeName(const std::string& name);
/// "walk" of "walk_001" and of "walk": what stands before a take's number, fit to be part of a file's name.
std::string takeBaseName(const std::string& name);
/// "walk_004": the first number whose name is free.
std::string numberedTakeName(const std::string& base, const std::function<bool(const std::string&)>& is_free);
/// The same in any folder, and in the trash beside it if it is a session's takes/.
std::filesystem::path nextTakePath(const std::filesystem::path& folder, const std::string& base);

/// Moves the take and the log beside it, if there is one; kUsage when something is there already. On an error
/// all stays where it was.
Status moveTakeFiles(const std::filesystem::path& from, const std::filesystem::path& to);

/// Moves a take to trash/. One of that name that lies there already gets another.
Status moveToTrash(const Session& session, const std::string& file);

/// In order of creation; those whose time is not known come last.
void sortTakes(Session& session);

}  // namespace noctule
