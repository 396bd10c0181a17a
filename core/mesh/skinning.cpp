// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/skinning.h"

#include <algorithm>

#include "core/math/rotation_fit.h"

namespace noctule {
namespace {

/// Blends matrices.
struct LinearBlend {
    const std::vector<Eigen::Matrix4f>& matrices;

    void place(const SkinnedVertex& vertex, Eigen::Vector3f& p_m, Eigen::Vector3f& normal) const {
        Eigen::Matrix4f blend = vertex.weights[0] * matrices[vertex.bones[0]];
        for (size_t i = 1; i < 4 && vertex.weights[i] > 0; ++i)
            blend += vertex.weights[i] * matrices[vertex.bones[i]];
        p_m = blend.topLeftCorner<3, 3>() * vertex.p_m + blend.topRightCorner<3, 1>();
        normal = blend.topLeftCorner<3, 3>() * vertex.normal;
    }
};

/// Blends motions; quaternions on the far side of the heaviest are turned round, so that all go the short
/// way.
template <bool kStretches>
struct DualBlend {
    const std::vector<DualBone>& bones;

    void place(const SkinnedVertex& vertex, Eigen::Vector3f& p_m, Eigen::Vector3f& normal) const {
        const DualBone& first = bones[vertex.bones[0]];
        Eigen::Vector4f real = vertex.weights[0] * first.real, dual = vertex.weights[0] * first.dual;
        Eigen::Matrix3f stretch = vertex.weights[0] * first.stretch;
        for (size_t i = 1; i < 4 && vertex.weights[i] > 0; ++i) {
            const DualBone& bone = bones[vertex.bones[i]];
            const float weight = vertex.weights[i];
            const float turned = bone.real.dot(first.real) < 0 ? -weight : weight;
            real += turned * bone.real;
            dual += turned * bone.dual;
            if constexpr (kStretches)
                stretch += weight * bone.stretch;
        }
        const float norm_squared = real.squaredNorm();
        const Eigen::Vector3f r = real.head<3>(), d = dual.head<3>();
        const auto turn = [&](const Eigen::Vector3f& v) -> Eigen::Vector3f {
            return v + (2 / norm_squared) * r.cross(r.cross(v) + real.w() * v);
        };
        const Eigen::Vector3f move = (2 / norm_squared) * (real.w() * d - dual.w() * r + r.cross(d));
        p_m = turn(kStretches ? Eigen::Vector3f(stretch * vertex.p_m) : vertex.p_m) + move;
        normal = turn(kStretches ? Eigen::Vector3f(stretch * vertex.normal) : vertex.normal);
    }
};

template <class Blend>
PosedSurface blended(const SkinnedMesh& mesh, const Blend& blend) {
    PosedSurface surface;
    surface.points_m.resize(mesh.vertices.size());
    surface.normals.resize(mesh.vertices.size());
    for (size_t v = 0; v < mesh.vertices.size(); ++v) {
        Eigen::Vector3f normal;
        blend.place(mesh.vertices[v], surface.points_m[v], normal);
        surface.normals[v] = normal.normalized();
    }
    return surface;
}

DualBone dualBoneOf(const Eigen::Matrix4f& matrix) {
    const Eigen::Matrix3d linear = matrix.topLeftCorner<3, 3>().cast<double>();
    const Matrix3d turn = nearestRotation(linear.determinant() < 0 ? Matrix3d(-linear) : linear);
    DualBone bone;
    const Eigen::Quaternionf q(Eigen::Quaterniond(turn).cast<float>());
    const Eigen::Vector3f t = matrix.topRightCorner<3, 1>();
    bone.real = q.coeffs();
    bone.dual = 0.5F * (Eigen::Quaternionf(0, t.x(), t.y(), t.z()) * q).coeffs();
    if ((linear - turn).norm() > 1e-5)  // what rounding leaves is no stretch
        bone.stretch = (turn.transpose() * linear).cast<float>();
    return bone;
}

}  // namespace

std::vector<DualBone> dualBones(const std::vector<Eigen::Matrix4f>& skin_matrices) {
    std::vector<DualBone> bones;
    bones.reserve(skin_matrices.size());
    for (const Eigen::Matrix4f& matrix : skin_matrices)
        bones.push_back(dualBoneOf(matrix));
    return bones;
}

PosedSurface skinned(const SkinnedMesh& mesh, const std::vector<Eigen::Matrix4f>& skin_matrices,
                     Blending blending) {
    require(skin_matrices.size() == mesh.bones.size() && !mesh.bones.empty(),
            "skinned() needs one matrix per bone");
    if (blending == Blending::kLinear)
        return blended(mesh, LinearBlend{skin_matrices});
    const std::vector<DualBone> bones = dualBones(skin_matrices);
    const bool stretches = std::any_of(bones.begin(), bones.end(),
                                       [](const DualBone& bone) { return !bone.stretch.isIdentity(0); });
    return stretches ? blended(mesh, DualBlend<true>{bones}) : blended(mesh, DualBlend<false>{bones});
}

}  // namespace noctule
