// SPDX-License-Identifier: Apache-2.0
#include "core/figure/figure_checks.h"

#include <algorithm>
#include <cmath>

#include "core/figure/aligner.h"
#include "core/figure/facing.h"
#include "core/figure/measures.h"

namespace noctule::figure {
namespace {

struct Bone {
    const char *from, *to, *name;
};
constexpr Bone kLimbBones[] = {{"Arm", "ForeArm", "upper arm"},
                               {"ForeArm", "Hand", "forearm"},
                               {"UpLeg", "Leg", "thigh"},
                               {"Leg", "Foot", "shin"}};

std::string metres(double value_m) {
    char text[40];
    std::snprintf(text, sizeof text, "%.2f m", value_m);
    return text;
}

void checkHeight(const UnderstoodMotion& motion, const MotionHints& hints, std::vector<std::string>& said) {
    constexpr double kSmallest_m = 0.5, kChild_m = 1.2, kTall_m = 2.2, kTallest_m = 2.5;
    const double height_m = motion.measures.height_m;
    if (hints.height_m > 0)
        return;
    const std::string tall =
        "The figure is " + metres(height_m) + " tall with the unit " + toText(motion.unit);
    const std::string remedy = "; --height M or --bvh-unit corrects it";
    if (height_m < kSmallest_m || height_m > kTallest_m)
        said.push_back(tall + ", which no person is" + remedy);
    else if (height_m < kChild_m || height_m > kTall_m)
        said.push_back(tall + ": a " + (height_m < kChild_m ? "child" : "giant") + ", or another unit" +
                       remedy);
    else if (hints.unit == BvhUnit::kAuto && motion.unit == BvhUnit::kInch)
        said.push_back(tall + "; a child in centimetres would look the same" + remedy);
}

void checkLimbs(const UnderstoodMotion& motion, const SeenMotion& seen, std::vector<std::string>& said) {
    constexpr double kAlike = 1.08, kRigid = 0.05;
    const JointMapping& joints = motion.joints;
    for (const Bone& bone : kLimbBones) {
        double length[2] = {0, 0};
        for (const int side : {0, 1}) {
            const std::string prefix = side == 0 ? "Left" : "Right";
            const auto from = joints.find(prefix + bone.from), to = joints.find(prefix + bone.to);
            if (from == joints.end() || to == joints.end())
                continue;
            length[side] = seen.distance(from->second, to->second);
            const double deviation = seen.meanOf([&](const GlobalPose& pose) {
                return std::abs((pose.p_world_joint[static_cast<size_t>(to->second)] -
                                 pose.p_world_joint[static_cast<size_t>(from->second)])
                                    .norm() -
                                length[side]);
            });
            if (deviation > kRigid * length[side])
                said.push_back("The " + std::string(side == 0 ? "left " : "right ") + bone.name +
                               " changes its length by " + metres(deviation) +
                               " on the mean; its median is taken");
        }
        if (length[0] > 0 && length[1] > 0 && std::abs(std::log(length[0] / length[1])) > std::log(kAlike))
            said.push_back("The " + std::string(bone.name) + " is " + metres(length[0]) +
                           " long on the left and " + metres(length[1]) +
                           " on the right; --bones MAP.json corrects a joint that was taken wrongly");
    }
}

void checkProportions(const BodyMeasures& m, std::vector<std::string>& said) {
    const auto unlikely = [&](double part, double whole, double least, double most, const std::string& what) {
        if (part > 0 && whole > 0 && (part < least * whole || part > most * whole))
            said.push_back(what + " are " + metres(part) + " and " + metres(whole) +
                           ", which no person has; --bones MAP.json corrects a joint that was taken wrongly");
    };
    unlikely(m.forearm_m, m.upper_arm_m, 0.6, 1.4, "Forearm and upper arm");
    unlikely(m.shin_m, m.thigh_m, 0.65, 1.45, "Shin and thigh");
    unlikely(m.upper_arm_m, m.thigh_m, 0.35, 1.2, "Upper arm and thigh");
    unlikely(m.shoulder_width_m, m.height_m, 0.1, 0.35, "Shoulders and height");
}

void checkJoints(const UnderstoodMotion& motion, std::vector<std::string>& said) {
    std::string missing, by_shape;
    for (const char* joint : {"Head", "LeftHand", "RightHand", "LeftFoot", "RightFoot"})
        if (!motion.joints.contains(joint))
            missing += (missing.empty() ? "" : ", ") + std::string(joint);
    if (!missing.empty())
        said.push_back("No joint was recognised as " + missing +
                       "; these parts stay still. --bones MAP.json names them");
    for (const std::string& joint : motion.by_shape)
        by_shape +=
            (by_shape.empty() ? "" : ", ") + joint + " = " +
            motion.clip.skeleton.joint(motion.joints.contains(joint) ? motion.joints.at(joint) : 0).name;
    if (!by_shape.empty())
        said.push_back("Names do not say which joint is which of these, the figure's shape does: " +
                       by_shape + ". --bones MAP.json corrects it");
}

void checkSpeed(const UnderstoodMotion& motion, std::vector<std::string>& said) {
    constexpr double kFastest_m_per_s = 8;
    const double speed = extremitySpeed(motion.clip, motion.joints);
    if (speed > kFastest_m_per_s)
        said.push_back("Hands and feet move at " + std::to_string(static_cast<int>(speed)) +
                       " m/s on the mean: is the file's Frame Time right, and its unit?");
}

}  // namespace

double extremitySpeed(const MotionClip& clip, const JointMapping& joints) {
    double sum_m = 0;
    size_t count = 0;
    const size_t stride = std::max<size_t>(1, clip.frames.size() / 500);
    for (size_t f = 0; f + 1 < clip.frames.size(); f += stride) {
        const GlobalPose now = globalPose(clip, f), next = globalPose(clip, f + 1);
        for (const char* name : {"LeftForeArm", "RightForeArm", "LeftLeg", "RightLeg"})
            if (const auto joint = joints.find(name); joint != joints.end()) {
                const size_t j = static_cast<size_t>(joint->second);
                sum_m += (next.p_world_joint[j] - now.p_world_joint[j]).norm();
                ++count;
            }
    }
    return count == 0 ? 0 : sum_m / static_cast<double>(count) / clip.frame_time_s;
}

std::string restPoseInWords(const MotionClip& clip, const SeenMotion& seen, const JointMapping& joints) {
    const std::vector<Vector3d> p = zeroPositions(clip);
    const auto bone = [&](const std::string& from, const std::string& to) {
        return Vector3d(p[static_cast<size_t>(joints.at(to))] - p[static_cast<size_t>(joints.at(from))]);
    };
    const bool stands = alignFigure(clip, seen, joints, defaultActor().skeleton).zero_trunk_stands;
    const Vector3d thigh = bone("LeftUpLeg", "LeftLeg"), arm = bone("LeftArm", "LeftForeArm");
    const Vector3d trunk = trunkOf({p, {}}, joints);
    if (!stands) {
        constexpr double kParallel = radians(15);
        return angleOf(thigh, arm) < kParallel && angleOf(thigh, trunk) < 2 * kParallel
                   ? "bones along one axis"
               : trunk.norm() > thigh.norm() / 2 ? "bent trunk"
                                                 : "not a standing pose";
    }
    constexpr double kSits = radians(60), kLevel = radians(25), kHangs = radians(70);
    if (angleOf(thigh, -trunk) > kSits)
        return "sitting";
    const double below =
        angleOf(arm, -trunk) < std::numbers::pi / 2 ? std::numbers::pi / 2 - angleOf(arm, -trunk) : 0;
    return below > kHangs ? "arms down" : below > kLevel ? "A pose" : "T pose";
}

std::vector<std::string> figureWarnings(const UnderstoodMotion& motion, const MotionHints& hints) {
    std::vector<std::string> said;
    const SeenMotion seen(motion.clip);
    checkHeight(motion, hints, said);
    checkLimbs(motion, seen, said);
    checkProportions(motion.measures, said);
    checkJoints(motion, said);
    checkSpeed(motion, said);
    return said;
}

}  // namespace noctule::figure
