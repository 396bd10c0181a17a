// SPDX-License-Identifier: Apache-2.0
// A triangle mesh whose vertices hang on the joints of a skeleton (linear blend skinning). Metres, in the
// skeleton's bind pose (see bindPose); Y up, Z forward, X to the left.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/body/skeleton.h"

namespace noctule {

struct SkinnedVertex {
    Eigen::Vector3f p_m = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
    std::array<uint16_t, 4> bones{};               ///< indices into SkinnedMesh::bones
    std::array<float, 4> weights{};                ///< sum 1; unused ones 0
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();  ///< in the texture: right and up from its lower left
};

struct SkinBone {
    std::string joint;                                           ///< canonical joint name
    Eigen::Matrix4f bind_inverse = Eigen::Matrix4f::Identity();  ///< mesh -> joint frame in the bind pose
};

/// A picture on the surface.
struct SurfaceTexture {
    std::string file;  ///< PNG or JPEG, as its file holds it
    int width_px = 0, height_px = 0;
    std::vector<uint8_t> rgba{};  ///< the same for drawing, sRGB, top row first; empty: nobody decoded it
};

/// What colours a part of the surface: the base colour, times the texture where there is one.
struct SurfaceLook {
    Eigen::Vector3f base_color{0.62F, 0.66F, 0.72F};  ///< linear
    std::shared_ptr<const SurfaceTexture> texture{};
};

/// Triangles of one look, as they follow each other.
struct SurfacePart {
    uint32_t first_triangle = 0, triangles = 0;
    std::optional<SurfaceLook> look{};  ///< absent: nobody said, colours are the viewer's
};

struct SkinnedMesh {
    std::vector<SkinnedVertex> vertices;
    std::vector<std::array<uint32_t, 3>> triangles;  ///< counter-clockwise seen from outside
    std::vector<SkinBone> bones;
    std::vector<SurfacePart> surface{};  ///< in order, all triangles; empty: one part without a look
};

/// The parts of a mesh's surface, at least one.
std::vector<SurfacePart> surfaceParts(const SkinnedMesh& mesh);

/// Each texture once, however many parts share it.
std::vector<std::shared_ptr<const SurfaceTexture>> texturesOf(const std::vector<SurfacePart>& surface);
/// Index of a part's texture in texturesOf(); absent: it has none.
std::optional<size_t> textureIndex(const SurfacePart& part,
                                   const std::vector<std::shared_ptr<const SurfaceTexture>>& textures);

/// The triangles that `keep` wants; vertices that nothing uses any more go too.
SkinnedMesh onlyTriangles(const SkinnedMesh& mesh, const std::vector<bool>& keep);

/// The zero pose with its lowest joint or tip on y = 0; root above the origin.
Pose bindPose(const Skeleton& skeleton);

/// One bone per joint, in the skeleton's order, bound in bindPose().
std::vector<SkinBone> bonesOf(const Skeleton& skeleton);

/// Index of the joint of that name, else of its nearest ancestor by canonical name, else of the root.
int nearestJoint(const Skeleton& skeleton, const std::string& joint);

/// Per bone the matrix mesh -> world: globalPose of the bone's joint times bind_inverse. A bone without a
/// joint of that name in the skeleton follows its nearest ancestor by canonical name, else the root.
std::vector<Eigen::Matrix4f> skinMatrices(const SkinnedMesh& mesh, const Skeleton& skeleton,
                                          const GlobalPose& pose);

}  // namespace noctule
