// SPDX-License-Identifier: Apache-2.0
#include "core/figure/measures.h"

#include <algorithm>
#include <cmath>

#include "core/figure/facing.h"
#include "core/math/order_statistics.h"
#include "core/math/rotation.h"

namespace noctule::figure {
namespace {

// The default actor: thigh and shin 0.43 each, hip joints to shoulder joints 0.45.
constexpr double kAdult_m = 1.75, kAdultLegs_m = 0.86, kAdultTrunk_m = 0.45;

/// Distance from a joint to the farthest joint or tip below it; 0 when nothing hangs on it.
double reach(const MotionClip& clip, const std::vector<Vector3d>& p, int top) {
    std::vector<bool> below(p.size(), false);
    below[static_cast<size_t>(top)] = true;
    double farthest = 0;
    for (int j = top; j < clip.skeleton.size(); ++j) {
        const Joint& joint = clip.skeleton.joint(j);
        const size_t n = static_cast<size_t>(j);
        below[n] = below[n] || (joint.parent >= 0 && below[static_cast<size_t>(joint.parent)]);
        if (!below[n])
            continue;
        const Vector3d from_top = p[n] - p[static_cast<size_t>(top)];
        farthest = std::max(farthest, from_top.norm());
        if (joint.end_m)
            farthest = std::max(farthest, (from_top + *joint.end_m).norm());
    }
    return farthest;
}

/// The figure with every mapped segment in its canonical orientation: where its joints would be.
class UprightFigure {
public:
    UprightFigure(const MotionClip& clip, const SeenMotion& seen, const JointMapping& mapping)
        : clip_(clip), seen_(seen), mapping_(mapping) {
        alignment_ = alignFigure(clip, seen, mapping, defaultActor().skeleton);
    }

    /// From one joint to another that hangs below it, through the mapped joints between them.
    Vector3d from(const std::string& above, const std::string& joint) const {
        std::vector<std::string> path{joint};
        for (int j = clip_.skeleton.joint(mapping_.at(joint)).parent; j > mapping_.at(above);
             j = clip_.skeleton.joint(j).parent)
            for (const auto& [name, mapped] : mapping_)
                if (mapped == j && alignment_.q_source_canonical.contains(name))
                    path.push_back(name);
        path.push_back(above);
        Vector3d sum = Vector3d::Zero();
        for (size_t i = path.size() - 1; i > 0; --i)
            sum += alignment_.q_source_canonical.at(path[i]).conjugate() *
                   seen_.between(mapping_.at(path[i]), mapping_.at(path[i]), mapping_.at(path[i - 1]));
        return sum;
    }

    /// Whether the zero pose can be measured: trunk and shoulders are in it as in the motion.
    bool zeroStands() const { return alignment_.zero_trunk_stands; }
    const Alignment& alignment() const { return alignment_; }

private:
    const MotionClip& clip_;
    const SeenMotion& seen_;
    const JointMapping& mapping_;
    Alignment alignment_;
};

/// Hip joints to shoulder joints, upright, and the width between the shoulder joints.
std::pair<double, double> shouldersOf(const MotionClip& clip, const UprightFigure& figure,
                                      const JointMapping& m) {
    if (figure.zeroStands()) {
        const std::vector<Vector3d> p = zeroPositions(clip);
        const auto at = [&](const char* joint) { return p[static_cast<size_t>(m.at(joint))]; };
        const Vector3d left = (at("LeftUpLeg") - at("RightUpLeg")).normalized();
        const Vector3d rise = trunkOf({p, {}}, m);
        return {(rise - left * left.dot(rise)).norm(), (at("LeftArm") - at("RightArm")).norm()};
    }
    const Vector3d left = figure.from("Hips", "LeftArm"), right = figure.from("Hips", "RightArm");
    const Vector3d hips = (figure.from("Hips", "LeftUpLeg") + figure.from("Hips", "RightUpLeg")) / 2;
    return {((left + right) / 2 - hips).y(), (left - right).norm()};
}

double footLength(const SeenMotion& seen, const UprightFigure& figure, const JointMapping& m,
                  const std::string& side) {
    const int foot = m.at(side + "Foot"), toe = m.at(side + "ToeBase");
    const Vector3d bone =
        figure.alignment().q_source_canonical.at(side + "Foot").conjugate() * seen.between(foot, foot, toe);
    return std::hypot(bone.x(), bone.z());
}

}  // namespace

double statureOf(const SeenMotion& seen, const JointMapping& m) {
    double legs = 0, trunk = 0;
    for (const std::string side : {"Left", "Right"}) {
        const double thigh = seen.distance(m.at(side + "UpLeg"), m.at(side + "Leg"));
        legs += thigh / 2;
        legs +=
            (m.contains(side + "Foot") ? seen.distance(m.at(side + "Leg"), m.at(side + "Foot")) : thigh) / 2;
    }
    std::vector<double> trunks;
    for (const GlobalPose& pose : seen.poses())
        trunks.push_back(trunkOf(pose, m).norm());
    trunk = middleValue(std::move(trunks));
    return kAdult_m * (legs + trunk) / (kAdultLegs_m + kAdultTrunk_m);
}

BodyMeasures measure(const MotionClip& clip, const SeenMotion& seen, const JointMapping& m) {
    const UprightFigure figure(clip, seen, m);
    const auto bothSides = [&](const std::string& a, const std::string& b) {
        if (!m.contains("Left" + b) || !m.contains("Right" + b))
            return 0.0;
        return (seen.distance(m.at("Left" + a), m.at("Left" + b)) +
                seen.distance(m.at("Right" + a), m.at("Right" + b))) /
               2;
    };
    const auto [shoulder_height, shoulder_width] = shouldersOf(clip, figure, m);
    BodyMeasures measures;
    measures.upper_arm_m = bothSides("Arm", "ForeArm");
    measures.forearm_m = bothSides("ForeArm", "Hand");
    measures.thigh_m = bothSides("UpLeg", "Leg");
    measures.shin_m = bothSides("Leg", "Foot");
    measures.shoulder_width_m = shoulder_width;
    measures.hip_width_m = seen.distance(m.at("LeftUpLeg"), m.at("RightUpLeg"));
    const std::vector<Vector3d> p = zeroPositions(clip);
    if (m.contains("LeftHand") && m.contains("RightHand"))
        measures.hand_m = (reach(clip, p, m.at("LeftHand")) + reach(clip, p, m.at("RightHand"))) / 2;
    if (m.contains("LeftFoot") && m.contains("RightFoot") && m.contains("LeftToeBase") &&
        m.contains("RightToeBase"))
        measures.foot_m = (footLength(seen, figure, m, "Left") + footLength(seen, figure, m, "Right")) / 2;
    const double shin = measures.shin_m > 0 ? measures.shin_m : measures.thigh_m;
    measures.height_m =
        kAdult_m * (measures.thigh_m + shin + shoulder_height) / (kAdultLegs_m + kAdultTrunk_m);
    // The default actor's hip joints lie 0.05 below its hips, its shoulders at 0.40 of a trunk of 0.44.
    measures.trunk_m = (shoulder_height - 0.05 * measures.height_m / kAdult_m) * 0.44 / 0.40;
    return measures;
}

}  // namespace noctule::figure
