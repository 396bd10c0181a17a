// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/mannequin/mannequin.h"

#include <cmath>

#include "core/mesh/mannequin/decimation.h"
#include "core/mesh/mannequin/implicit_body.h"
#include "core/mesh/mannequin/mannequin_weights.h"
#include "core/mesh/mannequin/surface_nets.h"
#include "core/mesh/retarget/fit_mesh.h"

namespace noctule {
namespace {

constexpr double kCell_m = 0.004;
constexpr size_t kTrianglesPerHalf = 5900;
constexpr int kRelaxationRounds = 6;
/// Normals are taken over this much: creases narrower than a triangle would only speckle.
constexpr double kShading_m = 0.010, kDetailShading_m = 0.003;

std::vector<Part> allParts() {
    std::vector<Part> parts;
    for (const auto& of_region :
         {trunkParts(), legParts(), footParts(), armParts(), handParts(), headParts()})
        parts.insert(parts.end(), of_region.begin(), of_region.end());
    return parts;
}

/// Hands, feet and the head are looked at more closely than the rest.
double importance(const Vector3d& p_m) {
    const bool hand = std::abs(p_m.x()) > 0.72, foot = p_m.y()<0.07, head = p_m.y()> 1.50;
    return hand || foot ? 8 : head ? 5 : 1;
}

/// Points move towards the middle of their neighbours and back onto the surface: even triangles.
void relax(TriangleMesh& mesh, const ImplicitBody& body) {
    const size_t count = mesh.points.size();
    for (int round = 0; round < kRelaxationRounds; ++round) {
        std::vector<Vector3d> sum(count, Vector3d::Zero());
        std::vector<int> neighbours(count, 0);
        for (const auto& t : mesh.triangles)
            for (size_t i = 0; i < 3; ++i) {
                sum[t[i]] += mesh.points[t[(i + 1) % 3]] + mesh.points[t[(i + 2) % 3]];
                neighbours[t[i]] += 2;
            }
        for (size_t i = 0; i < count; ++i) {
            Vector3d& p = mesh.points[i];
            const bool border = p.x() == 0;
            p = body.onSurface(0.7 * p + 0.3 * sum[i] / neighbours[i]);
            if (border)
                p.x() = 0;
        }
    }
}

SkinnedMesh hung(const TriangleMesh& surface, const ImplicitBody& body, const Skeleton& skeleton) {
    const GlobalPose global = globalPose(skeleton, bindPose(skeleton));
    SkinnedMesh mesh;
    mesh.triangles = surface.triangles;
    for (const Vector3d& p_m : surface.points) {
        const double step_m = importance(p_m) > 1 ? kDetailShading_m : kShading_m;
        const BoneWeights weights = mannequinWeights(skeleton, global, p_m);
        mesh.vertices.push_back(
            {p_m.cast<float>(), body.normal(p_m, step_m).cast<float>(), weights.bones, weights.weights});
    }
    mesh.bones = bonesOf(skeleton);
    return mesh;
}

}  // namespace

SkinnedMesh makeMannequin(const Actor& actor) {
    const Skeleton skeleton = defaultActor().skeleton;
    const ImplicitBody body(allParts(), skeleton, bindPose(skeleton).p_world_root.y());
    TriangleMesh half = decimated(polygoniseHalf(body, kCell_m), kTrianglesPerHalf, importance);
    relax(half, body);
    return fitted(hung(mirrored(half), body, skeleton), skeleton, actor.skeleton);
}

}  // namespace noctule
