// SPDX-License-Identifier: Apache-2.0
#include "core/formats/figure.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

constexpr char kCharacterEnd = ':';  // as namespaces of MotionBuilder and Maya end

/// The same body with exactly the skeleton's joints as its bones.
SkinnedMesh onJointsOf(const Skeleton& skeleton, const SkinnedMesh& body) {
    SkinnedMesh result = body;
    result.bones = bonesOf(skeleton);
    for (SkinnedVertex& vertex : result.vertices)
        for (uint16_t& bone : vertex.bones)
            bone = static_cast<uint16_t>(nearestJoint(skeleton, body.bones[bone].joint));
    for (const SkinBone& bone : body.bones)
        if (const int joint = skeleton.find(bone.joint); joint >= 0)
            result.bones[static_cast<size_t>(joint)].bind_inverse = bone.bind_inverse;
    return result;
}

}  // namespace

FigureSource sourceOf(std::span<const Figure> figures) {
    return [figures](const FigureVisit& visit) -> Status {
        for (const Figure& figure : figures)
            if (Status visited = visit(figure); !visited)
                return visited;
        return Done{};
    };
}

Status checkFinite(const MotionClip& clip) {
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        const GlobalPose global = globalPose(clip, f);
        for (size_t j = 0; j < global.p_world_joint.size(); ++j)
            if (!global.p_world_joint[j].allFinite() || !global.q_world_joint[j].coeffs().allFinite())
                return Error{ErrorKind::kUnusable,
                             clip.name + ": frame " + std::to_string(f + 1) + " of joint " +
                                 clip.skeleton.joints()[j].name + " is not a finite number",
                             "Process the take again or leave this part out"};
    }
    return Done{};
}

std::string exportedName(const Joint& joint, JointNames names) {
    const auto alias = joint.aliases.find("humanik");
    return names == JointNames::kHumanIk && alias != joint.aliases.end() ? alias->second : joint.name;
}

Skeleton renamed(const Skeleton& skeleton, JointNames names) {
    std::vector<Joint> joints = skeleton.joints();
    for (Joint& joint : joints)
        joint.name = exportedName(joint, names);
    auto made = Skeleton::make(std::move(joints));
    return made ? std::move(*made) : skeleton;  // a performer's own aliases may name two joints alike
}

Skeleton skeletonOfCharacter(const Skeleton& skeleton, const std::string& character) {
    std::vector<Joint> joints = skeleton.joints();
    for (Joint& joint : joints)
        joint.name = character + kCharacterEnd + joint.name;
    return std::move(Skeleton::make(std::move(joints)).value());
}

Figure asCharacter(Figure figure, const std::string& character) {
    figure.character = character;
    figure.clip.skeleton = skeletonOfCharacter(figure.clip.skeleton, character);
    for (int j = 0; figure.body && j < figure.clip.skeleton.size(); ++j)
        figure.body->bones[static_cast<size_t>(j)].joint = figure.clip.skeleton.joint(j).name;
    return figure;
}

std::string_view characterOf(std::string_view joint) {
    const size_t end = joint.find(kCharacterEnd);
    return end == std::string_view::npos ? std::string_view() : joint.substr(0, end);
}

Result<Figure> makeFigure(MotionClip clip, std::optional<SkinnedMesh> body, JointNames names) {
    if (Status finite = checkFinite(clip); !finite)
        return finite.error();
    Figure figure{std::move(clip), std::nullopt, {}, {}};
    figure.rest = bindPose(figure.clip.skeleton);
    if (body)
        figure.body = onJointsOf(figure.clip.skeleton, *body);
    figure.clip.skeleton = renamed(figure.clip.skeleton, names);
    for (int j = 0; figure.body && j < figure.clip.skeleton.size(); ++j)
        figure.body->bones[static_cast<size_t>(j)].joint = figure.clip.skeleton.joint(j).name;
    return figure;
}

std::string textureEnding(const SurfaceTexture& texture) {
    return texture.file.starts_with("\x89PNG") ? "png" : "jpg";
}

std::string bodyName(const Figure& figure) {
    return (figure.character.empty() ? "" : figure.character + kCharacterEnd) + "Body";
}

std::string surfaceName(size_t index) {
    return index == 0 ? "Body" : "Body_" + std::to_string(index + 1);
}

float weightOn(const SkinnedVertex& vertex, size_t bone) {
    float weight = 0;
    for (size_t i = 0; i < vertex.bones.size(); ++i)
        if (vertex.bones[i] == bone)
            weight += vertex.weights[i];
    return weight;
}

std::string nameBesideJoints(const Skeleton& skeleton, std::string wanted) {
    while (skeleton.find(wanted) >= 0)
        wanted += '_';
    return wanted;
}

Vector3d localPosition_m(const MotionClip& clip, size_t frame, size_t joint) {
    if (joint == 0)
        return clip.frames[frame].p_world_root;
    return clip.p_parent_joint_m.empty() ? clip.skeleton.joints()[joint].offset_m
                                         : clip.p_parent_joint_m[frame][joint];
}

bool jointIsMoved(const MotionClip& clip, size_t joint) {
    return joint == 0 || !clip.p_parent_joint_m.empty();
}

}  // namespace noctule
