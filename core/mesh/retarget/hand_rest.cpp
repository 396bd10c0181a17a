// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/retarget/hand_rest.h"

#include <cmath>

#include "core/mesh/rig/rig_tree.h"

namespace noctule {
namespace {

double angleOf(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Where each branch below the hand ends: the place farthest from the wrist.
std::vector<Vector3d> fingerEnds(const RiggedMesh& mesh, int hand) {
    const std::vector<int> fingers = childrenOf(mesh)[static_cast<size_t>(hand)];
    const Vector3d wrist = mesh.nodes[static_cast<size_t>(hand)].T_world_rest.translation();
    std::vector<Vector3d> ends;
    for (const int finger : fingers) {
        Vector3d end = Vector3d::Zero();
        for (size_t n = static_cast<size_t>(finger); n < mesh.nodes.size(); ++n)
            if (const Vector3d p = mesh.nodes[n].T_world_rest.translation() - wrist;
                hangsOn(mesh, static_cast<int>(n), finger) && p.norm() > end.norm())
                end = p;
        if (end.norm() > 1e-6)
            ends.push_back(end);
    }
    return ends;
}

}  // namespace

HandRest handAtRest(const RiggedMesh& mesh, int hand, const Vector3d& forearm) {
    constexpr double kStandsApart_rad = radians(12);  // from the finger next to it
    HandRest rest;
    const std::vector<Vector3d> ends = fingerEnds(mesh, hand);
    if (ends.size() < 2)
        return rest;
    size_t thumb = 0;
    for (size_t i = 1; i < ends.size(); ++i)
        if (angleOf(ends[i], forearm) > angleOf(ends[thumb], forearm))
            thumb = i;
    double nearest = 1e9;
    for (size_t i = 0; i < ends.size(); ++i)
        if (i != thumb) {
            nearest = std::min(nearest, angleOf(ends[i], ends[thumb]));
            if (ends.size() > 3)
                rest.along += ends[i].normalized();
        }
    if (nearest > kStandsApart_rad)
        rest.thumb = ends[thumb];
    return rest;
}

}  // namespace noctule
