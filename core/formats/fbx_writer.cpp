// SPDX-License-Identifier: Apache-2.0
#include "core/formats/fbx_writer.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/formats/scene_check.h"
#include "core/job/atomic_file.h"

namespace noctule {
namespace {

constexpr const char* kCreator = "Noctule";

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

FbxNode fbxSettings(const MotionClip& clip, const FbxOptions& options) {
    const auto whole = [](const char* name, int32_t value) {
        return fbxProperty(name, "int", "Integer", "", value);
    };
    const auto number = [](const char* name, double value) {
        return fbxProperty(name, "double", "Number", "", value);
    };
    const double units_cm = options.metres_per_unit * 100, frames_per_second = 1 / clip.frame_time_s;
    FbxNode settings("GlobalSettings");
    settings.add(FbxNode("Version", int32_t{1000}))
        .add(fbxProperties({whole("UpAxis", 1), whole("UpAxisSign", 1), whole("FrontAxis", 2),
                            whole("FrontAxisSign", 1), whole("CoordAxis", 0), whole("CoordAxisSign", 1),
                            whole("OriginalUpAxis", 1), whole("OriginalUpAxisSign", 1),
                            number("UnitScaleFactor", units_cm), number("OriginalUnitScaleFactor", units_cm),
                            fbxProperty("TimeMode", "enum", "", "", fbxTimeMode(frames_per_second)),
                            fbxProperty("TimeSpanStart", "KTime", "Time", "", int64_t{0}),
                            fbxProperty("TimeSpanStop", "KTime", "Time", "", fbxLastTime(clip)),
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

FbxNode fbxTakes(const MotionClip& clip) {
    FbxNode takes("Takes");
    takes.add(FbxNode("Current", clip.name));
    if (clip.frames.empty())
        return takes;
    FbxNode take("Take", clip.name);
    take.add(FbxNode("FileName", clip.name + ".tak"))
        .add(FbxNode("LocalTime", int64_t{0}, fbxLastTime(clip)))
        .add(FbxNode("ReferenceTime", int64_t{0}, fbxLastTime(clip)));
    takes.add(std::move(take));
    return takes;
}

}  // namespace

Result<std::string> formatFbx(const Figure& figure, const FbxOptions& options, const std::string& where) {
    FbxScene scene;
    const std::vector<int64_t> models = addFbxSkeleton(scene, figure, options);
    addFbxBody(scene, figure, options, models);
    addFbxAnimation(scene, figure, options, models);
    std::vector<FbxNode> top{fbxHeader()};
    for (FbxNode& node : fbxFileIdentity())
        top.push_back(std::move(node));
    top.push_back(FbxNode("Creator", kCreator));
    top.push_back(fbxSettings(figure.clip, options));
    top.push_back(fbxDocuments(figure.clip));
    top.push_back(FbxNode("References"));
    top.push_back(scene.definitions());
    top.push_back(scene.objects());
    top.push_back(scene.connections());
    top.push_back(fbxTakes(figure.clip));
    return fbxFile(top, where);
}

Status writeFbx(const std::string& path, const Figure& figure, const FbxOptions& options, bool overwrite) {
    if (Status free = checkOutputPath(path, overwrite); !free)
        return free;
    const auto bytes = formatFbx(figure, options, path);
    if (!bytes)
        return bytes.error();
    return writeFileAtomically(path, *bytes, overwrite, [&](const std::string& aside) {
        return checkScene(aside, path, SceneFormat::kFbx, figure);
    });
}

}  // namespace noctule
