// SPDX-License-Identifier: Apache-2.0
// What a scene file (FBX, GLB) holds of a known body, read through assimp: the joints that were asked for,
// with their rest places and motion, and the skin that hangs on them. For looking again at what was written;
// meshes of other programs come in through core/mesh.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/motion/clip.h"

namespace Assimp {
class Importer;
}

namespace noctule {

enum class SceneFormat { kFbx, kGlb };

struct SceneCorner {
    Vector3d p_m = Vector3d::Zero();
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();
    std::vector<std::pair<size_t, double>> weights;  ///< joint, weight
};

/// Faces of one material, as they follow each other.
struct SceneMaterial {
    size_t faces = 0;
    Eigen::Vector3f base_color = Eigen::Vector3f::Zero();
    std::string texture;  ///< the picture within the file; empty: none
};

struct SceneMotion {
    MotionClip clip;  ///< in the order of the joints asked for; metres by what the file says of its unit
    std::vector<SceneCorner> corners;            ///< of all meshes with a skin
    std::vector<std::array<uint32_t, 3>> faces;  ///< of corners
    std::vector<Eigen::Matrix4d> bind_inverse;   ///< per joint, metres; as the file says
    std::vector<SceneMaterial> materials;        ///< all faces

    /// The skin in a frame, one point per corner, world.
    std::vector<Vector3d> skinned_m(size_t frame) const;
};

class SceneFile {
public:
    /// kUnreadable when assimp cannot read the file; `where` names it in errors.
    static Result<SceneFile> open(const std::string& path, const std::string& where, SceneFormat format);
    SceneFile(SceneFile&&) noexcept;
    SceneFile& operator=(SceneFile&&) noexcept;
    ~SceneFile();

    /// Joints by name, with the motion of that name (empty: the first); kUnreadable when a joint or that
    /// motion is missing, when keys are not one to a frame at equal steps, or when Y is not up.
    Result<SceneMotion> read(const std::vector<std::string>& joints, const std::string& motion = {}) const;

private:
    SceneFile(std::unique_ptr<Assimp::Importer> importer, std::string where);
    std::unique_ptr<Assimp::Importer> importer_;  ///< keeps what it has read
    std::string where_;
};

}  // namespace noctule
