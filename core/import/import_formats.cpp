// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <map>

#include "core/import/formats.h"
#include "core/import/segment_names.h"
#include "core/import/unit_check.h"
#include "core/job/atomic_file.h"

namespace noctule {

namespace {

constexpr size_t kHeadBytes = 8192;
constexpr size_t kMostImportBytes = size_t{4} << 30;
constexpr size_t kMostImportStreamBytes = size_t{256} << 20;
constexpr size_t kMostImportFiles = 2000;
constexpr int kFolderLevels = 2;
constexpr size_t kMostNamed = 5;  ///< sensors in one warning

std::filesystem::path pathOf(const ImportFile& file) {
    return std::filesystem::path(file.path);
}

Status listFolder(const std::filesystem::path& folder, int levels, std::vector<std::string>& paths) {
    std::error_code problem;
    std::vector<std::filesystem::path> entries;
    for (std::filesystem::directory_iterator entry(folder, problem), end; !problem && entry != end;
         entry.increment(problem))
        entries.push_back(entry->path());
    if (problem)
        return Error{ErrorKind::kUnreadable, folder.string() + ": " + problem.message(),
                     "Check the folder and its permissions"};
    std::sort(entries.begin(), entries.end());
    for (const auto& entry : entries) {
        if (std::filesystem::is_directory(entry, problem)) {
            if (levels > 0)
                if (Status listed = listFolder(entry, levels - 1, paths); !listed)
                    return listed;
        } else if (std::filesystem::is_regular_file(entry, problem)) {
            paths.push_back(entry.string());
        }
        if (paths.size() > kMostImportFiles)
            return Error{ErrorKind::kUsage,
                         folder.string() + ": holds more than " + std::to_string(kMostImportFiles) + " files",
                         "Name the files or the folder of one recording"};
    }
    return Done{};
}

/// The same file given twice, or two recordings of one sensor.
Status checkNames(const ImportedRecording& recording) {
    for (size_t s = 0; s < recording.sensors.size(); ++s)
        for (size_t other = 0; other < s; ++other)
            if (recording.sensors[s].id == recording.sensors[other].id)
                return Error{ErrorKind::kUnusable,
                             recording.name + ": two sensors are named " + recording.sensors[s].id,
                             "Give each sensor's file once, and the files of one recording only"};
    return Done{};
}

/// "Pelvis, T8 and 3 more", or "Each of 17 sensors".
std::string namesOf(const std::vector<std::string>& ids, size_t sensors) {
    if (ids.size() == sensors)
        return "Each of " + std::to_string(sensors) + " sensors";
    std::string names = ids.front();
    const size_t named = ids.size() > kMostNamed ? kMostNamed - 1 : ids.size() - 1;
    for (size_t i = 1; i < named; ++i)
        names += ", " + ids[i];
    return named + 1 == ids.size() ? names + " and " + ids.back()
                                   : names + " and " + std::to_string(ids.size() - named) + " more";
}

/// What is said of several sensors in the same words is said once.
void mergeAlike(ImportedRecording& recording) {
    struct Alike {
        size_t at = 0;  ///< among the warnings
        std::vector<std::string> ids;
    };
    std::map<std::string, Alike> alike;  // by the words behind the sensor's name
    std::vector<std::string> warnings;
    for (const std::string& warning : recording.warnings) {
        const ImportedSensor* sensor = nullptr;  // the longest name: "A" begins "A: left" too
        for (const ImportedSensor& one : recording.sensors)
            if (warning.starts_with(one.id + ": ") && (!sensor || one.id.size() > sensor->id.size()))
                sensor = &one;
        if (!sensor) {
            warnings.push_back(warning);
            continue;
        }
        const auto [same, is_new] =
            alike.try_emplace(warning.substr(sensor->id.size() + 2), Alike{warnings.size(), {}});
        if (is_new)
            warnings.push_back(warning);
        if (same->second.ids.empty() || same->second.ids.back() != sensor->id)
            same->second.ids.push_back(sensor->id);
    }
    for (const auto& [words, of] : alike)
        if (of.ids.size() > 1)
            warnings[of.at] = namesOf(of.ids, recording.sensors.size()) + ": " + words;
    recording.warnings = std::move(warnings);
}

}  // namespace

std::string ImportFile::fileName() const {
    return pathOf(*this).filename().string();
}
std::string ImportFile::folderName() const {
    return pathOf(*this).parent_path().filename().string();
}
std::string ImportFile::stem() const {
    return pathOf(*this).stem().string();
}
std::string ImportFile::extension() const {
    std::string extension = pathOf(*this).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return extension;
}
std::string_view ImportFile::head() const {
    return std::string_view(bytes).substr(0, kHeadBytes);
}

const std::vector<const ImportFormat*>& importFormats() {
    static const std::vector<const ImportFormat*> formats = {
        &matFormat(), &mvnxFormat(), &xsensTextFormat(), &ximu3Format(), &stoFormat(), &csvFormat()};
    return formats;
}

const ImportFormat* findImportFormat(const std::string& name) {
    for (const ImportFormat* format : importFormats())
        if (name == format->name)
            return format;
    return nullptr;
}

const ImportFormat* importFormatOf(const std::vector<ImportFile>& files) {
    for (const ImportFormat* format : importFormats())
        if (std::any_of(files.begin(), files.end(), format->knows))
            return format;
    return nullptr;
}

Result<ImportedRecording> readImport(const ImportFormat& format, const std::vector<ImportFile>& files,
                                     const ImportChoice& choice, const JobContext& job) {
    const auto is_known = [&](const ImportFile& file) { return files.size() == 1 || format.knows(file); };
    std::vector<ImportFile> copies;  // of those known, where others stand between them: they may be large
    std::vector<std::string> others;
    const bool all_known = std::ranges::all_of(files, is_known);
    for (const ImportFile& file : files)
        if (!is_known(file))
            others.push_back(file.path);
        else if (!all_known)
            copies.push_back(file);
    const std::vector<ImportFile>& known = all_known ? files : copies;
    if (known.empty() || (known.size() > 1 && !format.several_files))
        return Error{ErrorKind::kUsage,
                     known.empty()
                         ? "No file given is of the kind " + std::string(format.name)
                         : known[1].path + ": a recording of the kind " + format.name + " is one file",
                     "Import one recording at a time"};
    auto recording = format.read(known, choice, job);
    if (!recording)
        return recording.error();
    if (Status named = checkNames(*recording); !named)
        return named.error();
    recording->format = format.name;
    for (const std::string& path : others)
        recording->warnings.push_back(path + " is no file of this kind and was left out");
    convertToSi(*recording);
    checkReadings(*recording);
    if (!holdsReadings(*recording))
        return Error{ErrorKind::kUnusable,
                     known.front().path + ": holds no reading that can be used" +
                         (recording->warnings.empty() ? "" : ": " + recording->warnings.back()),
                     "Export the recording again, with rates and accelerations or attitudes of unit length"};
    mergeAlike(*recording);
    guessSegments(*recording);
    return recording;
}

Result<std::vector<ImportFile>> readImportFiles(const std::vector<std::string>& given,
                                                const CancelFlag* cancel) {
    std::vector<std::string> paths;
    for (const std::string& path : given) {
        std::error_code problem;
        if (!std::filesystem::is_directory(path, problem))
            paths.push_back(path);
        else if (Status listed = listFolder(path, kFolderLevels, paths); !listed)
            return listed.error();
    }
    ReadOptions options;
    options.cancel = cancel;
    options.most_bytes = kMostImportBytes;
    options.most_stream_bytes = kMostImportStreamBytes;
    std::vector<ImportFile> files;
    for (const std::string& path : paths) {
        auto bytes = readWholeFile(path, options);
        if (!bytes)
            return bytes.error();
        files.push_back({path, std::move(*bytes)});
    }
    if (files.empty())
        return Error{ErrorKind::kUnreadable, given.front() + ": the folder holds no file",
                     "Give the folder that the recording was written to"};
    return files;
}

}  // namespace noctule
