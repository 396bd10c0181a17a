// SPDX-License-Identifier: Apache-2.0
// A recording of other sensors on its way into the session: read, then written as a take and, when its
// sensors have segments, processed. On any thread.
#pragma once

#include <QStringList>
#include <memory>

#include "core/import/import_format.h"
#include "core/session/session.h"

namespace noctule::ui {

/// Files by whose names a recording of sensors is told, without reading them.
bool isRecordingFileName(const QString& path);
/// Such a file, or a folder that holds one within two levels.
bool mayBeRecording(const QString& path);

struct RecordingToRead {
    QStringList paths;        ///< files and folders
    ImportChoice choice;      ///< what the operator says of it
    nlohmann::json map = {};  ///< from a file; columns of a table or segments; null: none
};

/// With segments by name or by the map.
Result<ImportedRecording> readRecording(const RecordingToRead& request, const JobContext& job);

/// Segments by movement, at their places in the recording's list of sensors.
struct FoundSegments {
    std::vector<std::string> segments;
    std::vector<double> confidence;
    std::vector<std::string> warnings;
};
Result<FoundSegments> findSegments(const ImportedRecording& recording, const JobContext& job);

struct RecordingTake {
    std::string name;
    bool has_poses = false;
    std::vector<std::string> warnings;
};
struct RecordingToKeep {
    std::shared_ptr<const ImportedRecording> recording;
    std::string software, created_utc;
};
/// Makes the take in the session's folder of takes and processes it; one without two segments is left as
/// readings. Failed or cancelled, the disk is as it was.
Result<RecordingTake> keepRecording(const RecordingToKeep& request, const Session& session,
                                    const JobContext& job);

}  // namespace noctule::ui
