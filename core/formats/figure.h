// SPDX-License-Identifier: Apache-2.0
// A body in motion as scene files (FBX, glTF) hold it: a tree of joints, their motion and, unless only the
// skeleton is wanted, the skin that hangs on them. Metres, Y up, facing +Z.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/skinned_mesh.h"
#include "core/motion/clip.h"

namespace noctule {

struct Figure {
    MotionClip clip;  ///< its name is the animation's; without frames the figure stands in its bind pose
    std::optional<SkinnedMesh> body;  ///< one bone per joint, of the same name
    /// In which the skin is bound and the joints stand in the file: bindPose() unless its rig is another's.
    Pose rest;
    /// Per frame one value per joint, 0..1: how far its rotation can be trusted. Empty: not known.
    std::vector<std::vector<float>> confidence;
    /// Whose body it is where a file holds several; its joints are called "A:Hips". Empty: it is the only
    /// one.
    std::string character{};
};

/// The same skeleton, and the same figure, as one of several in a file.
Skeleton skeletonOfCharacter(const Skeleton& skeleton, const std::string& character);
Figure asCharacter(Figure figure, const std::string& character);
/// "A" of the joint "A:Hips"; empty where a joint belongs to the only figure.
std::string_view characterOf(std::string_view joint);

/// The figures of one file, for writers and checks that look at one after the other: hands each to `visit`,
/// the same ones in the same order whenever it is called, and ends with the first Error, its own or the
/// visitor's. So nobody has to hold more than one at a time.
using FigureVisit = std::function<Status(const Figure&)>;
using FigureSource = std::function<Status(const FigureVisit& visit)>;

/// Of figures that are there, and stay so.
FigureSource sourceOf(std::span<const Figure> figures);

/// Whose names joints carry in a file.
enum class JointNames {
    kOwn,      ///< canonical: "Chest", "LeftForeArm"
    kHumanIk,  ///< MotionBuilder and Maya: "Spine2"
};

/// The name that a joint has in a file; its own where the other program knows none.
std::string exportedName(const Joint& joint, JointNames names);
/// The same skeleton under other names.
Skeleton renamed(const Skeleton& skeleton, JointNames names);

/// kUnusable, and names frame and joint, when the clip holds anything that is not finite.
Status checkFinite(const MotionClip& clip);

/// Bones that the clip's skeleton has no joint for are folded into the nearest one above them; then joints
/// and bones get their names. kUnusable when the clip holds anything that is not finite.
Result<Figure> makeFigure(MotionClip clip, std::optional<SkinnedMesh> body, JointNames names);

/// "png" or "jpg".
std::string textureEnding(const SurfaceTexture& texture);

/// Of the mesh: "Body", as one of several "A:Body".
std::string bodyName(const Figure& figure);

/// Of the body's first, second... material or texture: "Body", "Body_2". Programs that put textures beside
/// the file need one name for each.
std::string surfaceName(size_t index);

/// How much a vertex hangs on a bone in all; one bone may be named twice. 0: not at all.
float weightOn(const SkinnedVertex& vertex, size_t bone);

/// A name for something beside the joints, such as the node above them: `wanted`, with underscores until no
/// joint has it.
std::string nameBesideJoints(const Skeleton& skeleton, std::string wanted);

/// Where a joint stands in its parent's frame, of the root in the world.
Vector3d localPosition_m(const MotionClip& clip, size_t frame, size_t joint);
/// Whether that changes from frame to frame.
bool jointIsMoved(const MotionClip& clip, size_t joint);

}  // namespace noctule
