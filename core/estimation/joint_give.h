// SPDX-License-Identifier: Apache-2.0
// Joints as they are in people: a knee is a hinge only nearly, and a board on flesh makes it less of one. A
// joint that lacks freedoms and with which a gyroscope turns, on its segment or farther out, is estimated as
// a ball joint that is held where the actor's joint could be. How stiffly follows from the motion itself: the
// deviations that come and go are the variance of those to come, and a joint that hardly gives counts as
// rigid (automatic relevance determination). What joints give together tells how much the boards ride on
// flesh. An actor of ball joints alone teaches nothing: then boards count as riding on flesh, for a filter
// that takes them for rigid is sure of a wrong pose within a second. Where a segment carries no gyroscope
// nobody sees what the joints at its ends give: they count as the others do in the mean.
#pragma once

#include <cmath>
#include <vector>

#include "core/body/kinematics.h"
#include "core/estimation/covariance.h"
#include "core/estimation/limb_ranging.h"

namespace noctule {

struct GiveParameters {
    double initial_rad = 0.01, least_rad = 0.0003, most_rad = 0.15;  ///< deviations from the actor's joint
    double lost_rad = 0.7;             ///< no hinge gives so much: the estimate has lost it
    double lasting_rad = 0.3;          ///< no joint gives more for long: it is turned back so far
    double relevant_rad = 0.02;        ///< below it a joint soon counts as rigid
    double first_s = 1, memory_s = 3;  ///< of learning
    double constant_s = 1;  ///< what stays longer is an error of the estimate, not a joint that gives
    /// Observations of one deviation are alike for a while and count as their white equivalent. In joints
    /// that give, feet turn out and elbows carry for whole stretches of a motion: taken for a few tenths of a
    /// second they turned every joint back to its axis against the gyroscopes, a degree a second.
    double trembles_s = 0.1;
    double lasts_s = 10;
    double lasts_on_flesh_s = 400;  ///< longer: flesh goes with the pose, which comes again and again
    /// Of an actor of ball joints alone, whom nothing teaches: attitudes between boards are as unsure as
    /// this.
    double untaught_rad = 0.06;
};

/// The actor's skeleton with ball joints where `gives` (per joint) and the joint is universal or a hinge.
Skeleton givingSkeleton(const Skeleton& actor, const std::vector<bool>& gives);

class JointGive {
public:
    JointGive() = default;
    /// `tree` of givingSkeleton(actor, gives). `seen`: joints with gyroscopes on both sides, which teach.
    JointGive(const Skeleton& actor, const KinematicTree& tree, const std::vector<bool>& gives,
              const std::vector<bool>& seen, const GiveParameters& parameters);

    /// What the actor's joints say of the state before anything has been learnt.
    std::vector<ObservationBlock> initial(const MotionState& motion) const;
    /// The same once per `interval_s`, after learning how much the joints give.
    std::vector<ObservationBlock> observe(const MotionState& motion, const Covariance& P, double interval_s);
    /// What the actor's joints at both ends of a link say of an error D of its attitude: a^T D b = c, a and b
    /// in the link's frame.
    std::vector<LimbRanging::Held> held(const KinematicTree& tree, int link, const MotionState& motion) const;
    /// Links on hinges that the state has turned farther than any hinge gives.
    std::vector<int> lostLinks(const MotionState& motion) const;
    /// What observe() said of a joint, again about another state; of zero variance.
    ObservationBlock again(const ObservationOrigin& origin, const MotionState& motion) const {
        ObservationBlock block = blockOf(constraints_[static_cast<size_t>(origin.index)], motion);
        if (origin.target.size() > 0)
            block.residual += origin.target;
        return block;
    }

    /// 0 on a rigid body, 1 where boards ride on flesh.
    double fleshShare() const { return flesh_share_; }
    /// Mean square deviation that counts as given, over all constraints that are seen.
    double meanVariance_rad2() const { return mean_variance_rad2_; }

private:
    /// One direction in which the actor's joint would not turn: `fixed_parent` (in the joint's zero frame)
    /// and `moving_link` (in the link's) keep the angle they have in the zero pose. Of a hinge `moving_link`
    /// is its axis, and the deviation counts by angle, not by its sine: turned right round it is not back.
    struct Constraint {
        int link = 0, first = 0;           ///< velocity index
        bool hinge = false, seen = false;  ///< seen: teaches
        Vector3d fixed_parent, moving_link;
        double variance_rad2 = 0, constant_rad = 0;  ///< of the deviations
    };
    ObservationBlock blockOf(const Constraint& constraint, const MotionState& motion) const;
    void learn(Constraint& constraint, double deviation_rad, double estimate_variance,
               double interval_s) const;
    double relevance(const Constraint& constraint) const;
    bool isLost(const Constraint& constraint, const ObservationBlock& block) const {
        return constraint.hinge && std::abs(block.residual[0]) > parameters_.lost_rad;
    }

    GiveParameters parameters_;
    std::vector<Constraint> constraints_;
    bool is_taught_ = true;  ///< the actor is not of ball joints alone, or nothing is worn that tells more
    double seen_s_ = 0;
    double flesh_share_ = 0, mean_variance_rad2_ = 0;
};

}  // namespace noctule
