// SPDX-License-Identifier: Apache-2.0
// What is exported and how: the presets that ship and those that the operator saved, each remembering its
// settings; and the request that a take makes of them, the same that `noctule --batch export` makes.
#pragma once

#include <QSettings>
#include <QString>
#include <set>
#include <vector>

#include "core/processing/export_names.h"
#include "core/processing/export_program.h"
#include "core/processing/export_take.h"
#include "core/session/session.h"
#include "ui/models/shown_body.h"

namespace noctule::ui {

/// Stored by number.
enum class ExportRange { kInToOut, kWholeTake, kOwn };
enum class ExportBody { kOurs, kSkeleton, kSessions };

struct ExportSettings {
    ExportFormat format = ExportFormat::kBvh;
    std::set<ExportFormat> also;  ///< in these formats too, one file more for each
    ExportRange range = ExportRange::kInToOut;
    double own_from_s = 0, own_to_s = 0;
    double frames_per_second = 120;
    RootMotion root = RootMotion::kMoving;
    double metres_per_unit = 0.01;         ///< BVH and FBX; the others are in metres
    JointNames names = JointNames::kOwn;   ///< BVH, FBX and GLB
    ExportBody body = ExportBody::kOurs;   ///< FBX, GLB, pictures and films
    bool lock_feet = true;                 ///< of the session's body
    int width_px = 1280, height_px = 720;  ///< pictures and films
    CameraMove camera = CameraMove::kFront;
    QString root_name = "Reference";  ///< FBX
    bool one_file = false;            ///< FBX and GLB: all takes in it, an animation for each
    bool angles = false;              ///< CSV
    QString folder;                   ///< empty: exports/ of the session
    QString name_pattern = "{take}_{fps}";

    bool operator==(const ExportSettings&) const = default;
};

struct ExportPreset {
    QString key;     ///< in settings
    QString name;    ///< "MotionBuilder and Maya"
    QString detail;  ///< "BVH, centimetres, Y up"
    bool is_own = false;
    ExportSettings settings;
};

class ExportPresets {
public:
    explicit ExportPresets(QSettings& store);

    const std::vector<ExportPreset>& all() const { return presets_; }
    int indexOf(const QString& key) const;  ///< -1: none
    QString lastChosen() const;
    void choose(const QString& key);
    /// Kept for the next time that the preset is chosen.
    void remember(const QString& key, const ExportSettings& settings);
    /// A file name that was typed, whatever preset is chosen; empty: none.
    QString keptName() const;
    void keepName(const QString& name);
    QString addOwn(const QString& name, const ExportSettings& settings);  ///< its key
    void removeOwn(const QString& key);

private:
    void load();

    QSettings& store_;
    std::vector<ExportPreset> presets_;
};

/// "FBX", "OpenSim angles"
QString formatName(ExportFormat format);
bool hasUnit(ExportFormat format);   ///< of its own choice
bool hasNames(ExportFormat format);  ///< of joints
/// "30", of television "29.97"
QString rateText(double frames_per_second);
/// "BVH, centimetres, 120 frames"
QString settingsInWords(const ExportSettings& settings);

/// The main format first, each once.
std::vector<ExportFormat> formatsOf(const ExportSettings& settings);

/// One take of an export.
struct ExportJob {
    QString take;
    ExportFormat format = ExportFormat::kBvh;
    ExportRequest request;
    bool in_one_file = false;  ///< with the other takes
    std::string path() const { return outputsOf(request).front(); }
};
/// What all takes of an export share.
struct ExportSurroundings {
    const Session& session;
    BodyLook look;
    QString date;  ///< "2026-11-21"
};
/// `run` empty: the last one. `taken`: names of this export so far. kUnusable while the session's body is
/// wanted and not there.
Result<ExportJob> exportJob(const ExportSurroundings& surroundings, const SessionTake& take,
                            const QString& run, const ExportSettings& settings, std::set<std::string>& taken);
QString exportFolder(const Session& session, const ExportSettings& settings);

}  // namespace noctule::ui
