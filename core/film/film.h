// SPDX-License-Identifier: Apache-2.0
// A moving body as a picture or a film, drawn without a window: the same renderer as the studio's view, a
// body (or where there is none the skeleton), its shadow and the ground. Written aside, read again and
// compared before the file gets its name.
#pragma once

#include <string>

#include "core/mesh/retarget/moving_body.h"
#include "core/motion/clip.h"
#include "core/render/offscreen.h"

namespace noctule {

enum class CameraMove {
    kFront,   ///< stands before the performer and sees the whole way
    kFollow,  ///< goes along, from a little to the performer's left
    kTurn,    ///< goes along and once around the performer
};

struct FilmSettings {
    PictureSize size{1280, 720};
    CameraMove camera = CameraMove::kFront;
    double frames_per_second = 30;  ///< of a film
    Blending blending = Blending::kLinear;

    bool operator==(const FilmSettings&) const = default;
};

/// What moves beside the performer and is no performer.
struct FilmCompanion {
    std::shared_ptr<const SkinnedMesh> mesh;
    std::vector<std::vector<Eigen::Matrix4f>> skin;  ///< per frame and bone, mesh -> world
    Rgba color;
};

/// Who is seen and what they do.
struct FilmSubject {
    const MovingBody& body;  ///< one without a mesh is shown as its skeleton
    const MotionClip& clip;
    std::vector<FootCorrections> feet{};  ///< per frame (MovingBody::lockedFeet); empty: none
    std::optional<FilmCompanion> companion{};

    std::vector<Eigen::Matrix4f> skinMatrices(size_t frame) const {
        return body.skinMatrices(clip.frames[frame], feet.empty() ? FootCorrections() : feet[frame]);
    }
};

/// Where the camera is in every frame; at least one frame. Deterministic.
std::vector<Camera> cameraPath(const FilmSubject& subject, const FilmSettings& settings);

/// One frame of the clip as PNG; the camera stands as for that pose alone. kUnusable without OpenGL; kUsage
/// and kDisk as writeFileAtomically().
Status writePicture(const std::string& path, const FilmSubject& subject, size_t frame,
                    const FilmSettings& settings, bool overwrite);

/// The whole clip; its frames are those of the film, whatever the settings' rate. Besides, as VideoWriter.
Status writeFilm(const std::string& path, const FilmSubject& subject, const FilmSettings& settings,
                 bool overwrite, const JobContext& job);

}  // namespace noctule
