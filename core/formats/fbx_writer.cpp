// SPDX-License-Identifier: Apache-2.0
#include "core/formats/fbx_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "core/formats/scene_check.h"
#include "core/job/atomic_file.h"

namespace noctule {
namespace {

constexpr const char* kCreator = "Noctule";
constexpr double kSameJoint_m = 1e-6;

/// The format's own number of a frame rate; 14 is any other, which then stands beside it.
int32_t fbxTimeMode(double frames_per_second) {
    constexpr std::array<std::pair<double, int32_t>, 11> kModes = {{{120, 1},
                                                                    {100, 2},
                                                                    {60, 3},
                                                                    {50, 4},
                                                                    {48, 5},
                                                                    {30, 6},
                                                                    {25, 10},
                                                                    {24, 11},
                                                                    {1000, 12},
                                                                    {96, 15},
                                                                    {72, 16}}};
    for (const auto& [rate, mode] : kModes)
        if (std::abs(frames_per_second - rate) < 1e-9 * rate)
            return mode;
    return 14;
}

FbxNode fbxHeader() {
    FbxNode stamp("CreationTimeStamp");
    stamp.add(FbxNode("Version", int32_t{1000}));
    for (const auto& [part, value] :
         {std::pair("Year", 1970), std::pair("Month", 1), std::pair("Day", 1), std::pair("Hour", 10),
          std::pair("Minute", 0), std::pair("Second", 0), std::pair("Millisecond", 0)})
        stamp.add(FbxNode(part, int32_t{value}));
    FbxNode header("FBXHeaderExtension");
    header.add(FbxNode("FBXHeaderVersion", int32_t{1003}))
        .add(FbxNode("FBXVersion", int32_t{7400}))
        .add(FbxNode("EncryptionType", int32_t{0}))
        .add(std::move(stamp))
        .add(FbxNode("Creator", kCreator));
    return header;
}

/// Of the longest motion.
int64_t fbxStop(std::span<const Figure> figures) {
    int64_t stop = 0;
    for (const Figure& figure : figures)
        stop = std::max(stop, fbxLastTime(figure.clip));
    return stop;
}

FbxNode fbxSettings(std::span<const Figure> figures, const FbxOptions& options) {
    const auto whole = [](const char* name, int32_t value) {
        return fbxProperty(name, "int", "Integer", "", value);
    };
    const auto number = [](const char* name, double value) {
        return fbxProperty(name, "double", "Number", "", value);
    };
    const double units_cm = options.metres_per_unit * 100,
                 frames_per_second = 1 / figures[0].clip.frame_time_s;
    FbxNode settings("GlobalSettings");
    settings.add(FbxNode("Version", int32_t{1000}))
        .add(fbxProperties({whole("UpAxis", 1), whole("UpAxisSign", 1), whole("FrontAxis", 2),
                            whole("FrontAxisSign", 1), whole("CoordAxis", 0), whole("CoordAxisSign", 1),
                            whole("OriginalUpAxis", 1), whole("OriginalUpAxisSign", 1),
                            number("UnitScaleFactor", units_cm), number("OriginalUnitScaleFactor", units_cm),
                            fbxProperty("TimeMode", "enum", "", "", fbxTimeMode(frames_per_second)),
                            fbxProperty("TimeSpanStart", "KTime", "Time", "", int64_t{0}),
                            fbxProperty("TimeSpanStop", "KTime", "Time", "", fbxStop(figures)),
                            number("CustomFrameRate", frames_per_second)}));
    return settings;
}

FbxNode fbxDocuments(const MotionClip& clip) {
    FbxNode document("Document", int64_t{999}, "Scene", "Scene");
    document
        .add(fbxProperties({fbxProperty("SourceObject", "object", "", ""),
                            fbxProperty("ActiveAnimStackName", "KString", "", "", clip.name)}))
        .add(FbxNode("RootNode", FbxScene::kTop));
    FbxNode documents("Documents");
    documents.add(FbxNode("Count", int32_t{1})).add(std::move(document));
    return documents;
}

FbxNode fbxTakes(std::span<const Figure> figures) {
    FbxNode takes("Takes");
    takes.add(FbxNode("Current", figures[0].clip.name));
    for (const Figure& figure : figures) {
        if (figure.clip.frames.empty())
            continue;
        FbxNode take("Take", figure.clip.name);
        take.add(FbxNode("FileName", figure.clip.name + ".tak"))
            .add(FbxNode("LocalTime", int64_t{0}, fbxLastTime(figure.clip)))
            .add(FbxNode("ReferenceTime", int64_t{0}, fbxLastTime(figure.clip)));
        takes.add(std::move(take));
    }
    return takes;
}

bool isSameFigure(const Figure& a, const Figure& b) {
    const auto &joints = a.clip.skeleton.joints(), &others = b.clip.skeleton.joints();
    return std::equal(joints.begin(), joints.end(), others.begin(), others.end(),
                      [](const Joint& joint, const Joint& other) {
                          return joint.name == other.name && joint.parent == other.parent &&
                                 (joint.offset_m - other.offset_m).norm() < kSameJoint_m;
                      });
}

/// Whether the figures' motions can stand in one file.
Status checkTogether(std::span<const Figure> figures, const std::string& where) {
    const MotionClip& first = figures[0].clip;
    std::set<std::string> names;
    for (const Figure& figure : figures) {
        const MotionClip& clip = figure.clip;
        const auto refuse = [&](const std::string& why) {
            return Error{ErrorKind::kUnusable, where + ": " + clip.name + why,
                         "Write it to a file of its own"};
        };
        if (!names.insert(clip.name).second)
            return refuse(" is the name of two motions");
        if (!isSameFigure(figure, figures[0]))
            return refuse(" has other bones than " + first.name);
        if (std::abs(clip.frame_time_s / first.frame_time_s - 1) > 1e-9)
            return refuse(" has another frame rate than " + first.name);
    }
    return Done{};
}

}  // namespace

Result<std::string> formatFbx(std::span<const Figure> figures, const FbxOptions& options,
                              const std::string& where) {
    require(!figures.empty(), "formatFbx() needs a figure");
    if (const Status together = checkTogether(figures, where); !together)
        return together.error();
    const Figure& first = figures[0];
    FbxScene scene;
    const std::vector<int64_t> models = addFbxSkeleton(scene, first, options);
    addFbxBody(scene, first, options, models);
    for (const Figure& figure : figures)
        addFbxAnimation(scene, figure, options, models);
    std::vector<FbxNode> top{fbxHeader()};
    for (FbxNode& node : fbxFileIdentity())
        top.push_back(std::move(node));
    top.push_back(FbxNode("Creator", kCreator));
    top.push_back(fbxSettings(figures, options));
    top.push_back(fbxDocuments(first.clip));
    top.push_back(FbxNode("References"));
    top.push_back(scene.definitions());
    top.push_back(scene.objects());
    top.push_back(scene.connections());
    top.push_back(fbxTakes(figures));
    return fbxFile(top, where);
}

Status writeFbx(const std::string& path, std::span<const Figure> figures, const FbxOptions& options,
                bool overwrite) {
    if (Status free = checkOutputPath(path, overwrite); !free)
        return free;
    const auto bytes = formatFbx(figures, options, path);
    if (!bytes)
        return bytes.error();
    return writeFileAtomically(path, *bytes, overwrite, [&](const std::string& aside) {
        return checkScene(aside, path, SceneFormat::kFbx, figures);
    });
}

}  // namespace noctule
