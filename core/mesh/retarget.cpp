// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/retarget.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/body/joint_names.h"
#include "core/math/easing.h"
#include "core/math/rotation.h"
#include "core/mesh/foot_skin.h"
#include "core/mesh/hand_rest.h"
#include "core/mesh/other_skeletons.h"
#include "core/mesh/rig_tree.h"

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

constexpr double kNearFloor_m = 0.03;  ///< heel and toes of ours: below, a foot begins to lie flat
/// Where our lowest sole is higher, nobody stands, and nothing has to give way.
constexpr double kMostFloor_m = 0.1;

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

/// A turn about a place.
Eigen::Isometry3d about(const Vector3d& p, const Quaterniond& q) {
    return Eigen::Translation3d(p) * q * Eigen::Translation3d(-p);
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

std::vector<Eigen::Isometry3d> Retargeter::turned(const GlobalPose& source, const Vector3d& p_hips) const {
    std::vector<Eigen::Isometry3d> motions(rest_.size(), Eigen::Isometry3d::Identity());
    const auto hips = static_cast<size_t>(hips_);
    std::vector<bool> below(rest_.size(), false);
    below[hips] = true;
    for (size_t n = hips; n < rest_.size(); ++n) {
        const int parent = parents_[n];
        const bool hangs = parent >= 0 && below[static_cast<size_t>(parent)];
        below[n] = below[n] || hangs;
        const Vector3d p_rest = rest_[n].translation();
        const Vector3d p = hangs ? Vector3d(motions[static_cast<size_t>(parent)] * p_rest) : p_hips;
        if (hangs)
            motions[n] = motions[static_cast<size_t>(parent)];
        if (turned_[n].joint >= 0)
            motions[n].linear() =
                source.q_world_joint[static_cast<size_t>(turned_[n].joint)] * turned_[n].align;
        motions[n].translation() = p - motions[n].linear() * p_rest;
    }
    Eigen::Isometry3d standing(upright_);
    standing.pretranslate(Vector3d(0, -ground_, 0));
    for (size_t n = 0; n < motions.size(); ++n)
        if (!below[n])
            motions[n] = stands_[n] ? standing : motions[hips];
    return motions;
}

LegPlaces Retargeter::placesOf(const Leg& leg, const GlobalPose& source,
                               const std::vector<Eigen::Isometry3d>& motions) const {
    const auto at = [&](int node) -> Vector3d {
        return motions[static_cast<size_t>(node)] * rest_[static_cast<size_t>(node)].translation();
    };
    LegPlaces places{at(leg.thigh), at(leg.shin), at(leg.foot), {}, {}, {}};
    places.knee_axis = source.q_world_joint[static_cast<size_t>(leg.shin_joint)] * Vector3d::UnitX();
    const auto foot = static_cast<size_t>(leg.foot_joint);
    for (size_t i = 0; i < 2; ++i) {
        places.sole[i] = motions[static_cast<size_t>(leg.foot)] * leg.p_rest[i];
        places.sole_ours[i] = source.p_world_joint[foot] + source.q_world_joint[foot] * leg.p_joint_m[i];
    }
    return places;
}

/// The lowest sole as high above the ground as our lowest.
std::vector<Eigen::Isometry3d> Retargeter::onGround(const GlobalPose& source) const {
    std::vector<Eigen::Isometry3d> motions = turned(source, scale_ * source.p_world_joint[0]);
    double ours = 1e9, theirs = 1e9;
    for (const Leg& leg : legs_) {
        const LegPlaces places = placesOf(leg, source, motions);
        for (size_t i = 0; i < 2; ++i) {
            ours = std::min(ours, places.sole_ours[i].y());
            theirs = std::min(theirs, places.sole[i].y());
        }
    }
    for (size_t n = 0; n < motions.size(); ++n)
        if (!stands_[n])
            motions[n].translation().y() += scale_ * ours - theirs;
    return motions;
}

/// Turns the shin about the knee, then the leg about the hip until it points at the ankle's new place; the
/// foot keeps its direction.
void Retargeter::bend(size_t side, const LegPlaces& places, const Vector3d& shift, double knee_rad,
                      std::vector<Eigen::Isometry3d>& motions) const {
    const Eigen::Isometry3d knee = about(places.knee, axisAngle(places.knee_axis, knee_rad));
    const Vector3d bent = knee * places.ankle;
    const Eigen::Isometry3d hip =
        about(places.hip, smallestRotation(bent - places.hip, places.ankle + shift - places.hip));
    const Eigen::Isometry3d foot(Eigen::Translation3d(hip * bent - places.ankle));
    for (size_t n = 0; n < motions.size(); ++n)
        switch (leg_parts_[side][n]) {
            case LegPart::kNone:
                break;
            case LegPart::kThigh:
                motions[n] = hip * motions[n];
                break;
            case LegPart::kShin:
                motions[n] = hip * knee * motions[n];
                break;
            case LegPart::kFoot:
            case LegPart::kToes:
                motions[n] = foot * motions[n];
                break;
        }
}

/// A foot, and then its toes, lie flat as far as ours does on the floor; what would lie below it turns up
/// about ankle and ball, until the part lies flat at most.
void Retargeter::putOnFloor(size_t side, double flat, double floor,
                            std::vector<Eigen::Isometry3d>& motions) const {
    const Leg& leg = legs_[side];
    const auto put = [&](int node, const std::vector<Vector3d>& skin, auto goesAlong) {
        const Eigen::Isometry3d& motion = motions[static_cast<size_t>(node)];
        const Vector3d centre = motion * rest_[static_cast<size_t>(node)].translation();
        const auto turn = [&](const Quaterniond& q) {
            const Eigen::Isometry3d turned = about(centre, q);
            for (size_t n = 0; n < motions.size(); ++n)
                if (goesAlong(leg_parts_[side][n]))
                    motions[n] = turned * motions[n];
        };
        const Vector3d up = motion.linear() * upright_.transpose() * Vector3d::UnitY();
        turn(Quaterniond::Identity().slerp(flat, smallestRotation(up, Vector3d::UnitY())));
        const Vector3d ahead = motion.linear() * (leg.p_rest[1] - leg.p_rest[0]);
        const Vector3d axis = ahead.cross(Vector3d::UnitY());
        if (axis.norm() < 1e-3 * ahead.norm() || skin.empty())
            return;  // it stands on end
        std::vector<Vector3d> points;
        for (const Vector3d& p_rest : skin)
            points.push_back(motion * p_rest);
        const double most_rad = std::atan2(-ahead.y(), axis.norm());
        turn(
            axisAngle(axis.normalized(), turnAboveFloor(points, centre, axis.normalized(), floor, most_rad)));
    };
    const auto isToes = [](LegPart part) { return part == LegPart::kToes; };
    put(leg.foot, leg.foot_skin, [&](LegPart part) { return part == LegPart::kFoot || isToes(part); });
    if (leg.toes >= 0)
        put(leg.toes, leg.toes_skin, isToes);
}

double LegPlaces::kneeTurn(const Vector3d& shift) const {
    if (shift == Vector3d::Zero())
        return 0;
    const Vector3d up = hip - knee, down = ankle - knee, n = knee_axis;
    // up . R(n, turn) down = a cos(turn) + b sin(turn) + c, which the law of cosines wants to be `wanted`
    const double c = up.dot(n) * down.dot(n), a = up.dot(down) - c, b = up.dot(n.cross(down));
    const double wanted = (up.squaredNorm() + down.squaredNorm() - (ankle + shift - hip).squaredNorm()) / 2;
    const double across = std::hypot(a, b);
    if (across < 1e-9)
        return 0;
    const double folded = std::atan2(b, a), reach = std::acos(std::clamp((wanted - c) / across, -1.0, 1.0));
    return (folded < 0 ? -1 : 1) * (std::abs(folded) - reach);
}

std::vector<Eigen::Isometry3d> Retargeter::motions(const Pose& source, const FootCorrections& feet) const {
    const GlobalPose global = globalPose(source_, source);
    std::vector<Eigen::Isometry3d> motions = onGround(global);
    for (size_t side = 0; side < 2; ++side) {
        const FootCorrection& foot = feet[side];
        if (foot.p_root != Vector3d::Zero() || foot.knee_rad != 0)
            bend(side, placesOf(legs_[side], global, motions), global.q_world_joint[0] * foot.p_root,
                 foot.knee_rad, motions);
    }
    std::array<double, 2> lowest_m{}, highest_m{};
    for (size_t side = 0; side < 2; ++side) {
        const auto sole_m = placesOf(legs_[side], global, motions).sole_ours;
        std::tie(lowest_m[side], highest_m[side]) = std::minmax(sole_m[0].y(), sole_m[1].y());
    }
    const double floor_m = std::min(lowest_m[0], lowest_m[1]);
    for (size_t side = 0; side < 2; ++side)
        putOnFloor(side, eased(1 - (highest_m[side] - floor_m) / kNearFloor_m),
                   scale_ * std::min(floor_m, kMostFloor_m), motions);
    return motions;
}

std::array<LegPlaces, 2> Retargeter::legs(const Pose& source, const FootCorrections& feet) const {
    const GlobalPose global = globalPose(source_, source);
    const std::vector<Eigen::Isometry3d> moved = motions(source, feet);
    return {placesOf(legs_[0], global, moved), placesOf(legs_[1], global, moved)};
}

RigPose Retargeter::pose(const Pose& source, const FootCorrections& feet) const {
    const std::vector<Eigen::Isometry3d> moved = motions(source, feet);
    RigPose pose = rest_;
    for (size_t n = 0; n < pose.size(); ++n)
        pose[n] = moved[n] * rest_[n];
    return pose;
}

}  // namespace noctule
