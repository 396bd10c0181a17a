// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/retarget.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"
#include "core/mesh/hand_rest.h"
#include "core/mesh/rig_tree.h"

namespace noctule {
namespace {

/// Our joint by name, or by the name that another program gives it; -1 when there is none.
int jointOf(const Skeleton& skeleton, const std::string& name) {
    if (const int joint = skeleton.find(name); joint >= 0)
        return joint;
    for (int j = 0; j < skeleton.size(); ++j)
        for (const auto& [program, alias] : skeleton.joint(j).aliases)
            if (alias == name)
                return j;
    return -1;
}

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
    RestPoses(const RiggedMesh& target, const BoneMap& map, const Skeleton& source)
        : target_(target), map_(map), source_(source), zero_(globalPose(source, source.zeroPose())) {}

    bool has(const std::string& joint) const { return map_.node_of_joint.contains(joint); }
    int node(const std::string& joint) const { return target_.find(map_.node_of_joint.at(joint)); }
    Vector3d theirs(const std::string& joint) const {
        return target_.nodes[static_cast<size_t>(node(joint))].T_world_rest.translation();
    }
    Vector3d ours_m(const std::string& joint) const {
        return zero_.p_world_joint[static_cast<size_t>(jointOf(source_, joint))];
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
        }
        return aligned;
    }

    /// Both soles at rest: theirs in the frame of their foot, ours in the frame of ours.
    struct Soles {
        int node, joint;
        std::array<Vector3d, 2> theirs, ours_m;
    };
    Soles soles(const std::string& side, const Matrix3d& R_ours_theirs, double ground) const {
        const std::string foot = side + "Foot", toe = side + "ToeBase";
        const GlobalPose bound = globalPose(source_, bindPose(source_));
        const int joint = jointOf(source_, foot), toe_joint = jointOf(source_, toe);
        const Vector3d p_foot = bound.p_world_joint[static_cast<size_t>(joint)];
        const Vector3d p_toes = toe_joint >= 0 ? bound.p_world_joint[static_cast<size_t>(toe_joint)]
                                               : p_foot + kToes_m * Vector3d::UnitZ();
        const Vector3d p_ankle = R_ours_theirs * theirs(foot);
        const double scale = legLength(true) / legLength(false);
        const Vector3d p_tip =
            has(toe) ? Vector3d(R_ours_theirs * theirs(toe)) : Vector3d(p_ankle + scale * (p_toes - p_foot));
        Soles made{node(foot), joint, solePoints(p_ankle, p_tip, ground), solePoints(p_foot, p_toes, 0)};
        const Eigen::Affine3d& T_world_node = target_.nodes[static_cast<size_t>(made.node)].T_world_rest;
        for (Vector3d& p : made.theirs)
            p = T_world_node.inverse() * (R_ours_theirs.transpose() * p);
        for (Vector3d& p_m : made.ours_m)
            p_m -= p_foot;
        return made;
    }

private:
    void align(const std::string& side, const LimbBone& bone,
               std::map<std::string, Matrix3d>& aligned) const {
        Matrix3d& mine = aligned.at(side + bone.joint);
        if (*bone.above)
            mine = aligned.at(side + bone.above);
        Vector3d theirs_along = Vector3d::Zero(), ours_along = Vector3d::Zero();
        if (*bone.end) {
            theirs_along = theirs(side + bone.end) - theirs(side + bone.joint);
            ours_along = ours_m(side + bone.end) - ours_m(side + bone.joint);
        } else if (const auto& tip = source_.joint(jointOf(source_, side + bone.joint)).end_m) {
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
    GlobalPose zero_;
};

/// The height of what the figure stands on: its lowest vertex at rest, else its lowest node, seen upright.
double groundOf(const RiggedMesh& mesh, const Matrix3d& R_ours_theirs) {
    double low = 1e9;
    for (const SkinnedVertex& vertex : mesh.skin.vertices)
        low = std::min(low, (R_ours_theirs * vertex.p_m.cast<double>()).y());
    if (mesh.skin.vertices.empty())
        for (const RigNode& node : mesh.nodes)
            low = std::min(low, (R_ours_theirs * node.T_world_rest.translation()).y());
    return low;
}

Status checkSource(const BoneMap& map, const Skeleton& source, const std::string& where) {
    for (const auto& [joint, node] : map.node_of_joint)
        if (jointOf(source, joint) < 0)
            return Error{ErrorKind::kUnusable,
                         where + ": the performer's skeleton has no " + joint + " for the bone " + node,
                         "Use a skeleton with the canonical joints, or leave that bone out"};
    return Done{};
}

}  // namespace

Result<Retargeter> Retargeter::make(const RiggedMesh& target, const BoneMap& map, const Skeleton& source,
                                    const std::string& where) {
    for (const Status& checked : {checkBoneMap(map, target, where), checkSource(map, source, where)})
        if (!checked)
            return checked.error();
    const RestPoses rest(target, map, source);
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
        made.turned_[node] = {jointOf(source, joint), R * made.rest_[node].linear()};
    }
    const Matrix3d R_ours_theirs = rest.facing();
    const double ground = groundOf(target, R_ours_theirs);
    for (size_t side = 0; side < 2; ++side) {
        const auto soles = rest.soles(side == 0 ? "Left" : "Right", R_ours_theirs, ground);
        made.soles_[side] = {soles.node, soles.joint, soles.theirs, soles.ours_m};
    }
    return made;
}

