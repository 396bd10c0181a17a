// SPDX-License-Identifier: Apache-2.0
#include "core/formats/scene_check.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

#include "core/job/atomic_file.h"
#include "core/mesh/skinning.h"

namespace noctule {
namespace {

constexpr size_t kSkinFrames = 8;         ///< in which the skin is compared
constexpr double kRateOff_frames = 0.05;  ///< by the last frame

std::vector<std::string> jointNamesOf(const Skeleton& skeleton) {
    std::vector<std::string> names;
    for (const Joint& joint : skeleton.joints())
        names.push_back(joint.name);
    return names;
}

bool liesElsewhere(const SkinnedMesh& body, const SurfacePart& part, const SceneMotion& file) {
    for (size_t t = part.first_triangle; t < part.first_triangle + part.triangles; ++t)
        for (size_t i = 0; i < 3; ++i)
            if (!(file.corners[file.faces[t][i]].uv - body.vertices[body.triangles[t][i]].uv).isZero(1e-5F))
                return true;
    return false;
}

/// Colours, textures and where they lie, part by part; empty: as they should be.
std::string otherLooksThan(const SkinnedMesh& body, const SceneMotion& file) {
    const std::vector<SurfacePart> surface = surfaceParts(body);
    if (file.materials.size() != surface.size())
        return "its body has " + std::to_string(file.materials.size()) + " materials instead of " +
               std::to_string(surface.size());
    for (size_t p = 0; p < surface.size(); ++p) {
        const SceneMaterial& material = file.materials[p];
        const SurfaceLook look = surface[p].look.value_or(SurfaceLook());
        if (material.faces != surface[p].triangles)
            return "its materials cover other triangles";
        if (!(material.base_color - look.base_color).isZero(1e-5F))
            return "its body has another colour";
        if (material.texture != (look.texture ? look.texture->file : std::string()))
            return "its texture is another";
        if (look.texture && liesElsewhere(body, surface[p], file))
            return "its texture lies elsewhere";
    }
    return {};
}

/// What is wrong with the whole of it, before places are compared; empty: nothing.
std::string otherThan(const Figure& figure, const SceneMotion& file) {
    const MotionClip& wanted = figure.clip;
    const size_t frames = std::max<size_t>(1, wanted.frames.size());
    if (file.clip.frames.size() != frames)
        return "it holds " + std::to_string(file.clip.frames.size()) + " frames instead of " +
               std::to_string(frames);
    const double off_frames =
        std::abs(file.clip.frame_time_s / wanted.frame_time_s - 1) * static_cast<double>(frames - 1);
    if (off_frames > kRateOff_frames)
        return "it runs at another frame rate";
    if (figure.body && file.faces.size() != figure.body->triangles.size())
        return "its body has " + std::to_string(file.faces.size()) + " triangles instead of " +
               std::to_string(figure.body->triangles.size());
    return figure.body ? otherLooksThan(*figure.body, file) : std::string();
}

/// What is no number is larger than any.
double larger(double a, double b) {
    return std::isnan(b) ? std::numeric_limits<double>::infinity() : std::max(a, b);
}

double largestJoint_m(const Figure& figure, const SceneMotion& file, size_t frame) {
    const GlobalPose expected = globalPose(figure.clip, frame), seen = globalPose(file.clip, frame);
    double largest_m = 0;
    for (size_t j = 0; j < expected.p_world_joint.size(); ++j)
        largest_m = larger(largest_m, (seen.p_world_joint[j] - expected.p_world_joint[j]).norm());
    return largest_m;
}

/// Readers may give every triangle its own corners; so the triangles are compared, corner by corner.
double largestVertex_m(const Figure& figure, const SceneMotion& file, size_t frame) {
    const SkinnedMesh& body = *figure.body;
    const auto expected =
        skinned(body, skinMatrices(body, figure.clip.skeleton, globalPose(figure.clip, frame)));
    const std::vector<Vector3d> seen_m = file.skinned_m(frame);
    double largest_m = 0;
    for (size_t t = 0; t < body.triangles.size(); ++t)
        for (size_t i = 0; i < 3; ++i)
            largest_m = larger(
                largest_m,
                (seen_m[file.faces[t][i]] - expected.points_m[body.triangles[t][i]].cast<double>()).norm());
    return largest_m;
}

Result<SceneDifference> compareMotion(const SceneFile& scene, const std::string& where, const Figure& figure,
                                      const JobContext& job) {
    const auto file = scene.read(jointNamesOf(figure.clip.skeleton), figure.clip.name);
    if (!file)
        return file.error();
    if (const std::string wrong = otherThan(figure, *file); !wrong.empty())
        return Error{ErrorKind::kUnreadable, where + ": " + wrong, "Write the file again"};
    SceneDifference difference;
    difference.frames = file->clip.frames.size();
    difference.frames_per_second = difference.frames > 1 ? 1 / file->clip.frame_time_s : 0;
    const size_t frames = figure.clip.frames.size(), step = std::max<size_t>(1, frames / kSkinFrames);
    for (size_t f = 0; f < frames; ++f) {
        if (job.cancelled())
            return JobContext::cancelledError();
        difference.joint_m = std::max(difference.joint_m, largestJoint_m(figure, *file, f));
        if (figure.body && f % step == 0)
            difference.vertex_m = std::max(difference.vertex_m, largestVertex_m(figure, *file, f));
    }
    return difference;
}

Error notTheSame(const std::string& where, const std::string& why) {
    return {
        ErrorKind::kInternal,
        where + ": this kind of file would not hold the motion as it is (" + why + "); nothing was written",
        "Write another kind of file (GLB or FBX), and report this with the body and the take"};
}

/// "a joint is 3.2 mm off, 0.1 mm at most can be allowed"
std::string offBy(const char* what, double off_m, double limit_m) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << what << " is " << std::setprecision(2) << off_m * 1e3 << " mm off, " << limit_m * 1e3
         << " mm at most can be allowed";
    return text.str();
}

}  // namespace

