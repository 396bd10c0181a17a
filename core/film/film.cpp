// SPDX-License-Identifier: Apache-2.0
#include "core/film/film.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/job/atomic_file.h"
#include "core/media/picture_file.h"
#include "core/media/video_file.h"
#include "core/render/body_scene.h"

namespace noctule {
namespace {

// The studio's dark view.
constexpr SceneBackground kBackground{{0.063F, 0.078F, 0.102F, 1}, {0.08F, 0.1F, 0.129F, 1}};
constexpr Rgba kBodyColor{0.54F, 0.58F, 0.63F, 1}, kGridColor{0.17F, 0.2F, 0.25F, 0.9F},
    kXColor{0.95F, 0.51F, 0.42F, 0.45F}, kZColor{0.5F, 0.66F, 1, 0.45F}, kShadowColor{0, 0, 0, 0.55F};

constexpr Rgba kJointColor{0.78F, 0.82F, 0.87F, 1};
constexpr float kBoneWidth = 0.006F;  ///< of the picture's height

constexpr double kFollowed_s = 0.5;  ///< to either side: steps do not shake the camera
constexpr double kFrontElevation_rad = 0.1, kSideAzimuth_rad = 0.45, kSideElevation_rad = 0.12;
constexpr double kLeastReach_m = 0.05;  ///< of flesh around the joints
constexpr size_t kSkinnedFrames = 12;   ///< in which the flesh is measured
constexpr double kRateOff = 1e-3;       ///< containers round times
constexpr double kColorOff = 16;        ///< of 255, mean over a picture; encoders blur

Eigen::AlignedBox3d jointBox(const MotionClip& clip, size_t frame) {
    return placeBody(clip.skeleton, clip.frames[frame], {}, nullptr).box();
}

Eigen::AlignedBox3d companionBox(const FilmCompanion& companion, size_t frame) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3f& p_m : skinned(*companion.mesh, companion.skin[frame]).points_m)
        box.extend(p_m.cast<double>());
    return box;
}

/// Per frame the box around the body, in some with its companion: around its joints, wider by what the skin
/// needs in some frames.
std::vector<Eigen::AlignedBox3d> bodyBoxes(const FilmSubject& subject) {
    const MotionClip& clip = subject.clip;
    std::vector<Eigen::AlignedBox3d> boxes;
    Vector3d below = Vector3d::Constant(kLeastReach_m), above = below;
    const size_t step = std::max<size_t>(1, clip.frames.size() / kSkinnedFrames);
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        boxes.push_back(jointBox(clip, f));
        if (f % step != 0 || !subject.body.mesh())
            continue;
        Eigen::AlignedBox3d skin;
        for (const Eigen::Vector3f& p_m : skinned(*subject.body.mesh(), subject.skinMatrices(f)).points_m)
            skin.extend(p_m.cast<double>());
        below = below.cwiseMax(boxes[f].min() - skin.min());
        above = above.cwiseMax(skin.max() - boxes[f].max());
    }
    for (size_t f = 0; f < boxes.size(); ++f) {
        boxes[f] = Eigen::AlignedBox3d(Vector3d(boxes[f].min() - below), Vector3d(boxes[f].max() + above));
        if (subject.companion && f % step == 0)
            boxes[f].extend(companionBox(*subject.companion, f));
    }
    return boxes;
}

/// The root, averaged over a second, at the height of a standing body's middle.
std::vector<Vector3d> followedPoints(const MotionClip& clip, double height_m) {
    const auto reach = static_cast<size_t>(std::lround(kFollowed_s / clip.frame_time_s));
    std::vector<Vector3d> sums{Vector3d::Zero()}, points;
    for (const Pose& pose : clip.frames)
        sums.push_back(sums.back() + pose.p_world_root);
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        const size_t wide = std::min({reach, f, clip.frames.size() - 1 - f});
        Vector3d mean = (sums[f + wide + 1] - sums[f - wide]) / static_cast<double>(2 * wide + 1);
        mean.y() = height_m;
        points.push_back(mean);
    }
    return points;
}

class FilmScene {
public:
    FilmScene(const FilmSubject& subject, const FilmSettings& settings)
        : subject_(subject), settings_(settings), cameras_(cameraPath(subject, settings)) {}

