// SPDX-License-Identifier: Apache-2.0
// Any mesh as another program made it: its tree of nodes, the skin that hangs on them (none: an unrigged
// mesh) and its animations. Metres, Y up; forward as the file says (Z where it says nothing), and where the
// file stands on the ground stays.
//
// The rest pose is the one in which the skin is bound; nodes that bind nothing stand there as the file's own
// pose has them relative to their parents. Node transforms may hold scale, so poses are matrices.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/job/result.h"
#include "core/mesh/skinned_mesh.h"

namespace noctule {

struct RigNode {
    std::string name;
    int parent = -1;  ///< before this node in the list; -1: a root
    Eigen::Affine3d T_parent_node = Eigen::Affine3d::Identity();  ///< as the file stands
    Eigen::Affine3d T_world_rest = Eigen::Affine3d::Identity();   ///< in the rest pose
};

/// How one node moves; keys at increasing times.
struct RigTrack {
    int node = 0;
    std::vector<double> t_s;
    std::vector<Vector3d> p_m;  ///< in the parent's frame
    std::vector<Quaterniond> q_parent_node;
    std::vector<Vector3d> scale;
};

struct RigClip {
    std::string name;
    double duration_s = 0;
    std::vector<RigTrack> tracks;
};

/// A named piece of the mesh: an object or group of the file.
struct MeshPart {
    std::string name;
    uint32_t first_triangle = 0, triangles = 0;
};

struct RiggedMesh {
    std::vector<RigNode> nodes;
    /// In the rest pose; bones carry the names of their nodes. Without bones all weights are zero.
    SkinnedMesh skin;
    std::vector<int> node_of_bone;
    std::vector<MeshPart> parts;  ///< in order, all triangles
    std::vector<RigClip> clips;
    /// Canonical joint -> name of its node, where the file itself says so (VRM); else empty.
    std::map<std::string, std::string> humanoid{};

    bool isRigged() const { return !skin.bones.empty(); }
    /// Index of the first node of that name, or -1.
    int find(const std::string& name) const;
};

/// What a mesh may hold at most, so that a damaged file cannot ask for all memory.
struct MeshLimits {
    static constexpr size_t kVertices = 2'000'000, kTriangles = 4'000'000, kNodes = 8192, kBones = 4096;
    static constexpr size_t kParts = 65'536, kClips = 1024, kKeys = 20'000'000, kNameBytes = 512;
    static constexpr size_t kLooks = 256;
    static constexpr size_t kTextureBytes = 64'000'000;
    static constexpr size_t kTexturesBytes = 256'000'000;  ///< of all files together, and of all pixels
    static constexpr int kTextureSide_px = 2048;           ///< decoded ones are made smaller
    static constexpr double kCoordinate = 1e6;             ///< metres
    static constexpr float kTextureRepeats = 1e4F;  ///< how far from the texture its coordinates may lie
};

/// Everything the other functions of this room and the formats rely on: indices within range, parents first,
/// finite numbers, weights that sum to 1, times that increase, parts that hold all triangles one after the
/// other, colours from 0 to 1, textures that are pictures of the size they say. `where` names the file.
/// kUnreadable: damaged; kUnusable: too large.
Status checkRiggedMesh(const RiggedMesh& mesh, const std::string& where);

/// Whether bytes begin as PNG or JPEG and are no more than MeshLimits::kTextureBytes.
bool isPictureFile(std::string_view bytes);
/// Whether texture coordinates are numbers within MeshLimits::kTextureRepeats.
bool isOnTexture(const Eigen::Vector2f& uv);

/// World transform of every node.
using RigPose = std::vector<Eigen::Affine3d>;

RigPose restPose(const RiggedMesh& mesh);
/// Of local transforms, one per node.
RigPose posed(const RiggedMesh& mesh, const std::vector<Eigen::Affine3d>& T_parent_node);
/// A clip at a time, clamped to its ends: straight lines between keys, slerp for rotations. Nodes without a
/// track stand as in the file.
RigPose posed(const RiggedMesh& mesh, const RigClip& clip, double t_s);

/// Per bone the matrix mesh -> world.
std::vector<Eigen::Matrix4f> skinMatrices(const RiggedMesh& mesh, const RigPose& pose);

/// The surface alone on one bone that stands still (skin matrix: identity), for looking at it.
SkinnedMesh standingSurface(const SkinnedMesh& skin);

/// The parts that `keep` wants; vertices that nothing uses any more go too.
RiggedMesh withParts(const RiggedMesh& mesh, const std::vector<bool>& keep);

}  // namespace noctule
