// SPDX-License-Identifier: Apache-2.0
#include "ui/views/export/export_settings.h"

#include <QCoreApplication>
#include <QUuid>
#include <cmath>

#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr const char *kGroup = "export", *kOwnKeys = "export/own", *kLast = "export/last",
                     *kTypedName = "export/file_name";

struct SettingsWords {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::ExportSettings)
};

/// As the program named by the key wants FBX files.
ExportSettings madeFor(const char* key) {
    const ExportProgram program = exportProgram(key);
    ExportSettings settings;
    settings.format = ExportFormat::kFbx;
    settings.metres_per_unit = program.metres_per_unit;
    settings.frames_per_second = program.frames_per_second;
    settings.names = program.names;
    settings.root_name = QString::fromStdString(program.root_name);
    return settings;
}

ExportSettings asFormat(ExportFormat format, bool angles = false) {
    ExportSettings settings;
    settings.format = format;
    settings.angles = angles;
    if (format == ExportFormat::kGlb)
        settings.frames_per_second = 60;
    if (isPicture(format)) {
        settings.frames_per_second = 30;
        settings.body = ExportBody::kSessions;
    }
    return settings;
}

ExportPreset shippedPreset(const QString& key, const QString& name, const QString& detail,
                           const ExportSettings& settings) {
    return {key, name, detail, false, settings};
}

std::vector<ExportPreset> shipped() {
    const QString centimetres = SettingsWords::tr("FBX, centimetres, skinned");
    return {shippedPreset("motionbuilder", SettingsWords::tr("MotionBuilder and Maya"), centimetres,
                          madeFor("motionbuilder")),
            shippedPreset("blender", SettingsWords::tr("Blender"), SettingsWords::tr("FBX, metres, skinned"),
                          madeFor("blender")),
            shippedPreset("unity", SettingsWords::tr("Unity"), centimetres, madeFor("unity")),
            shippedPreset("unreal", SettingsWords::tr("Unreal"), centimetres, madeFor("unreal")),
            shippedPreset("bvh", SettingsWords::tr("Any animation program"),
                          SettingsWords::tr("BVH, centimetres, Y up"), asFormat(ExportFormat::kBvh)),
            shippedPreset("web", SettingsWords::tr("Web and viewers"),
                          SettingsWords::tr("glTF binary, metres, skinned"), asFormat(ExportFormat::kGlb)),
            shippedPreset("opensim", SettingsWords::tr("Biomechanics"),
                          SettingsWords::tr("OpenSim joint angles, degrees"), asFormat(ExportFormat::kMot)),
            shippedPreset("positions", SettingsWords::tr("Numbers"),
                          SettingsWords::tr("CSV of joint positions, metres"), asFormat(ExportFormat::kCsv)),
            shippedPreset("angles", SettingsWords::tr("Numbers with angles"),
                          SettingsWords::tr("CSV of positions and joint angles"),
                          asFormat(ExportFormat::kCsv, true)),
            shippedPreset("film", SettingsWords::tr("Film"), SettingsWords::tr("MP4, the session's body"),
                          asFormat(ExportFormat::kVideo)),
            shippedPreset("picture", SettingsWords::tr("Picture"),
                          SettingsWords::tr("PNG, the session's body"), asFormat(ExportFormat::kPng))};
}

QString groupOf(const QString& key) {
    return QString("%1/%2").arg(kGroup, key);
}

ExportSettings loaded(QSettings& store, const QString& key, const ExportSettings& otherwise) {
    store.beginGroup(groupOf(key));
    ExportSettings s = otherwise;
    s.format = static_cast<ExportFormat>(
        std::clamp(store.value("format", static_cast<int>(s.format)).toInt(), 0, 7));
    s.also.clear();
    for (const QVariant& also : store.value("also").toList())
        s.also.insert(static_cast<ExportFormat>(std::clamp(also.toInt(), 0, 7)));
    s.range =
        static_cast<ExportRange>(std::clamp(store.value("range", static_cast<int>(s.range)).toInt(), 0, 2));
    s.own_from_s = store.value("own_from_s", s.own_from_s).toDouble();
    s.own_to_s = store.value("own_to_s", s.own_to_s).toDouble();
    s.frames_per_second =
        std::clamp(store.value("frames_per_second", s.frames_per_second).toDouble(), 1.0, 1000.0);
    s.root = static_cast<RootMotion>(std::clamp(store.value("root", static_cast<int>(s.root)).toInt(), 0, 2));
    s.metres_per_unit = store.value("metres_per_unit", s.metres_per_unit).toDouble() == 1 ? 1 : 0.01;
    s.names =
        static_cast<JointNames>(std::clamp(store.value("names", static_cast<int>(s.names)).toInt(), 0, 1));
    const bool skeleton_before = !store.value("with_body", true).toBool();  // as older versions kept it
    const ExportBody body = skeleton_before ? ExportBody::kSkeleton : s.body;
    s.body = static_cast<ExportBody>(std::clamp(store.value("body", static_cast<int>(body)).toInt(), 0, 2));
    s.width_px = std::clamp(store.value("width_px", s.width_px).toInt(), 2, 8192);
    s.height_px = std::clamp(store.value("height_px", s.height_px).toInt(), 2, 8192);
    s.camera =
        static_cast<CameraMove>(std::clamp(store.value("camera", static_cast<int>(s.camera)).toInt(), 0, 2));
    s.root_name = store.value("root_name", s.root_name).toString();
    s.lock_feet = store.value("lock_feet", s.lock_feet).toBool();
    s.one_file = store.value("one_file", s.one_file).toBool();
    s.angles = store.value("angles", s.angles).toBool();
    s.folder = store.value("folder", s.folder).toString();
    s.name_pattern = store.value("name_pattern", s.name_pattern).toString();
    store.endGroup();
    return s;
}

