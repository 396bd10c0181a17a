// SPDX-License-Identifier: Apache-2.0
// The kinds of recordings of other sensors, by name. A new one is one file and one line in
// import_formats.cpp.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/import/recording.h"
#include "core/import/world_frame.h"
#include "core/job/job.h"

namespace noctule {

/// One file as a whole. Its path names it in messages and, for x-IMU3, the device by the folder.
struct ImportFile {
    std::string path, bytes;

    std::string fileName() const;    ///< "Inertial.csv"
    std::string folderName() const;  ///< "pelvis 64F0EDBF (UDP)"; empty without
    std::string stem() const;        ///< "Inertial"
    std::string extension() const;   ///< ".csv", small letters
    std::string_view head() const;   ///< its first bytes, by which its kind is told
};

/// What the user says of a recording.
struct ImportChoice {
    double rate_hz = 0;               ///< above 0: in place of what the file says
    std::optional<WorldFrame> world;  ///< of its attitudes, in place of what the file says
    nlohmann::json map = nullptr;     ///< column_map.h; null: none
};

struct ImportFormat {
    const char* name;
    const char* summary;
    bool several_files;  ///< one recording may be several files
    bool (*knows)(const ImportFile& file);
    Result<ImportedRecording> (*read)(const std::vector<ImportFile>& files, const ImportChoice& choice,
                                      const JobContext& job);
};

const std::vector<const ImportFormat*>& importFormats();
const ImportFormat* findImportFormat(const std::string& name);  ///< null: no such
/// The first that knows the first file; null: none.
const ImportFormat* importFormatOf(const std::vector<ImportFile>& files);

/// Reads, converts to SI, checks, and guesses segments by names. Files that the format does not know are left
/// out with a warning. kUsage: several files of a kind that is one file.
Result<ImportedRecording> readImport(const ImportFormat& format, const std::vector<ImportFile>& files,
                                     const ImportChoice& choice, const JobContext& job);

/// All files that the paths mean: a folder stands for the files in it and in its folders, two levels down, in
/// the order of their names. kUnreadable names the path.
Result<std::vector<ImportFile>> readImportFiles(const std::vector<std::string>& paths,
                                                const CancelFlag* cancel);

}  // namespace noctule
