// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/retarget/retarget.h"

#include <algorithm>
#include <cmath>

#include "core/body/joint_names.h"
#include "core/math/rotation.h"
#include "core/mesh/retarget/foot_skin.h"
#include "core/mesh/retarget/hand_rest.h"
#include "core/mesh/rig/other_skeletons.h"
#include "core/mesh/rig/rig_tree.h"

namespace noctule {
namespace {

/// What aligns rest poses: joints whose bone must point the same way, and where that bone ends.
struct LimbBone {
    const char *joint, *end, *above;  ///< "above": the limb bone whose alignment it starts from
};
constexpr LimbBone kLimbBones[] = {{"Arm", "ForeArm", ""},
                                   {"ForeArm", "Hand", "Arm"},
                                   {"Hand", "", "ForeArm"},
                                   {"UpLeg", "Leg", ""},
                                   {"Leg", "Foot", "UpLeg"}};

/// Of the default body in its zero pose: palms down, thumbs forward and a little down.
const Vector3d kOurThumb(0, -0.25, 1);
constexpr double kMostPalm_rad = radians(110);  ///< rest poses differ by less

constexpr double kToes_m = 0.13;  ///< from ankle to toes, of a skeleton without toes

/// Below the ankle and at the toes, both on the ground.
std::array<Vector3d, 2> solePoints(const Vector3d& ankle, const Vector3d& toes, double ground) {
    return {Vector3d(ankle.x(), ground, ankle.z()), Vector3d(toes.x(), ground, toes.z())};
}

class RestPoses {
public:
    RestPoses(const RiggedMesh& target, const BoneMap& map, const Skeleton& source, const FeetAtRest& feet)
        : target_(target),
          map_(map),
          source_(source),
          feet_(feet),
          zero_(globalPose(source, source.zeroPose())) {}

    bool has(const std::string& joint) const { return map_.node_of_joint.contains(joint); }
    int node(const std::string& joint) const { return target_.find(map_.node_of_joint.at(joint)); }
    Vector3d theirs(const std::string& joint) const {
        return target_.nodes[static_cast<size_t>(node(joint))].T_world_rest.translation();
    }
    Vector3d ours_m(const std::string& joint) const {
        return zero_.p_world_joint[static_cast<size_t>(findByAnyName(source_, joint))];
    }

    double legLength(bool of_target) const {
        const auto at = [&](const std::string& joint) { return of_target ? theirs(joint) : ours_m(joint); };
        double sum = 0;
        for (const std::string side : {"Left", "Right"})
            sum += (at(side + "UpLeg") - at(side + "Leg")).norm() +
                   (at(side + "Leg") - at(side + "Foot")).norm();
        return sum / 2;
    }

    /// From the target's world to ours: upright, and facing forward. What leans less than a rest pose may is
    /// left as it stands.
    Matrix3d facing() const {
        const Vector3d left =
            theirs("LeftUpLeg") - theirs("RightUpLeg") + theirs("LeftArm") - theirs("RightArm");
        const Vector3d up_seen =
            theirs("LeftArm") + theirs("RightArm") - theirs("LeftUpLeg") - theirs("RightUpLeg");
        const bool upright = up_seen.normalized().y() > std::cos(radians(30));
        const Vector3d up = upright ? Vector3d(Vector3d::UnitY()) : Vector3d(up_seen.normalized());
        const Vector3d forward = left.cross(up).normalized();
        if (upright && forward.z() > std::cos(radians(15)))
            return Matrix3d::Identity();
        Matrix3d R;
        R << up.cross(forward).transpose(), up.transpose(), forward.transpose();
        return R;
    }

    /// Per joint the rotation from the target's rest to our zero pose.
    std::map<std::string, Matrix3d> alignments() const {
        const Matrix3d base = facing();
        std::map<std::string, Matrix3d> aligned;
        for (const auto& [joint, node] : map_.node_of_joint)
            aligned[joint] = base;
        for (const std::string side : {"Left", "Right"}) {
            for (const LimbBone& bone : kLimbBones)
                align(side, bone, aligned);
            turnPalm(side, aligned);
            for (const std::string& joint : {side + "Foot", side + "ToeBase"})
                if (aligned.contains(joint))
                    aligned.at(joint) = fromFlat(side) * base;
        }
        return aligned;
    }

