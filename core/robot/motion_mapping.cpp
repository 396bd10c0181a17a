// SPDX-License-Identifier: Apache-2.0
#include "core/robot/motion_mapping.h"

#include <algorithm>
#include <memory>

#include "core/math/rotation.h"
#include "core/robot/arm_follower.h"
#include "core/robot/miller_mapping.h"
#include "core/robot/self_collision.h"
#include "core/robot/trunk_follower.h"

namespace noctule::robot {
namespace {

/// One arm of the robot on its way through the motion.
struct DrivenArm {
    ArmFollower follower;
    std::optional<MillerMapping> miller;
    std::vector<StepLimiter> limiters;
    double scale = 1;
    ArmFigures figures;
};

class MotionMapper {
public:
    MotionMapper(const RobotModel& model, const RobotProfile& profile, const MappingChoice& choice,
                 const PerformerArms& performer, double dt_s)
        : model_(model), profile_(profile), choice_(choice), performer_(performer), dt_s_(dt_s) {}

    Status prepare() {
        for (const ArmProfile& arm : profile_.arms)
            if (arm.side == Side::kLeft ? choice_.left : choice_.right)
                if (Status added = add(arm); !added)
                    return added;
        if (arms_.empty())
            return Error{ErrorKind::kUnusable,
                         "robot " + profile_.robot + " has no arm on the side asked for",
                         "Choose another with --arms"};
        if (choice_.trunk) {
            const auto trunk = makeTrunk(model_, profile_);
            if (!trunk)
                return trunk.error();
            trunk_.emplace(*trunk, profile_, dt_s_);
        }
        if (choice_.legs)
            if (Status added = addLegs(); !added)
                return added;
        const auto drive = [&](const Chain& chain) {
            for (const ChainJoint& joint : chain.joints())
                joints_.push_back(joint.model_joint);
        };
        for (const DrivenArm& arm : arms_)
            drive(arm.follower.arm().chain);
        if (trunk_)
            drive(trunk_->trunk().chain);
        for (const DrivenArm& leg : legs_)
            drive(leg.follower.arm().chain);
        for (const int joint : joints_)
            trajectory_.joints.push_back(model_.joints[static_cast<size_t>(joint)].name);
        trajectory_.frame_time_s = dt_s_;
        collision_ = std::make_unique<SelfCollision>(model_, profile_, valuesNow());
        return Done{};
    }

    void add(const PerformerFrame& frame) {
        const bool is_first = trajectory_.frames.empty();
        for (DrivenArm& arm : arms_)
            if (is_first)
                arm.follower.settle(poseFor(arm, frame));
        if (is_first && trunk_)
            trunk_->settle(frame.R_hips_chest);
        for (DrivenArm& leg : legs_)
            if (is_first)
                leg.follower.settle(legFor(leg, frame));
        step(frame);
        std::vector<double> row;
        for (const auto& [joint, value] : orderedNow())
            row.push_back(value);
        trajectory_.frames.push_back(std::move(row));
    }

    RobotTrajectory finish() {
        const double count = std::max<double>(1, static_cast<double>(trajectory_.frames.size()));
        const auto tell = [count](const std::vector<DrivenArm>& limbs, std::vector<ArmFigures>& figures) {
            for (const DrivenArm& limb : limbs) {
                figures.push_back(limb.figures);
                figures.back().upper_mean_deg /= count;
                figures.back().forearm_mean_deg /= count;
                figures.back().wrist_mean_mm /= count;
            }
        };
        tell(arms_, trajectory_.arms);
        tell(legs_, trajectory_.legs);
        trajectory_.nearest_m = nearest_.distance_m;
        if (nearest_.link_a >= 0)
            trajectory_.nearest_parts = model_.links[static_cast<size_t>(nearest_.link_a)].name + " and " +
                                        model_.links[static_cast<size_t>(nearest_.link_b)].name;
        return std::move(trajectory_);
    }

private:
    Status add(const ArmProfile& profile) {
        auto arm = makeArm(model_, profile);
        if (!arm)
            return arm.error();
        const double human_m = performer_.armLength_m(profile.side);
        DrivenArm driven{ArmFollower(*arm, profile_, human_m, dt_s_),
                         std::nullopt,
                         limitersOf(*arm, profile_, dt_s_),
                         arm->length_m / human_m,
                         {}};
        driven.figures.arm = profile.name;
        if (choice_.mapping != Mapping::kPosture) {
            auto miller = MillerMapping::make(*arm);
            if (!miller)
                return miller.error();
            driven.miller.emplace(std::move(*miller));
        }
        arms_.push_back(std::move(driven));
        return Done{};
    }

