// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/mesh/rigged_mesh.h"

namespace noctule {
namespace {

Error damagedMesh(const std::string& where, const std::string& what) {
    return {ErrorKind::kUnreadable, where + ": " + what,
            "Export the mesh again; this file is damaged or was written wrongly"};
}

Error tooLarge(const std::string& where, const std::string& what, size_t count, size_t limit) {
    return {ErrorKind::kUnusable,
            where + ": " + std::to_string(count) + " " + what + "; " + std::to_string(limit) +
                " at most can be used",
            "Simplify the mesh in the program that made it"};
}

bool isPlace(const Vector3d& p_m) {
    return p_m.allFinite() && p_m.cwiseAbs().maxCoeff() <= MeshLimits::kCoordinate;
}

/// Finite, and nothing is squashed flat, so that it has an inverse.
bool isTransform(const Eigen::Matrix4d& T) {
    const double size = T.topLeftCorner<3, 3>().norm();
    return T.allFinite() && isPlace(T.topRightCorner<3, 1>()) && size > 1e-9 && size < 1e9 &&
           std::abs(T.topLeftCorner<3, 3>().determinant()) > 1e-9 * size * size * size;
}

Status checkSizes(const RiggedMesh& mesh, const std::string& where) {
    const SkinnedMesh& skin = mesh.skin;
    size_t keys = 0;
    for (const RigClip& clip : mesh.clips)
        for (const RigTrack& track : clip.tracks)
            keys += track.t_s.size();
    const struct {
        const char* what;
        size_t count, limit;
    } sizes[] = {{"vertices", skin.vertices.size(), MeshLimits::kVertices},
                 {"triangles", skin.triangles.size(), MeshLimits::kTriangles},
                 {"nodes", mesh.nodes.size(), MeshLimits::kNodes},
                 {"bones", skin.bones.size(), MeshLimits::kBones},
                 {"parts", mesh.parts.size(), MeshLimits::kParts},
                 {"materials", skin.surface.size(), MeshLimits::kLooks},
                 {"animations", mesh.clips.size(), MeshLimits::kClips},
                 {"animation keys", keys, MeshLimits::kKeys}};
    for (const auto& [what, count, limit] : sizes)
        if (count > limit)
            return tooLarge(where, what, count, limit);
    return Done{};
}

/// The picture goes into exported files as it is, decoded pixels to the graphics card.
Status checkTexture(const SurfaceTexture& texture, const std::string& where) {
    if (texture.file.size() > MeshLimits::kTextureBytes)
        return tooLarge(where, "bytes of texture", texture.file.size(), MeshLimits::kTextureBytes);
    if (!isPictureFile(texture.file))
        return damagedMesh(where, "its texture is neither PNG nor JPEG");
    const bool is_decoded = !texture.rgba.empty();
    const auto isSide = [&](int px) {
        return px >= (is_decoded ? 1 : 0) && px <= MeshLimits::kTextureSide_px;
    };
    if (!isSide(texture.width_px) || !isSide(texture.height_px) ||
        (is_decoded && texture.rgba.size() != 4 * static_cast<size_t>(texture.width_px) *
                                                  static_cast<size_t>(texture.height_px)))
        return damagedMesh(where, "its texture has another size than it says");
    return Done{};
}

Status checkTextures(const std::vector<SurfacePart>& surface, const std::string& where) {
    size_t in_files = 0, in_pixels = 0;
    for (const auto& texture : texturesOf(surface)) {
        if (const Status checked = checkTexture(*texture, where); !checked)
            return checked;
        in_files += texture->file.size();
        in_pixels += texture->rgba.size();
    }
    for (const size_t bytes : {in_files, in_pixels})
        if (bytes > MeshLimits::kTexturesBytes)
            return tooLarge(where, "bytes of textures", bytes, MeshLimits::kTexturesBytes);
    return Done{};
}

/// Parts have triangles, and follow each other from the first to the last.
Status checkLooks(const RiggedMesh& mesh, const std::string& where) {
    size_t next = 0;
    for (const SurfacePart& part : mesh.skin.surface) {
        if (part.first_triangle != next || part.triangles == 0)
            return damagedMesh(where, "its materials do not hold its triangles");
        next += part.triangles;
        if (!part.look)
            continue;
        const Eigen::Vector3f& color = part.look->base_color;
        if (!color.allFinite() || color.minCoeff() < 0 || color.maxCoeff() > 1)
            return damagedMesh(where, "its colour is none");
    }
    if (!mesh.skin.surface.empty() && next != mesh.skin.triangles.size())
        return damagedMesh(where, "its materials do not hold its triangles");
    return checkTextures(mesh.skin.surface, where);
}

Status checkNodes(const RiggedMesh& mesh, const std::string& where) {
    for (size_t n = 0; n < mesh.nodes.size(); ++n) {
        const RigNode& node = mesh.nodes[n];
        if (node.name.size() > MeshLimits::kNameBytes)
            return damagedMesh(where, "node " + std::to_string(n) + " has a name of " +
                                          std::to_string(node.name.size()) + " bytes");
        if (node.parent < -1 || node.parent >= static_cast<int>(n))
            return damagedMesh(where, "node " + node.name + " stands before its parent");
        if (!node.T_parent_node.matrix().allFinite() || !isPlace(node.T_parent_node.translation()) ||
            !node.T_world_rest.matrix().allFinite() || !isPlace(node.T_world_rest.translation()))
            return damagedMesh(where, "node " + node.name + " stands nowhere");
    }
    if (mesh.node_of_bone.size() != mesh.skin.bones.size())
        return damagedMesh(where, "bones and their nodes do not match");
    for (size_t b = 0; b < mesh.skin.bones.size(); ++b) {
        const int node = mesh.node_of_bone[b];
        if (node < 0 || node >= static_cast<int>(mesh.nodes.size()))
            return damagedMesh(where, "bone " + std::to_string(b) + " has no node");
        if (!isTransform(mesh.skin.bones[b].bind_inverse.cast<double>()))
            return damagedMesh(where, "bone " + mesh.nodes[static_cast<size_t>(node)].name +
                                          " is bound by a matrix without inverse");
    }
    return Done{};
}

Status checkVertex(const RiggedMesh& mesh, size_t v, const std::string& where) {
    const SkinnedVertex& vertex = mesh.skin.vertices[v];
    const std::string name = "vertex " + std::to_string(v);
    if (!isPlace(vertex.p_m.cast<double>()) || !vertex.normal.allFinite())
        return damagedMesh(where, name + " stands nowhere");
    if (!isOnTexture(vertex.uv))
        return damagedMesh(where, name + " has no place on its texture");
    float sum = 0;
    for (size_t i = 0; i < vertex.bones.size(); ++i) {
        if (!(vertex.weights[i] >= 0 && vertex.weights[i] <= 1.001F))
            return damagedMesh(where, name + " has a weight outside 0 to 1");
        if (mesh.isRigged() && vertex.bones[i] >= mesh.skin.bones.size())
            return damagedMesh(where, name + " hangs on a bone that does not exist");
        sum += vertex.weights[i];
    }
    if (mesh.isRigged() ? std::abs(sum - 1) > 1e-3F : sum != 0)
        return damagedMesh(where, name + " has weights that do not sum to 1");
    return Done{};
}

Status checkSurface(const RiggedMesh& mesh, const std::string& where) {
    const size_t count = mesh.skin.vertices.size();
    for (size_t v = 0; v < count; ++v)
        if (const Status vertex = checkVertex(mesh, v, where); !vertex)
            return vertex;
    for (const auto& triangle : mesh.skin.triangles)
        for (const uint32_t corner : triangle)
            if (corner >= count)
                return damagedMesh(where, "a triangle uses a vertex that does not exist");
    size_t next = 0;
    for (const MeshPart& part : mesh.parts) {
        if (part.first_triangle != next || part.name.size() > MeshLimits::kNameBytes)
            return damagedMesh(where, "its parts do not hold its triangles");
        next += part.triangles;
    }
    return next == mesh.skin.triangles.size() ? Status(Done{})
                                              : damagedMesh(where, "its parts do not hold its triangles");
}

Status checkTrack(const RiggedMesh& mesh, const RigTrack& track, const std::string& where) {
    const size_t keys = track.t_s.size();
    if (track.node < 0 || track.node >= static_cast<int>(mesh.nodes.size()) || keys == 0 ||
        track.p_m.size() != keys || track.q_parent_node.size() != keys || track.scale.size() != keys)
        return damagedMesh(where, "an animation moves a node that does not exist, or has no keys");
    for (size_t k = 0; k < keys; ++k)
        if (!std::isfinite(track.t_s[k]) || (k && track.t_s[k] <= track.t_s[k - 1]) ||
            !isPlace(track.p_m[k]) || std::abs(track.q_parent_node[k].norm() - 1) > 1e-3 ||
            !isPlace(track.scale[k]))
            return damagedMesh(where, "key " + std::to_string(k) + " of the animation of " +
                                          mesh.nodes[static_cast<size_t>(track.node)].name +
                                          " is no place or time");
    return Done{};
}

}  // namespace

bool isPictureFile(std::string_view bytes) {
    return bytes.size() <= MeshLimits::kTextureBytes &&
           (bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.starts_with("\xff\xd8\xff"));
}

bool isOnTexture(const Eigen::Vector2f& uv) {
    return uv.allFinite() && uv.cwiseAbs().maxCoeff() <= MeshLimits::kTextureRepeats;
}

Status checkRiggedMesh(const RiggedMesh& mesh, const std::string& where) {
    for (const auto check : {checkSizes, checkNodes, checkSurface, checkLooks})
        if (const Status checked = check(mesh, where); !checked)
            return checked;
    for (const RigClip& clip : mesh.clips) {
        if (clip.name.size() > MeshLimits::kNameBytes || !std::isfinite(clip.duration_s))
            return damagedMesh(where, "an animation has no usable name or length");
        for (const RigTrack& track : clip.tracks)
            if (const Status checked = checkTrack(mesh, track, where); !checked)
                return checked;
    }
    return Done{};
}

}  // namespace noctule