    /// Both soles lying flat: theirs where they stand at rest, ours in the frame of our foot.
    struct Soles {
        std::array<Vector3d, 2> theirs, ours_m;
    };
    Soles soles(const std::string& side, const Matrix3d& R_ours_theirs, double ground) const {
        const std::string toe = side + "ToeBase";
        const Matrix3d R_foot_flat = fromFlat(side);
        const Vector3d p_toes = R_foot_flat.transpose() * toesOf(side);
        const Vector3d p_ankle = R_ours_theirs * theirs(side + "Foot");
        const double scale = legLength(true) / legLength(false);
        const Vector3d p_tip =
            has(toe) ? Vector3d(R_ours_theirs * theirs(toe)) : Vector3d(p_ankle + scale * p_toes);
        Soles made{solePoints(p_ankle, p_tip, ground),
                   solePoints(Vector3d::Zero(), p_toes, lowestOf(side, R_foot_flat.transpose()))};
        for (Vector3d& p : made.theirs)
            p = R_ours_theirs.transpose() * p;
        for (Vector3d& p_m : made.ours_m)
            p_m = R_foot_flat * p_m;
        return made;
    }

private:
    /// From our foot lying flat to where it is in our zero pose.
    Matrix3d fromFlat(const std::string& side) const {
        return smallestRotation(Vector3d::UnitY(), feet_.up[side == "Left" ? 0 : 1]).toRotationMatrix();
    }

    /// From our ankle to the toes, in the frame of our foot.
    Vector3d toesOf(const std::string& side) const {
        const int toes = findByAnyName(source_, side + "ToeBase");
        return toes >= 0 ? source_.joint(toes).offset_m : Vector3d(kToes_m * Vector3d::UnitZ());
    }

    /// The height of what our sole lies on above the ankle: the lowest joint or tip of our foot when turned.
    double lowestOf(const std::string& side, const Matrix3d& turn) const {
        const Joint& foot = source_.joint(findByAnyName(source_, side + "Foot"));
        double low = std::min(0.0, (turn * foot.end_m.value_or(Vector3d::Zero())).y());
        if (const int toes = findByAnyName(source_, side + "ToeBase"); toes >= 0) {
            const Joint& joint = source_.joint(toes);
            low = std::min({low, (turn * joint.offset_m).y(),
                            (turn * (joint.offset_m + joint.end_m.value_or(Vector3d::Zero()))).y()});
        }
        return low;
    }

    void align(const std::string& side, const LimbBone& bone,
               std::map<std::string, Matrix3d>& aligned) const {
        Matrix3d& mine = aligned.at(side + bone.joint);
        if (*bone.above)
            mine = aligned.at(side + bone.above);
        Vector3d theirs_along = Vector3d::Zero(), ours_along = Vector3d::Zero();
        if (*bone.end) {
            theirs_along = theirs(side + bone.end) - theirs(side + bone.joint);
            ours_along = ours_m(side + bone.end) - ours_m(side + bone.joint);
        } else if (const auto& tip = source_.joint(findByAnyName(source_, side + bone.joint)).end_m) {
            theirs_along = handOf(side).along;
            ours_along = *tip;
        }
        if (theirs_along.norm() > 1e-6 && ours_along.norm() > 1e-6)
            mine = smallestRotation(mine * theirs_along, ours_along).toRotationMatrix() * mine;
    }

    HandRest handOf(const std::string& side) const {
        return handAtRest(target_, node(side + "Hand"), theirs(side + "Hand") - theirs(side + "ForeArm"));
    }

    /// Turns a hand about its length until its thumb points where ours does, the forearm half as far: rest
    /// poses differ in how the palms face. Limbs keep their directions.
    void turnPalm(const std::string& side, std::map<std::string, Matrix3d>& aligned) const {
        const Vector3d along = (ours_m(side + "Hand") - ours_m(side + "ForeArm")).normalized();
        const Vector3d thumb = aligned.at(side + "Hand") * handOf(side).thumb;
        const Vector3d across = thumb - along * along.dot(thumb),
                       wanted = kOurThumb - along * along.dot(kOurThumb);
        if (across.norm() < 0.3 * thumb.norm() || thumb.norm() < 1e-6)
            return;
        const double angle = std::atan2(along.dot(across.cross(wanted)), across.dot(wanted));
        if (std::abs(angle) > kMostPalm_rad)
            return;  // no thumb
        Matrix3d& hand = aligned.at(side + "Hand");
        Matrix3d& forearm = aligned.at(side + "ForeArm");
        hand = axisAngle(along, angle).toRotationMatrix() * hand;
        forearm = axisAngle(along, angle / 2).toRotationMatrix() * forearm;
    }