void save(QSettings& store, const QString& key, const ExportSettings& s) {
    store.beginGroup(groupOf(key));
    store.setValue("format", static_cast<int>(s.format));
    QVariantList also;
    for (const ExportFormat each : s.also)
        also.append(static_cast<int>(each));
    store.setValue("also", also);
    store.setValue("range", static_cast<int>(s.range));
    store.setValue("own_from_s", s.own_from_s);
    store.setValue("own_to_s", s.own_to_s);
    store.setValue("frames_per_second", s.frames_per_second);
    store.setValue("root", static_cast<int>(s.root));
    store.setValue("metres_per_unit", s.metres_per_unit);
    store.setValue("names", static_cast<int>(s.names));
    store.setValue("body", static_cast<int>(s.body));
    store.setValue("width_px", s.width_px);
    store.setValue("height_px", s.height_px);
    store.setValue("camera", static_cast<int>(s.camera));
    store.setValue("root_name", s.root_name);
    store.setValue("lock_feet", s.lock_feet);
    store.setValue("one_file", s.one_file);
    store.setValue("angles", s.angles);
    store.setValue("folder", s.folder);
    store.setValue("name_pattern", s.name_pattern);
    store.endGroup();
}

}  // namespace

ExportPresets::ExportPresets(QSettings& store) : store_(store) {
    load();
}

void ExportPresets::load() {
    presets_ = shipped();
    for (ExportPreset& preset : presets_) {
        const QString name = preset.settings.name_pattern;
        preset.settings = loaded(store_, preset.key, preset.settings);
        preset.settings.name_pattern = name;  // one that is typed is kept beside the presets
    }
    for (const QString& key : store_.value(kOwnKeys).toStringList()) {
        ExportPreset own;
        own.key = key;
        own.is_own = true;
        own.name = store_.value(groupOf(key) + "/name").toString();
        own.settings = loaded(store_, key, {});
        own.detail = settingsInWords(own.settings);
        presets_.push_back(own);
    }
}

int ExportPresets::indexOf(const QString& key) const {
    for (size_t i = 0; i < presets_.size(); ++i)
        if (presets_[i].key == key)
            return static_cast<int>(i);
    return -1;
}

QString ExportPresets::lastChosen() const {
    const QString key = store_.value(kLast).toString();
    return indexOf(key) >= 0 ? key : presets_.front().key;
}

void ExportPresets::choose(const QString& key) {
    store_.setValue(kLast, key);
}

QString ExportPresets::keptName() const {
    return store_.value(kTypedName).toString();
}

void ExportPresets::keepName(const QString& name) {
    store_.setValue(kTypedName, name);
}

void ExportPresets::remember(const QString& key, const ExportSettings& settings) {
    save(store_, key, settings);
    load();
}

QString ExportPresets::addOwn(const QString& name, const ExportSettings& settings) {
    const QString key = "own-" + QUuid::createUuid().toString(QUuid::Id128).left(8);
    QStringList keys = store_.value(kOwnKeys).toStringList();
    store_.setValue(kOwnKeys, keys << key);
    store_.setValue(groupOf(key) + "/name", name);
    remember(key, settings);
    return key;
}

void ExportPresets::removeOwn(const QString& key) {
    QStringList keys = store_.value(kOwnKeys).toStringList();
    keys.removeAll(key);
    store_.setValue(kOwnKeys, keys);
    store_.remove(groupOf(key));
    load();
}

QString formatName(ExportFormat format) {
    switch (format) {
        case ExportFormat::kBvh:
            return "BVH";
        case ExportFormat::kCsv:
            return "CSV";
        case ExportFormat::kFbx:
            return "FBX";
        case ExportFormat::kGlb:
            return SettingsWords::tr("glTF binary");
        case ExportFormat::kMot:
            return SettingsWords::tr("OpenSim angles");
        case ExportFormat::kSto:
            return SettingsWords::tr("OpenSim orientations");
        case ExportFormat::kPng:
            return SettingsWords::tr("Picture (PNG)");
        case ExportFormat::kVideo:
            return SettingsWords::tr("Film (MP4)");
    }
    return {};
}