    Result<Picture> draw(Offscreen& offscreen, size_t frame) const {
        return offscreen.render(scene(frame), cameras_[frame], settings_.size);
    }

private:
    Scene scene(size_t frame) const {
        const MotionClip& clip = subject_.clip;
        const Pose& pose = clip.frames[frame];
        const BodyPlaces places = placeBody(clip.skeleton, pose, {}, nullptr);
        Scene scene;
        scene.background = kBackground;
        scene.grid.emplace();
        scene.grid->centre_m = pose.p_world_root.cast<float>();
        scene.grid->line = kGridColor;
        scene.grid->axis_x = kXColor;
        scene.grid->axis_z = kZColor;
        scene.discs.push_back(softShadow(places.box(), kShadowColor));
        if (subject_.body.mesh())
            addBody(scene, subject_.body.mesh(), subject_.skinMatrices(frame), kBodyColor);
        else
            addBones(scene, places);
        if (const auto& companion = subject_.companion) {
            scene.discs.push_back(softShadow(companionBox(*companion, frame), kShadowColor));
            addBody(scene, companion->mesh, companion->skin[frame], companion->color);
        }
        return scene;
    }

    void addBody(Scene& scene, const std::shared_ptr<const SkinnedMesh>& mesh,
                 std::vector<Eigen::Matrix4f> skin, const Rgba& color) const {
        SceneBody drawn;
        drawn.mesh = mesh;
        drawn.skin = std::move(skin);
        drawn.blending = settings_.blending;
        drawn.color = color;
        scene.bodies.push_back(std::move(drawn));
    }

    /// Lines that stay as wide in the picture whatever its size.
    void addBones(Scene& scene, const BodyPlaces& places) const {
        const auto width_px = kBoneWidth * static_cast<float>(settings_.size.height_px);
        for (const BonePlace& bone : places.bones)
            scene.bones.push_back(
                {bone.from_m.cast<float>(), bone.to_m.cast<float>(), kBodyColor, width_px, false});
        for (const Vector3d& p : places.joints.p_world_joint)
            scene.joints.push_back({p.cast<float>(), width_px, kJointColor});
    }

    const FilmSubject& subject_;
    const FilmSettings& settings_;
    std::vector<Camera> cameras_;
};

Error notTheSame(const std::string& where, const std::string& what) {
    return {ErrorKind::kDisk, where + ": what was written does not read back the same (" + what + ")",
            "Check the disk and try again"};
}

/// Encoders do not say what stopped them.
bool isDiskFull(const std::string& path) {
    constexpr uintmax_t kNoRoom_bytes = 65536;
    std::error_code failed;
    const auto space = std::filesystem::space(path, failed);
    return !failed && space.available < kNoRoom_bytes;
}

/// Mean over all numbers; pictures of another size differ by all.
double difference(const Picture& a, const Picture& b) {
    if (a.rgba.size() != b.rgba.size())
        return 255;
    double sum = 0;
    for (size_t i = 0; i < a.rgba.size(); ++i)
        sum += i % 4 == 3 ? 0 : std::abs(a.rgba[i] - b.rgba[i]);
    return sum / (0.75 * static_cast<double>(a.rgba.size()));
}

/// Size, rate and number of frames, and the pictures that `drawn` knows.
Status checkPictures(const std::string& path, const std::string& where, size_t frames,
                     const FilmSettings& settings, const std::map<size_t, Picture>& drawn) {
    std::set<size_t> looked_at;
    for (const auto& [frame, picture] : drawn)
        looked_at.insert(frame);
    double largest = 0;
    const auto facts = readVideo(path, looked_at, [&](size_t frame, const Picture& picture) {
        largest = std::max(largest, difference(drawn.at(frame), picture));
    });
    if (!facts)
        return notTheSame(where, "it is no film");
    if (facts->frames != frames)
        return notTheSame(where,
                          std::to_string(facts->frames) + " frames instead of " + std::to_string(frames));
    if (facts->size.width_px != settings.size.width_px || facts->size.height_px != settings.size.height_px)
        return notTheSame(where, "another size");
    if (frames > 1 && std::abs(facts->frames_per_second / settings.frames_per_second - 1) > kRateOff)
        return notTheSame(where, "another frame rate");
    return largest <= kColorOff ? Status(Done{}) : notTheSame(where, "other pictures");
}

/// Removes what a film that came to nothing left.
struct AsideFilm {
    std::string path;
    ~AsideFilm() {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
};

}  // namespace