    Status addLegs() {
        if (performer_.legLength_m() <= 0)
            return Error{ErrorKind::kUnusable, "the performer has no two whole legs",
                         "Leave --legs out, or take a motion of a whole body"};
        auto legs = legsOf(model_, profile_);
        if (!legs)
            return legs.error();
        for (const RobotArm& leg : *legs) {
            legs_.push_back({ArmFollower(leg, profile_, performer_.legLength_m(), dt_s_),
                             std::nullopt,
                             {},
                             leg.length_m / performer_.legLength_m(),
                             {}});
            legs_.back().figures.arm = leg.profile.name;
        }
        return Done{};
    }

    static const ArmPose& legFor(const DrivenArm& leg, const PerformerFrame& frame) {
        return frame.legs->in_hips[static_cast<size_t>(leg.follower.arm().profile.side)];
    }

    /// In the performer's world, scaled as the legs are.
    Eigen::Isometry3d rootFor(const LegsPose& pose) const {
        const RobotArm& leg = legs_.front().follower.arm();
        Eigen::Isometry3d T_world_base = Eigen::Isometry3d::Identity();
        T_world_base.linear() = pose.R_world_hips * leg.profile.R_base_body.transpose();
        T_world_base.translation() =
            legs_.front().scale * pose.p_world_hips_m - T_world_base.linear() * *leg.p_base_centre_m;
        return T_world_base * placeAtZero(model_, model_.findLink(leg.profile.base), 0);
    }

    const ArmPose& poseFor(const DrivenArm& arm, const PerformerFrame& frame) const {
        const auto side = static_cast<size_t>(arm.follower.arm().profile.side);
        return frame.in_chest[side];
    }

    /// The baseline knows no posture but its angles; limits of motion hold for it too.
    ArmCommand followMiller(DrivenArm& arm, const PerformerFrame& frame, bool is_first) {
        const auto side = static_cast<size_t>(arm.follower.arm().profile.side);
        ArmPose seen = frame.in_chest[side];
        if (choice_.mapping == Mapping::kMiller) {
            // Sensors count from the posture in which they were started: facing as in the first frame.
            if (is_first)
                first_heading_rad_ = frame.heading_rad;
            const Matrix3d back = axisAngle(Vector3d::UnitY(), -first_heading_rad_).toRotationMatrix();
            seen.R_upper = back * frame.in_world[side].R_upper;
            seen.R_forearm = back * frame.in_world[side].R_forearm;
        }
        const JointVector wish = arm.miller->map(seen);
        std::vector<JointMotion> motion = arm.follower.motion();
        bool is_limited = false;
        JointVector q(wish.size());
        for (size_t i = 0; i < motion.size(); ++i) {
            const double wanted = wish[static_cast<Eigen::Index>(i)];
            motion[i] =
                is_first ? JointMotion{wanted, 0, 0}
                         : arm.limiters[i].after(motion[i], arm.limiters[i].approach(motion[i], wanted, 0));
            q[static_cast<Eigen::Index>(i)] = motion[i].place;
            is_limited |= std::abs(motion[i].place - wanted) > 1e-6;
        }
        arm.follower.setMotion(motion);
        ArmCommand command = measured(arm.follower.arm(), arm.scale, q, poseFor(arm, frame));
        command.is_limited = is_limited;
        return command;
    }

    /// What a limb did in this frame, and where it was before.
    struct LimbStep {
        std::vector<JointMotion> before;
        ArmCommand command;
    };

    void step(const PerformerFrame& frame) {
        const bool is_first = trajectory_.frames.empty();
        std::vector<LimbStep> arm_steps, leg_steps;
        for (DrivenArm& arm : arms_) {
            std::vector<JointMotion> before = arm.follower.motion();
            arm_steps.push_back({std::move(before), arm.miller ? followMiller(arm, frame, is_first)
                                                               : arm.follower.follow(poseFor(arm, frame))});
        }
        if (trunk_)
            trunk_->follow(frame.R_hips_chest);
        for (DrivenArm& leg : legs_) {
            std::vector<JointMotion> before = leg.follower.motion();
            leg_steps.push_back({std::move(before), leg.follower.follow(legFor(leg, frame))});
        }
        if (!legs_.empty())
            trajectory_.root.push_back(rootFor(*frame.legs));
        keepApart(frame, arm_steps, leg_steps, is_first);
        for (size_t i = 0; i < arms_.size(); ++i)
            count(arm_steps[i].command, arms_[i].figures);
        for (size_t i = 0; i < legs_.size(); ++i)
            count(leg_steps[i].command, legs_[i].figures);
    }

