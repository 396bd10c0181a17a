// SPDX-License-Identifier: Apache-2.0
#include "ui/models/recording_import.h"

#include <QDirIterator>
#include <QFileInfo>
#include <algorithm>
#include <cstdio>

#include "core/assignment/assign_segments.h"
#include "core/import/import_take.h"
#include "core/import/segment_map.h"
#include "core/job/atomic_file.h"
#include "core/job/staged_progress.h"
#include "core/processing/process_take.h"
#include "devices/machine/random_uuid.h"

namespace noctule::ui {
namespace {

/// Removes an unfinished take unless it was published.
class UnfinishedTake {
public:
    explicit UnfinishedTake(std::string path) : path_(std::move(path)) {}
    UnfinishedTake(const UnfinishedTake&) = delete;
    UnfinishedTake& operator=(const UnfinishedTake&) = delete;
    ~UnfinishedTake() { std::remove(path_.c_str()); }
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

std::vector<std::string> pathsOf(const QStringList& paths) {
    std::vector<std::string> all;
    for (const QString& path : paths)
        all.push_back(path.toStdString());
    return all;
}

bool hasPosesToMake(const ImportedRecording& recording) {
    return recording.sensors.size() >= sensorsWithoutSegment(recording).size() + 2;
}

}  // namespace

bool isRecordingFileName(const QString& path) {
    static const QStringList kKinds{"mat", "mvnx", "ximu3", "sto", "txt", "csv", "tsv", "mtb"};
    return kKinds.contains(QFileInfo(path).suffix().toLower());
}

bool mayBeRecording(const QString& path) {
    constexpr int kLevels = 2, kMostLookedAt = 500;
    if (!QFileInfo(path).isDir())
        return isRecordingFileName(path);
    int looked_at = 0;
    for (QDirIterator entry(path, QDir::Files, QDirIterator::Subdirectories);
         entry.hasNext() && looked_at < kMostLookedAt; ++looked_at) {
        const QString file = entry.next();
        if (QDir(path).relativeFilePath(file).count('/') <= kLevels && isRecordingFileName(file))
            return true;
    }
    return false;
}

Result<ImportedRecording> readRecording(const RecordingToRead& request, const JobContext& job) {
    const auto files = readImportFiles(pathsOf(request.paths), job.cancel);
    if (!files)
        return files.error();
    ImportChoice choice = request.choice;
    const bool columns = describesColumns(request.map);
    if (columns)
        choice.map = request.map;
    const ImportFormat* format = columns ? findImportFormat("csv") : importFormatOf(*files);
    if (!format && files->front().extension() == ".mtb")
        return Error{ErrorKind::kUnreadable,
                     files->front().fileName() + ": is a log that only Xsens' own programs read",
                     "Export it as text in MT Manager, and import that"};
    if (!format)
        return Error{
            ErrorKind::kUnreadable, files->front().fileName() + ": is no recording of sensors",
            "Recordings are MATLAB, MVNX, MT Manager's text, x-IMU3, OpenSense .sto, and tables with a map"};
    auto recording = readImport(*format, *files, choice, job);
    if (recording && request.map.is_object() && !columns)
        if (Status placed = applySegmentMap(request.map, *recording); !placed)
            return placed.error();
    return recording;
}

Result<FoundSegments> findSegments(const ImportedRecording& recording, const JobContext& job) {
    std::vector<ImuSamples> samples;
    for (const ImportedSensor& sensor : recording.sensors)
        samples.push_back(sensor.samples);
    const auto found = assignment::assignSegments(samples, job);
    if (!found)
        return found.error();
    FoundSegments segments;
    segments.warnings = found->warnings;
    for (const auto& [segment, confidence] : found->sensors) {
        segments.segments.push_back(segment);
        segments.confidence.push_back(confidence);
    }
    return segments;
}

Result<RecordingTake> keepRecording(const RecordingToKeep& request, const Session& session,
                                    const JobContext& job) {
    const ImportedRecording& recording = *request.recording;
    RecordingTake take{nextTakeName(session, recording.name), hasPosesToMake(recording), {}};
    const std::string path = (session.takesFolder() / (take.name + ".noctule")).string();
    const UnfinishedTake unfinished(asidePath(path));
    {
        StagedProgress stage(job, 0, take.has_poses ? 0.2 : 1);
        const auto written =
            writeImportedTake(recording,
                              {unfinished.path(), take.name, request.created_utc, request.software,
                               randomUuid(), false, session.current_performer},
                              stage.job());
        if (!written)
            return namedAs(written.error(), unfinished.path(), path);
    }
    if (take.has_poses) {
        StagedProgress stage(job, 0.2, 1);
        ProcessRequest process;
        process.take_path = unfinished.path();
        process.tracker.estimator = kOrientationEstimator;
        process.tracker.smoother = Smoother::kFull;
        process.software = request.software;
        process.created_utc = request.created_utc;
        if (const Performer* performer = session.findPerformer(session.current_performer))
            process.actor = defaultActor(performer->measures);
        const auto made = processTake(process, stage.job());
        if (!made && made.error().kind == ErrorKind::kCancelled)
            return made.error();
        // The readings are worth keeping where no pose could be made of them.
        take.has_poses = made.ok();
        take.warnings =
            made ? made->warnings
                 : std::vector<std::string>{namedAs(made.error(), unfinished.path(), path).text() + "."};
    }
    if (Status published = publishFile(unfinished.path(), path, false); !published)
        return published.error();
    return take;
}

}  // namespace noctule::ui