bool hasUnit(ExportFormat format) {
    return format == ExportFormat::kBvh || format == ExportFormat::kFbx;
}

bool hasNames(ExportFormat format) {
    return hasUnit(format) || format == ExportFormat::kGlb;
}

QString rateText(double frames_per_second) {
    const bool is_whole = frames_per_second == std::round(frames_per_second);
    return numberText(frames_per_second, is_whole ? 0 : 2);
}

QString settingsInWords(const ExportSettings& settings) {
    const QString frames = rateText(settings.frames_per_second), format = formatName(settings.format);
    const QString size = SettingsWords::tr("%1 × %2").arg(settings.width_px).arg(settings.height_px);
    if (settings.format == ExportFormat::kPng)
        return SettingsWords::tr("%1, %2").arg(format, size);
    if (settings.format == ExportFormat::kVideo)
        return SettingsWords::tr("%1, %2, %3 frames").arg(format, size, frames);
    if (settings.format == ExportFormat::kMot || settings.format == ExportFormat::kSto)
        return SettingsWords::tr("%1, %2 frames").arg(format, frames);
    if (settings.format == ExportFormat::kCsv && settings.angles)
        return SettingsWords::tr("CSV with angles, %1 frames").arg(frames);
    const bool metres = !hasUnit(settings.format) || settings.metres_per_unit == 1;
    return metres ? SettingsWords::tr("%1, metres, %2 frames").arg(format, frames)
                  : SettingsWords::tr("%1, centimetres, %2 frames").arg(format, frames);
}

std::vector<ExportFormat> formatsOf(const ExportSettings& settings) {
    std::vector<ExportFormat> formats{settings.format};
    for (const ExportFormat each : settings.also)
        if (each != settings.format)
            formats.push_back(each);
    return formats;
}

QString exportFolder(const Session& session, const ExportSettings& settings) {
    return settings.folder.isEmpty() ? QString::fromStdString(session.exportsFolder().string())
                                     : settings.folder;
}

namespace {

void setRange(ExportRequest& request, const SessionTake& take, const ExportSettings& settings) {
    if (settings.range == ExportRange::kInToOut && take.in_s > 0)
        request.from_s = take.in_s;
    if (settings.range == ExportRange::kInToOut && take.out_s > 0)
        request.to_s = take.out_s;
    if (settings.range == ExportRange::kOwn) {
        request.from_s = settings.own_from_s;
        request.to_s = settings.own_to_s;
    }
}

/// Body and camera.
Status setLook(ExportRequest& request, const ExportSurroundings& surroundings,
               const ExportSettings& settings) {
    request.with_body = settings.body != ExportBody::kSkeleton;
    request.lock_feet = settings.lock_feet;
    request.film = {{settings.width_px, settings.height_px},
                    settings.camera,
                    settings.frames_per_second,
                    surroundings.look.blending};
    if (settings.body != ExportBody::kSessions || !showsBody(settings.format))
        return Done{};
    request.worn = surroundings.look.worn;
    if (surroundings.session.body.isOurs() || request.worn)
        return Done{};
    return Error{ErrorKind::kUnusable, SettingsWords::tr("The session's body is not there yet").toStdString(),
                 SettingsWords::tr("Wait until it is read, or choose another body").toStdString()};
}

}  // namespace

Result<ExportJob> exportJob(const ExportSurroundings& surroundings, const SessionTake& take,
                            const QString& run, const ExportSettings& settings,
                            std::set<std::string>& taken) {
    const Session& session = surroundings.session;
    ExportJob job;
    job.format = settings.format;
    job.take = QString::fromStdString(take.name);
    ExportRequest& request = job.request;
    request.take_path = session.pathOf(take).string();
    request.run = run.toStdString();
    request.frames_per_second = settings.frames_per_second;
    request.root = settings.root;
    setRange(request, take, settings);
    if (const Status look = setLook(request, surroundings, settings); !look)
        return look.error();
    job.in_one_file = settings.one_file && holdsSeveral(settings.format);
    if (job.in_one_file)
        request.motion_name = run.isEmpty() ? take.name : take.name + " " + run.toStdString();
    const auto name =
        exportFileName(settings.name_pattern.toStdString(),
                       {job.in_one_file ? session.name : take.name, take.performer, run.toStdString(),
                        surroundings.date.toStdString(), settings.frames_per_second});
    if (!name)
        return name.error();
    const ExportFormatEntry& entry = entryOf(settings.format);
    request.*entry.path =
        job.in_one_file && !taken.empty()
            ? *taken.begin()
            : freeFilePath(exportFolder(session, settings).toStdString(), *name, entry.extension, taken);
    request.metres_per_unit = settings.metres_per_unit;
    request.names = settings.names;
    request.root_name = settings.root_name.toStdString();
    request.angles = settings.format == ExportFormat::kCsv && settings.angles;
    return job;
}

}  // namespace noctule::ui
