// SPDX-License-Identifier: Apache-2.0
// The movement that a calibration asks for (core/guide/exercises.h), as a performer may do it: one exercise
// after the other, with the rest pose in between, never held twice alike.
#pragma once

#include <cmath>
#include <random>

#include "core/guide/exercises.h"
#include "core/math/rotation.h"
#include "core/motion/clip.h"

namespace noctule::test {

struct GuidedPlan {
    double exercise_s = 7.5;
    double rest_s = 0;    ///< between exercises
    double held_rad = 0;  ///< by which each freedom is off in each of these
    unsigned seed = 1;
};

class GuidedMotion {
public:
    static MotionClip clip(const GuidedPlan& plan = {}) {
        GuidedMotion motion(plan);
        MotionClip clip;
        clip.name = "guided motion";
        clip.skeleton = motion.actor_.skeleton;
        const double lasts_s = kExerciseCount * (plan.exercise_s + plan.rest_s) - plan.rest_s;
        for (int f = 0; f < static_cast<int>(std::lround(lasts_s * 120)); ++f)
            clip.frames.push_back(motion.pose(f / 120.0));
        return clip;
    }

private:
    static constexpr double kPutUp_s = 0.8;  ///< into and out of a pose that is held

    explicit GuidedMotion(const GuidedPlan& plan) : plan_(plan) {
        std::mt19937 random(plan.seed);
        std::normal_distribution<double> off(0, 1);
        for (int rest = 0; rest + 1 < kExerciseCount; ++rest) {
            held_.emplace_back();
            for (int j = 0; j < actor_.skeleton.size(); ++j) {
                const Joint& joint = actor_.skeleton.joint(j);
                Vector3d turn = Vector3d::Zero();
                if (j > 0 && joint.type == JointType::kBall)
                    turn = plan.held_rad * Vector3d{off(random), off(random), off(random)};
                else if (j > 0)
                    for (const DegreeOfFreedom& freedom : joint.dof)
                        turn += plan.held_rad * off(random) * freedom.axis;
                held_.back().push_back(turn);
            }
        }
    }

    Pose pose(double t_s) const {
        const double part_s = plan_.exercise_s + plan_.rest_s;
        const int part = std::min(static_cast<int>(t_s / part_s), kExerciseCount - 1);
        const double within_s = t_s - part * part_s;
        Pose pose = exercisePose(actor_, static_cast<Exercise>(part), std::min(within_s, plan_.exercise_s),
                                 plan_.exercise_s);
        if (plan_.held_rad > 0) {
            hold(part - 1, kPutUp_s - within_s, pose);
            hold(part, within_s - plan_.exercise_s + kPutUp_s, pose);
        }
        return pose;
    }

    /// `since_s`: 0 where the rest pose begins to be taken, kPutUp_s and more while it is held.
    void hold(int rest, double since_s, Pose& pose) const {
        if (rest < 0 || rest + 1 >= kExerciseCount || since_s <= 0)
            return;
        const double u = std::min(1.0, since_s / kPutUp_s), share = u * u * (3 - 2 * u);
        for (size_t j = 0; j < pose.q_parent_joint.size(); ++j)
            pose.q_parent_joint[j] =
                pose.q_parent_joint[j] * expQuaternion(share * held_[static_cast<size_t>(rest)][j]);
    }

    GuidedPlan plan_;
    Actor actor_ = defaultActor();
    std::vector<std::vector<Vector3d>> held_;  ///< per rest pose and joint
};

}  // namespace noctule::test