std::vector<Camera> cameraPath(const FilmSubject& subject, const FilmSettings& settings) {
    const MotionClip& clip = subject.clip;
    const size_t count = clip.frames.size();
    Eigen::AlignedBox3d way;
    double height_m = 0;
    for (const Eigen::AlignedBox3d& box : bodyBoxes(subject)) {
        way.extend(box);
        height_m = std::max(height_m, box.sizes().y());
    }
    Camera camera;
    if (settings.camera == CameraMove::kFront) {
        camera.azimuth_rad = 0;
        camera.elevation_rad = kFrontElevation_rad;
        camera.frame(way, settings.size);
        return std::vector<Camera>(count, camera);
    }
    camera.azimuth_rad = kSideAzimuth_rad;
    camera.elevation_rad = kSideElevation_rad;
    const Vector3d half(0.5 * height_m, 0.5 * height_m, 0.5 * height_m);
    camera.frame({Vector3d(-half), half}, settings.size, 0.02);
    std::vector<Camera> cameras;
    for (const Vector3d& point : followedPoints(clip, way.min().y() + 0.5 * way.sizes().y())) {
        camera.target_m = point;
        if (settings.camera == CameraMove::kTurn)
            camera.azimuth_rad = kSideAzimuth_rad +
                                 2 * M_PI * static_cast<double>(cameras.size()) / static_cast<double>(count);
        cameras.push_back(camera);
    }
    return cameras;
}

Status writePicture(const std::string& path, const FilmSubject& subject, size_t frame,
                    const FilmSettings& settings, bool overwrite) {
    if (const Status free = checkOutputPath(path, overwrite); !free)
        return free;
    auto offscreen = Offscreen::create();
    if (!offscreen)
        return offscreen.error();
    const MotionClip& clip = subject.clip;
    const MotionClip still{clip.name, clip.skeleton, clip.frame_time_s, {clip.frames[frame]}, {}};
    FilmSubject alone{subject.body, still};
    if (!subject.feet.empty())
        alone.feet = {subject.feet[frame]};
    if (const auto& companion = subject.companion)
        alone.companion = FilmCompanion{companion->mesh, {companion->skin[frame]}, companion->color};
    const auto picture = FilmScene(alone, settings).draw(**offscreen, 0);
    if (!picture)
        return picture.error();
    const auto bytes = pngBytes(*picture);
    if (!bytes)
        return bytes.error();
    return writeFileAtomically(path, *bytes, overwrite, [&](const std::string& aside) -> Status {
        const auto read = readPicture(aside);
        if (!read || difference(*read, *picture) > 0)
            return notTheSame(path, "other colours");
        return Done{};
    });
}

Status writeFilm(const std::string& path, const FilmSubject& subject, const FilmSettings& settings,
                 bool overwrite, const JobContext& job) {
    if (const Status free = checkOutputPath(path, overwrite); !free)
        return free;
    auto offscreen = Offscreen::create();
    if (!offscreen)
        return offscreen.error();
    const MotionClip& clip = subject.clip;
    const AsideFilm aside{asidePath(path) + std::filesystem::path(path).extension().string()};
    auto writer = VideoWriter::create(aside.path, path, settings.size, 1 / clip.frame_time_s);
    if (!writer)
        return writer.error();
    const FilmScene scene(subject, settings);
    const size_t count = clip.frames.size();
    std::map<size_t, Picture> compared;
    for (size_t f = 0; f < count; ++f) {
        if (job.cancelled())
            return JobContext::cancelledError();
        job.progress(0.95 * static_cast<double>(f) / static_cast<double>(count), "Drawing " + path);
        auto picture = scene.draw(**offscreen, f);
        if (!picture)
            return picture.error();
        (*writer)->add(*picture);
        if (f == 0 || f == count / 2 || f + 1 == count)
            compared[f] = std::move(*picture);
    }
    (*writer)->finish();
    job.progress(0.95, "Reading " + path + " again");
    FilmSettings expected = settings;
    expected.frames_per_second = 1 / clip.frame_time_s;
    if (const Status same = checkPictures(aside.path, path, count, expected, compared); !same)
        return isDiskFull(aside.path)
                   ? Error{ErrorKind::kDisk, path + ": cannot be written: No space left on device",
                           "Free some space there or choose another folder"}
                   : same.error();
    return publishFile(aside.path, path, overwrite);
}

}  // namespace noctule