    /// Limbs brake while the robot's own parts would come nearer than the clearance: the arms, or the legs
    /// where no arm is in it.
    void keepApart(const PerformerFrame& frame, std::vector<LimbStep>& arm_steps,
                   std::vector<LimbStep>& leg_steps, bool is_first) {
        if (profile_.clearance_m <= 0)
            return;
        auto near = collision_->nearest(valuesNow());
        if (!is_first && near.distance_m < profile_.clearance_m && near.distance_m < last_near_m_) {
            ++trajectory_.held_frames;
            if (legs_.empty() || isOfArm(near.link_a) || isOfArm(near.link_b))
                for (size_t i = 0; i < arms_.size(); ++i)
                    brake(arms_[i], arm_steps[i], poseFor(arms_[i], frame));
            else
                for (size_t i = 0; i < legs_.size(); ++i)
                    brake(legs_[i], leg_steps[i], legFor(legs_[i], frame));
            near = collision_->nearest(valuesNow());
        }
        last_near_m_ = near.distance_m;
        if (nearest_.link_a < 0 || near.distance_m < nearest_.distance_m)
            nearest_ = near;
    }

    static void brake(DrivenArm& limb, LimbStep& step, const ArmPose& pose) {
        limb.follower.setMotion(step.before);
        step.command = limb.follower.hold(pose);
        step.command.is_limited = true;
    }

    bool isOfArm(int link) const {
        const std::vector<int> above = model_.jointsAbove(link);
        return std::ranges::any_of(arms_, [&](const DrivenArm& arm) {
            return std::ranges::any_of(arm.follower.arm().chain.joints(), [&](const ChainJoint& joint) {
                return std::ranges::find(above, joint.model_joint) != above.end();
            });
        });
    }

    static void count(const ArmCommand& command, ArmFigures& figures) {
        figures.upper_mean_deg += command.upper_deg;
        figures.forearm_mean_deg += command.forearm_deg;
        figures.wrist_mean_mm += command.wrist_mm;
        figures.upper_max_deg = std::max(figures.upper_max_deg, command.upper_deg);
        figures.forearm_max_deg = std::max(figures.forearm_max_deg, command.forearm_deg);
        figures.wrist_max_mm = std::max(figures.wrist_max_mm, command.wrist_mm);
        figures.limited_frames += command.is_limited;
    }

    std::vector<std::pair<int, double>> orderedNow() const {
        std::vector<std::pair<int, double>> values;
        size_t at = 0;
        for (const DrivenArm& arm : arms_)
            for (const JointMotion& motion : arm.follower.motion())
                values.emplace_back(joints_[at++], motion.place);
        if (trunk_)
            for (const JointMotion& motion : trunk_->motion())
                values.emplace_back(joints_[at++], motion.place);
        for (const DrivenArm& leg : legs_)
            for (const JointMotion& motion : leg.follower.motion())
                values.emplace_back(joints_[at++], motion.place);
        return values;
    }
    JointValues valuesNow() const {
        const auto values = orderedNow();
        return JointValues(values.begin(), values.end());
    }

    const RobotModel& model_;
    const RobotProfile& profile_;
    const MappingChoice& choice_;
    const PerformerArms& performer_;
    double dt_s_;
    std::vector<DrivenArm> arms_;
    std::optional<TrunkFollower> trunk_;
    std::vector<DrivenArm> legs_;
    std::vector<int> joints_;
    std::unique_ptr<SelfCollision> collision_;
    SelfCollision::Nearest nearest_;
    double last_near_m_ = 0, first_heading_rad_ = 0;
    RobotTrajectory trajectory_;
};

}  // namespace

Result<RobotTrajectory> mapMotion(const MotionClip& clip, const RobotModel& model,
                                  const RobotProfile& profile, const MappingChoice& choice,
                                  const JobContext& job) {
    if (clip.frames.empty())
        return Error{ErrorKind::kUnusable, clip.name + ": the motion has no frames", "Choose another motion"};
    const auto performer = PerformerArms::make(clip.skeleton, clip.name);
    if (!performer)
        return performer.error();
    MotionMapper mapper(model, profile, choice, *performer, clip.frame_time_s);
    if (Status ready = mapper.prepare(); !ready)
        return ready.error();
    for (size_t frame = 0; frame < clip.frames.size(); ++frame) {
        if (frame % 100 == 0) {
            if (job.cancelled())
                return JobContext::cancelledError();
            job.progress(static_cast<double>(frame) / static_cast<double>(clip.frames.size()), "mapping");
        }
        mapper.add(performer->at(globalPose(clip, frame)));
    }
    return mapper.finish();
}

}  // namespace noctule::robot