RigPose Retargeter::turned(const GlobalPose& source, const Vector3d& p_hips) const {
    RigPose pose = rest_;
    for (size_t n = static_cast<size_t>(hips_); n < pose.size(); ++n) {
        const int parent = parents_[n];
        const auto p = static_cast<size_t>(parent);
        if (static_cast<int>(n) == hips_)
            pose[n].translation() = p_hips;
        else if (parent >= hips_)
            pose[n] = pose[p] * (rest_[p].inverse() * rest_[n]);
        if (turned_[n].joint >= 0)
            pose[n].linear() = source.q_world_joint[static_cast<size_t>(turned_[n].joint)] * turned_[n].rest;
    }
    // What does not hang on the hips goes along with them.
    const auto hips = static_cast<size_t>(hips_);
    const Eigen::Affine3d moved = pose[hips] * rest_[hips].inverse();
    std::vector<bool> below(pose.size(), false);
    below[hips] = true;
    for (size_t n = 0; n < pose.size(); ++n) {
        below[n] = below[n] || (parents_[n] >= 0 && below[static_cast<size_t>(parents_[n])]);
        if (!below[n])
            pose[n] = moved * rest_[n];
    }
    return pose;
}

RigPose Retargeter::pose(const Pose& source) const {
    const GlobalPose global = globalPose(source_, source);
    RigPose pose = turned(global, scale_ * source.p_world_root);
    double ours_m = 1e9, theirs = 1e9;
    for (const Sole& sole : soles_)
        for (size_t i = 0; i < sole.p_node.size(); ++i) {
            const auto joint = static_cast<size_t>(sole.joint);
            const Vector3d p_m =
                global.p_world_joint[joint] + global.q_world_joint[joint] * sole.p_joint_m[i];
            ours_m = std::min(ours_m, p_m.y());
            theirs = std::min(theirs, (pose[static_cast<size_t>(sole.node)] * sole.p_node[i]).y());
        }
    for (Eigen::Affine3d& T : pose)
        T.translation().y() += scale_ * ours_m - theirs;
    return pose;
}

std::vector<Eigen::Affine3d> localTransforms(const RiggedMesh& mesh, const RigPose& pose) {
    require(pose.size() == mesh.nodes.size(), "localTransforms() needs a transform per node");
    std::vector<Eigen::Affine3d> local;
    for (size_t n = 0; n < pose.size(); ++n) {
        const int parent = mesh.nodes[n].parent;
        local.push_back(parent < 0 ? pose[n] : pose[static_cast<size_t>(parent)].inverse() * pose[n]);
    }
    return local;
}

}  // namespace noctule
