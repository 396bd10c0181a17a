// SPDX-License-Identifier: Apache-2.0
// Motion files of any kind as a BvhDocument, the form in which core/figure understands them. BVH is read as
// it is. Of FBX, glTF, GLB, VRM and Collada the animation of the skeleton is sampled; metres, Y up, every
// joint with positions, since such files may move any bone.
#pragma once

#include <string>

#include "core/formats/bvh.h"
#include "core/mesh/rigged_mesh.h"

namespace noctule {

/// By the name's ending; scenes are read in a process of their own (core/mesh/import/mesh_reader.h).
/// `warnings` of the document say which of several animations was taken.
Result<BvhDocument> readMotionDocument(const std::string& path, const JobContext& job = {});

/// Whether a file's name ends as one of the kinds that readMotionDocument() reads.
bool isMotionFileName(const std::string& path);

/// The animation that moves most bones, the longest among equals, at the rate of its keys (10 to 240 frames
/// per second). kUnusable: no animation, or one that would take more than the limits of a take.
Result<BvhDocument> sampledMotion(const RiggedMesh& mesh, const std::string& where);

}  // namespace noctule