    const RiggedMesh& target_;
    const BoneMap& map_;
    const Skeleton& source_;
    const FeetAtRest& feet_;
    GlobalPose zero_;
};

/// The height of what the figure stands on: its own lowest vertex at rest, else its lowest node, seen
/// upright.
double groundOf(const RiggedMesh& mesh, const Matrix3d& R_ours_theirs, const std::vector<bool>& stands) {
    double low = 1e9;
    for (const SkinnedVertex& vertex : mesh.skin.vertices)
        if (!mesh.isRigged() || !stands[static_cast<size_t>(mesh.node_of_bone[vertex.bones[0]])])
            low = std::min(low, (R_ours_theirs * vertex.p_m.cast<double>()).y());
    if (mesh.skin.vertices.empty())
        for (const RigNode& node : mesh.nodes)
            low = std::min(low, (R_ours_theirs * node.T_world_rest.translation()).y());
    return low;
}

Status checkSource(const BoneMap& map, const Skeleton& source, const std::string& where) {
    for (const auto& [joint, node] : map.node_of_joint)
        if (findByAnyName(source, joint) < 0)
            return Error{ErrorKind::kUnusable,
                         where + ": the performer's skeleton has no " + joint + " for the bone " + node,
                         "Use a skeleton with the canonical joints, or leave that bone out"};
    return Done{};
}

}  // namespace

Result<Retargeter> Retargeter::make(const RiggedMesh& target, const BoneMap& map, const Skeleton& source,
                                    const FeetAtRest& feet, const std::string& where) {
    for (const Status& checked : {checkBoneMap(map, target, where), checkSource(map, source, where)})
        if (!checked)
            return checked.error();
    const RestPoses rest(target, map, source, feet);
    if (!(rest.legLength(true) > 1e-6) || !(rest.legLength(false) > 1e-6))
        return Error{ErrorKind::kUnusable, where + ": its legs have no length",
                     "Choose other bones for thighs, shins and feet"};
    Retargeter made;
    made.source_ = source;
    made.rest_ = restPose(target);
    for (const RigNode& node : target.nodes)
        made.parents_.push_back(node.parent);
    made.scale_ = rest.legLength(true) / rest.legLength(false);
    made.hips_ = rest.node("Hips");
    made.turned_.resize(target.nodes.size());
    for (const auto& [joint, R] : rest.alignments()) {
        const auto node = static_cast<size_t>(rest.node(joint));
        made.turned_[node] = {findByAnyName(source, joint), R};
    }
    made.upright_ = rest.facing();
    made.stands_ = nodesOfOtherBodies(target, map);
    const double ground = made.ground_ = groundOf(target, made.upright_, made.stands_);
    for (size_t side = 0; side < 2; ++side) {
        const std::string name = side == 0 ? "Left" : "Right";
        const auto soles = rest.soles(name, made.upright_, ground);
        Leg& leg = made.legs_[side];
        leg.thigh = rest.node(name + "UpLeg");
        leg.shin = rest.node(name + "Leg");
        leg.foot = rest.node(name + "Foot");
        leg.toes = rest.has(name + "ToeBase") ? rest.node(name + "ToeBase") : -1;
        leg.shin_joint = findByAnyName(source, name + "Leg");
        leg.foot_joint = findByAnyName(source, name + "Foot");
        leg.p_rest = soles.theirs;
        leg.p_joint_m = soles.ours_m;
        const std::vector<LegPart>& parts = made.leg_parts_[side] = made.partsOf(leg);
        const auto skinOf = [&](LegPart part) {
            std::vector<bool> nodes;
            for (const LegPart p : parts)
                nodes.push_back(p == part);
            return lowestSkin(target, nodes, made.upright_.transpose() * Vector3d::UnitY());
        };
        leg.foot_skin = skinOf(LegPart::kFoot);
        leg.toes_skin = skinOf(LegPart::kToes);
    }
    return made;
}

std::vector<Retargeter::LegPart> Retargeter::partsOf(const Leg& leg) const {
    std::vector<LegPart> parts;
    for (size_t n = 0; n < parents_.size(); ++n) {
        const int node = static_cast<int>(n), parent = parents_[n];
        parts.push_back(node == leg.thigh  ? LegPart::kThigh
                        : node == leg.shin ? LegPart::kShin
                        : node == leg.foot ? LegPart::kFoot
                        : node == leg.toes ? LegPart::kToes
                        : parent < 0       ? LegPart::kNone
                                           : parts[static_cast<size_t>(parent)]);
    }
    return parts;
}

}  // namespace noctule