double sceneLimit_m(const Figure& figure) {
    constexpr double kOfSize = 2.5e-5, kOfDistance = 1e-6;
    Eigen::AlignedBox3d body;
    for (const Vector3d& p_m : globalPose(figure.clip.skeleton, figure.rest).p_world_joint)
        body.extend(p_m);
    if (figure.body)
        for (const SkinnedVertex& vertex : figure.body->vertices)
            body.extend(vertex.p_m.cast<double>());
    double farthest_m = 0;
    for (const Pose& pose : figure.clip.frames)
        farthest_m = std::max(farthest_m, pose.p_world_root.norm());
    return kOfSize * body.diagonal().norm() + kOfDistance * farthest_m;
}

WrittenBytes::WrittenBytes(std::string_view bytes)
    : size_(bytes.size()), hash_(std::hash<std::string_view>()(bytes)) {}

Status WrittenBytes::check(const std::string& path, const std::string& where) const {
    const auto bytes = readWholeFile(path);
    if (bytes && bytes->size() == size_ && std::hash<std::string_view>()(*bytes) == hash_)
        return Done{};
    return Error{ErrorKind::kDisk, where + ": the disk does not give back the bytes that were written to it",
                 "Check the disk and try again"};
}

Result<SceneDifference> compareScene(const std::string& path, const std::string& where, SceneFormat format,
                                     const Figure& figure) {
    const auto scene = SceneFile::open(path, where, format);
    return scene ? compareMotion(*scene, where, figure, {}) : Result<SceneDifference>(scene.error());
}

Status checkScene(const std::string& path, const std::string& where, SceneFormat format,
                  const FigureSource& figures, const JobContext& job) {
    const auto scene = SceneFile::open(path, where, format);
    if (!scene)
        return notTheSame(where, scene.error().message);
    return figures([&](const Figure& figure) -> Status {
        const auto difference = compareMotion(*scene, where, figure, job);
        if (!difference)
            return difference.error().kind == ErrorKind::kCancelled
                       ? difference.error()
                       : notTheSame(where, difference.error().message);
        const double limit_m = sceneLimit_m(figure);
        for (const auto& [what, off_m] :
             {std::pair("a joint", difference->joint_m), {"the skin", difference->vertex_m}})
            if (!(off_m <= limit_m))
                return notTheSame(where, offBy(what, off_m, limit_m));
        return Done{};
    });
}

}  // namespace noctule
