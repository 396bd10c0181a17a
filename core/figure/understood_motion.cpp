// SPDX-License-Identifier: Apache-2.0
#include "core/figure/understood_motion.h"

#include <algorithm>
#include <cmath>

#include "core/figure/facing.h"
#include "core/figure/figure_checks.h"
#include "core/figure/measures.h"

namespace noctule::figure {
namespace {

std::string counted(size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string fixed(double value, int decimals) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

/// MakeHuman and others write position channels on every joint that do not replace its OFFSET, they add to
/// it: they stay near zero while the OFFSET does not.
void addOffsets(BvhDocument& document, std::vector<std::string>& notes) {
    constexpr double kNearZero = 0.05;  // of the OFFSET's length
    size_t added = 0;
    for (const BvhJoint& joint : document.joints) {
        std::vector<std::pair<size_t, double>> places;  // in a row, and what the OFFSET has there
        for (size_t n = 0; n < joint.channels.size(); ++n)
            if (joint.channels[n] <= BvhChannel::kZposition)
                places.emplace_back(joint.first_channel + n,
                                    joint.offset[static_cast<Eigen::Index>(joint.channels[n])]);
        if (joint.parent < 0 || places.size() < 3 || joint.offset.isZero(0))
            continue;
        double largest = 0;
        for (size_t row = 0; row < document.values.size(); row += document.channel_count)
            for (const auto& [place, offset] : places)
                largest = std::max(largest, std::abs(document.values[row + place]));
        if (largest > kNearZero * joint.offset.norm())
            continue;
        for (size_t row = 0; row < document.values.size(); row += document.channel_count)
            for (const auto& [place, offset] : places)
                document.values[row + place] += offset;
        ++added;
    }
    if (added > 0)
        notes.push_back("The position channels of " + counted(added, "joint") +
                        " are about zero; they are added to the OFFSETs");
}

void scale(MotionClip& clip, double factor) {
    std::vector<Joint> joints = clip.skeleton.joints();
    for (Joint& joint : joints) {
        joint.offset_m *= factor;
        if (joint.end_m)
            *joint.end_m *= factor;
    }
    clip.skeleton = Skeleton::make(std::move(joints)).value();
    for (Pose& pose : clip.frames)
        pose.p_world_root *= factor;
    for (std::vector<Vector3d>& places : clip.p_parent_joint_m)
        for (Vector3d& place : places)
            place *= factor;
}

class Understanding {
public:
    explicit Understanding(const MotionHints& hints) : hints_(hints) {}

    Result<UnderstoodMotion> run(BvhDocument document) {
        addOffsets(document, motion_.notes);
        Result<MotionClip> clip = toClip(document, BvhUnit::kMetre);
        if (!clip)
            return clip.error();
        motion_.clip = std::move(*clip);
        Result<LostTracking> lost = bridgeLostTracking(motion_.clip);
        if (!lost)
            return lost.error();
        motion_.lost = std::move(*lost);
        tellLost();
        const SeenMotion seen(motion_.clip);
        Result<MappedJoints> mapped = mapJoints(motion_.clip, seen, hints_.joints, motion_.clip.name);
        if (!mapped)
            return mapped.error();
        motion_.joints = std::move(mapped->joints);
        motion_.by_shape = std::move(mapped->by_shape);
        motion_.by_hand = std::move(mapped->by_hand);
        setSides(seen);
        if (Status sized = setUnit(seen); !sized)
            return sized.error();
        setUp(seen);
        setFrameTime();
        finish();
        return std::move(motion_);
    }

private:
    void note(const std::string& sentence) { motion_.notes.push_back(sentence); }
    void warn(const std::string& sentence) { motion_.warnings.push_back(sentence); }

    void tellLost() {
        const LostTracking& lost = motion_.lost;
        if (lost.cut_first > 0)
            warn("The first " + counted(lost.cut_first, "frame") + " hold zeros only and are cut off");
        if (lost.cut_last > 0)
            warn("The last " + counted(lost.cut_last, "frame") + " hold zeros only and are cut off");
        if (lost.bridged > 0)
            warn("Tracking was lost in " + counted(lost.bridged, "frame") + " (all angles zero, at most " +
                 std::to_string(lost.longest) + " in a row); they are bridged between their neighbours");
        for (const auto& [joint, frames] : lost.joints)
            warn("Tracking of " + joint + " was lost in " + counted(frames, "frame") +
                 "; they are bridged between their neighbours");
    }

    void setSides(const SeenMotion& seen) {
        const Sides sides = judgeSides(motion_.clip, seen, motion_.joints);
        if (!sides.legs_exchanged && !sides.arms_exchanged)
            return;
        const std::string what = sides.legs_exchanged && sides.arms_exchanged ? "Left and right"
                                 : sides.legs_exchanged                       ? "Left and right leg"
                                                                              : "Left and right arm";
        if (!motion_.by_hand.empty()) {
            warn(what + " seem to be exchanged in the bone map: toes, knees and elbows point the other way");
            return;
        }
        motion_.joints = exchanged(motion_.joints, sides);
        warn(what +
             " are exchanged in the file, as toes, knees and elbows show; the sides are set right. "
             "--bones MAP.json says otherwise");
    }

    Status setUnit(const SeenMotion& seen) {
        const double stature = statureOf(seen, motion_.joints);
        if (!(stature > 1e-6))
            return Error{ErrorKind::kUnusable, motion_.clip.name + ": its limbs have no length",
                         "Export the motion with the skeleton's OFFSETs or position channels"};
        BvhUnitChoice choice = unitForHeight(stature);
        if (hints_.unit != BvhUnit::kAuto)
            choice = {hints_.unit, stature * metresPer(hints_.unit), true};
        motion_.unit = choice.unit;
        motion_.metres_per_unit = metresPer(choice.unit);
        if (hints_.height_m > 0)
            motion_.metres_per_unit = hints_.height_m / stature;
        scale(motion_.clip, motion_.metres_per_unit);
        return Done{};
    }

    void setUp(const SeenMotion& seen) {
        const UpAxisChoice choice = hints_.up == UpAxis::kAuto
                                        ? findUpAxis(motion_.clip, seen, motion_.joints)
                                        : judgeUpAxis(seen, motion_.joints, hints_.up);
        motion_.up = choice.axis;
        constexpr double kUpright = 0.5;
        if (choice.axis != UpAxis::kY)
            note(toText(choice.axis) + " points up in the file; the motion is turned so that Y does");
        if (choice.upright < kUpright)
            warn("With " + toText(choice.axis) +
                 " up the body lies, sits low or stands on its head most of the time; if it does not, "
                 "--up z or --up y turns it");
        else if (choice.doubtful && hints_.up == UpAxis::kAuto)
            warn("Whether " + toText(choice.axis) + " points up is not certain; --up y or --up z says it");
        turnUp(motion_.clip, choice.axis);
    }

    /// Seconds of which thousands pass until a hand has moved by its length are milliseconds.
    void setFrameTime() {
        constexpr double kSuspect_s = 0.5, kStill_m_per_s = 0.03;
        double& step_s = motion_.clip.frame_time_s;
        const size_t frames = motion_.clip.frames.size();
        if (step_s < kSuspect_s || frames < 3)
            return;
        const double speed = extremitySpeed(motion_.clip, motion_.joints);
        if (speed > kStill_m_per_s || speed < 1e-6)
            return;
        warn("Frame Time " + fixed(step_s, 3) + " would make hands and feet move at " +
             fixed(1000 * speed, 1) + " mm/s; it is taken as milliseconds (" + fixed(1000 / step_s, 2) +
             " frames per second)");
        step_s /= 1000;
    }

    void finish() {
        const SeenMotion seen(motion_.clip);
        motion_.measures = measure(motion_.clip, seen, motion_.joints);
        if (hints_.height_m > 0) {
            const double rest = hints_.height_m / motion_.measures.height_m;
            scale(motion_.clip, rest);
            motion_.metres_per_unit *= rest;
            motion_.measures = measure(motion_.clip, SeenMotion(motion_.clip), motion_.joints);
        }
        motion_.rest_pose = restPoseInWords(motion_.clip, SeenMotion(motion_.clip), motion_.joints);
        for (const std::string& warning : figureWarnings(motion_, hints_))
            warn(warning);
    }

    const MotionHints& hints_;
    UnderstoodMotion motion_;
};

std::string unitInWords(const UnderstoodMotion& motion) {
    if (std::abs(motion.metres_per_unit / metresPer(motion.unit) - 1) > 1e-9)
        return "1 unit = " + fixed(motion.metres_per_unit, 5) + " m";
    return "unit " + toText(motion.unit);
}

}  // namespace

Result<UnderstoodMotion> understandMotion(BvhDocument document, const MotionHints& hints) {
    return Understanding(hints).run(std::move(document));
}

std::string describe(const UnderstoodMotion& motion) {
    const double rate = 1 / motion.clip.frame_time_s;
    std::string joints = std::to_string(motion.joints.size()) + " joints";
    if (!motion.by_hand.empty())
        joints += ", " + std::to_string(motion.by_hand.size()) + " by the bone map";
    joints += motion.by_shape.empty() ? " by name"
                                      : ", " + std::to_string(motion.by_shape.size()) + " of them by shape";
    return motion.clip.name + ": " + counted(motion.clip.frames.size(), "frame") + " at " + fixed(rate, 2) +
           " per second; a figure " + fixed(motion.measures.height_m, 2) + " m tall (" + unitInWords(motion) +
           "), " + toText(motion.up) + " up; " + joints + "; zero pose: " + motion.rest_pose;
}

nlohmann::json toJson(const UnderstoodMotion& motion) {
    nlohmann::json joints = nlohmann::json::object();
    for (const auto& [name, joint] : motion.joints)
        joints[name] = motion.clip.skeleton.joint(joint).name;
    const BodyMeasures& m = motion.measures;
    return {{"name", motion.clip.name},
            {"frames", motion.clip.frames.size()},
            {"frames_per_second", 1 / motion.clip.frame_time_s},
            {"unit", toText(motion.unit)},
            {"metres_per_unit", motion.metres_per_unit},
            {"up", toText(motion.up)},
            {"zero_pose", motion.rest_pose},
            {"height_m", m.height_m},
            {"measures_m",
             {{"upper_arm", m.upper_arm_m},
              {"forearm", m.forearm_m},
              {"shoulder_width", m.shoulder_width_m},
              {"thigh", m.thigh_m},
              {"shin", m.shin_m},
              {"hip_width", m.hip_width_m},
              {"foot", m.foot_m}}},
            {"joints", joints},
            {"by_shape", motion.by_shape},
            {"by_hand", motion.by_hand},
            {"lost_frames", motion.lost.bridged + motion.lost.cut_first + motion.lost.cut_last},
            {"notes", motion.notes},
            {"warnings", motion.warnings}};
}

}  // namespace noctule::figure
