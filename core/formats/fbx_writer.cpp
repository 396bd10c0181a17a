// SPDX-License-Identifier: Apache-2.0
#include "core/formats/fbx_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/formats/figures_in_file.h"
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

FbxNode fbxSettings(double frames_per_second, int64_t stop, const FbxOptions& options) {
    const auto whole = [](const char* name, int32_t value) {
        return fbxProperty(name, "int", "Integer", "", value);
    };
    const auto number = [](const char* name, double value) {
        return fbxProperty(name, "double", "Number", "", value);
    };
    const double units_cm = options.metres_per_unit * 100;
    FbxNode settings("GlobalSettings");
    settings.add(FbxNode("Version", int32_t{1000}))
        .add(fbxProperties({whole("UpAxis", 1), whole("UpAxisSign", 1), whole("FrontAxis", 2),
                            whole("FrontAxisSign", 1), whole("CoordAxis", 0), whole("CoordAxisSign", 1),
                            whole("OriginalUpAxis", 1), whole("OriginalUpAxisSign", 1),
                            number("UnitScaleFactor", units_cm), number("OriginalUnitScaleFactor", units_cm),
                            fbxProperty("TimeMode", "enum", "", "", fbxTimeMode(frames_per_second)),
                            fbxProperty("TimeSpanStart", "KTime", "Time", "", int64_t{0}),
                            fbxProperty("TimeSpanStop", "KTime", "Time", "", stop),
                            number("CustomFrameRate", frames_per_second)}));
    return settings;
}

FbxNode fbxDocuments(const std::string& first_motion) {
    FbxNode document("Document", int64_t{999}, "Scene", "Scene");
    document
        .add(fbxProperties({fbxProperty("SourceObject", "object", "", ""),
                            fbxProperty("ActiveAnimStackName", "KString", "", "", first_motion)}))
        .add(FbxNode("RootNode", FbxScene::kTop));
    FbxNode documents("Documents");
    documents.add(FbxNode("Count", int32_t{1})).add(std::move(document));
    return documents;
}

FbxNode fbxTake(const MotionClip& clip) {
    FbxNode take("Take", clip.name);
    take.add(FbxNode("FileName", clip.name + ".tak"))
        .add(FbxNode("LocalTime", int64_t{0}, fbxLastTime(clip)))
        .add(FbxNode("ReferenceTime", int64_t{0}, fbxLastTime(clip)));
    return take;
}

/// Takes figure after figure; keeps of each what stands in the file.
class FbxCollector {
public:
    FbxCollector(const FbxOptions& options, const std::string& where)
        : options_(options), where_(where), shared_(where) {}

    Status add(const Figure& figure) {
        const MotionClip& clip = figure.clip;
        const bool is_first = models_.empty(), is_character = !figure.character.empty();
        if (const Status fits = shared_.add(figure); !fits)
            return fits;
        if (is_first || is_character) {
            models_ = addFbxSkeleton(scene_, figure, options_);
            addFbxBody(scene_, figure, options_, models_);
        }
        const bool shares_stack = is_character && layer_ != 0;
        layer_ = addFbxAnimation(scene_, figure, options_, models_, is_character ? layer_ : 0);
        stop_ = std::max(stop_, fbxLastTime(clip));
        if (!clip.frames.empty() && !shares_stack)
            takes_.push_back(fbxTake(clip));
        return Done{};
    }

    /// Once, after the last figure.
    Result<std::string> file() {
        require(!models_.empty(), "an FBX file needs a figure");
        std::vector<FbxNode> top{fbxHeader()};
        for (FbxNode& node : fbxFileIdentity())
            top.push_back(std::move(node));
        FbxNode takes("Takes");
        takes.add(FbxNode("Current", shared_.first().name));
        for (FbxNode& take : takes_)
            takes.add(std::move(take));
        top.push_back(FbxNode("Creator", kCreator));
        top.push_back(fbxSettings(1 / shared_.first().frame_time_s, stop_, options_));
        top.push_back(fbxDocuments(shared_.first().name));
        top.push_back(FbxNode("References"));
        top.push_back(scene_.definitions());
        top.push_back(scene_.takeObjects());
        top.push_back(scene_.takeConnections());
        top.push_back(std::move(takes));
        return fbxFile(std::move(top), where_);
    }

private:
    const FbxOptions& options_;
    const std::string& where_;
    FbxScene scene_;
    FiguresInFile shared_;
    std::vector<int64_t> models_;
    std::vector<FbxNode> takes_;
    int64_t layer_ = 0;  ///< of the last motion
    int64_t stop_ = 0;   ///< of the longest one
};

Result<std::string> formatFbx(const FigureSource& figures, const FbxOptions& options,
                              const std::string& where, const JobContext& job) {
    FbxCollector collector(options, where);
    const Status collected = figures([&](const Figure& figure) -> Status {
        return job.cancelled() ? JobContext::cancelledError() : collector.add(figure);
    });
    if (!collected)
        return collected.error();
    return job.cancelled() ? JobContext::cancelledError() : collector.file();
}

}  // namespace

Status writeFbx(const std::string& path, const FigureSource& figures, const FbxOptions& options,
                bool overwrite, const JobContext& job) {
    if (Status free = checkOutputPath(path, overwrite); !free)
        return free;
    auto bytes = formatFbx(figures, options, path, job);
    if (!bytes)
        return bytes.error();
    const WrittenBytes written(*bytes);
    return writeFileAtomically(path, *bytes, overwrite, [&](const std::string& aside) {
        *bytes = {};  // they stand on the disk, and reading them back takes memory of its own
        if (Status kept = written.check(aside, path); !kept)
            return kept;
        return checkScene(aside, path, SceneFormat::kFbx, figures, job);
    });
}

}  // namespace noctule
