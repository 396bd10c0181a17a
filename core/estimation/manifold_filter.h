// SPDX-License-Identifier: Apache-2.0
// The estimator of choice: an extended Kalman filter over the articulated body with rotations on the manifold
// (right perturbations), rates, accelerations, sensor biases and the constant errors of the distances.
//
// Accelerations are Ornstein-Uhlenbeck processes: a white jerk as in the paper's equation 1, but with a
// finite variance, because as a free random walk the root's acceleration tips the whole body over in minutes.
// Readings of gyroscopes and accelerometers are brought to common instants (reading_grid.h); every distance
// is predicted at its own.
#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "core/estimation/board_noise.h"
#include "core/estimation/covariance.h"
#include "core/estimation/error_state.h"
#include "core/estimation/estimator.h"
#include "core/estimation/filter_tape.h"
#include "core/estimation/ground_contacts.h"
#include "core/estimation/joint_give.h"
#include "core/estimation/limb_alignment.h"
#include "core/estimation/limb_ranging.h"
#include "core/estimation/limb_turn.h"
#include "core/estimation/motion_noise.h"
#include "core/estimation/reading_grid.h"
#include "core/estimation/relocation_parameters.h"
#include "core/estimation/velocity_gain.h"

namespace noctule {

struct ManifoldParameters {
    SensorSelection sensors;
    bool root_given = false;
    bool among_others = false;  ///< part of a joint estimate: the place of a free root counts
    double g_m_per_s2 = kStandardGravity_m_per_s2;

    int steps_per_frame =
        2;  ///< filter steps per 1/140 s; more: distances nearer to their instants, more time

    // Motion: standard deviation of an acceleration, to begin with, and the time over which it changes.
    double joint_accel_rad_per_s2 = 60, joint_accel_time_s = 0.3;
    MotionNoiseParameters motion_noise;
    double root_accel_m_per_s2 = 4, root_accel_time_s = 0.3;
    double root_turn_accel_rad_per_s2 = 25;
    double root_velocity_prior_m_per_s = 2;  ///< free root only, once per prior_interval_s

    /// Biases and the constant errors of distances are states; false: believed to be zero.
    bool estimates_constants = true;

    // Sensors: what is constant over a take and how it wanders. Zero-noise limits are floors of the
    // readings'.
    double gyro_bias_rad_per_s = 0.01, gyro_bias_walk = 0.0003;  ///< walk: per sqrt(s)
    double accel_bias_m_per_s2 = 0.05, accel_bias_walk = 0.001;
    BoardNoiseParameters board_noise;
    LimbAlignmentParameters alignment;
    LimbRangingParameters ranging;
    double search_interval_s = 0.2;  ///< between looks for lost limbs by distances
    VelocityGainParameters velocity_gain;
    double source_offset_m = 0.0008;  ///< 1.5 us of offset error, and what the detector adds per source
    double sound_scale = 0.0015;

    // Start. The rest pose's means are of a body that hardly moves: their rates are the gyroscopes' zeros and
    // their accelerations point up. When the rest ends, motion may begin.
    double initial_pose_rad = 0.035;  ///< per component; at least the true error
    double rest_rate_rad_per_s = 0.0005, rest_accel_rad_per_s2 = 0.01;  ///< means over the rest; root: m
    double initial_rate_rad_per_s = 0.05, initial_accel_rad_per_s2 = 0.5;

    // Robustness. Gyroscopes and accelerometers are not limited: a blow looks like an outlier and is none.
    double distance_gate_sigma = 5, distance_huber_sigma = 2.5;
    double distance_floor_m = 0.0008;  ///< added to every distance: body and sensors are not rigid
    /// Echoes pull an envelope, distances that follow each other alike: as white noise with the same effect.
    double echo_pull_m = 0.00125;

    /// Mean by which a rate beyond a gyroscope's range is believed to exceed it. Readings count separately: n
    /// of them in one turn have the effect of one with a mean of a n-th.
    double excess_rad_per_s = 20;

    /// While a gyroscope is at the end of its range, joints beside its segment are believed to turn about as
    /// fast as they did when they were seen, once per `alike_s`: a trunk that spins as one is no trunk that
    /// comes apart.
    struct Unseen {
        double times_usual = 3, least_rad_per_s = 4;
        double memory_s = 5;  ///< of what is usual
        double alike_s = 0.1;
    } unseen;

    double prior_interval_s = 0.1;

    /// While the whole suit is silent a joint may turn to and fro, about as fast as it usually does. Its
    /// angle's variance then grows, each second, by turn_s times the square of that rate.
    struct Silent {
        double turn_s = 0.3, least_rad_per_s = 0.5;
        double rate_rad_per_s = 0.5, accel_rad_per_s2 = 2;  ///< priors about 0, once per prior_interval_s
    } silent;
    RelocationParameters relocation;

    /// Standard deviation, about each axis, of a board's mounting of which the calibration states none: after
    /// a rest pose alone, straps and soft tissue leave some degrees. Added to the joints' sigmas that come
    /// out; the filter itself does not know it.
    double unstated_mounting_rad = radians(2.5);

    bool joints_give = true;  ///< of people; a robot's are exactly the skeleton's
    GiveParameters give;

    GroundParameters ground;  ///< where the root is free; needs gyroscopes

    /// Where no gyroscope rides on a segment, or none is listened to, nothing holds its joint and a
    /// linearised filter soon believes its own errors: a pull towards how people hold it (usual_pose.h) and
    /// towards rest (per prior_interval_s), and slower motion unless a gyroscope farther out turns with it.
    struct Blind {
        double joint_accel_rad_per_s2 = 10, rate_prior_rad_per_s = 0.5;
    } blind;
    /// The same without any gyroscope.
    Blind all_blind{.joint_accel_rad_per_s2 = 30, .rate_prior_rad_per_s = 0.7};
    /// What a pull's variance has beyond that of the usual pose; all of it, about the rest pose, where
    /// nothing was learnt of a joint. Weights of a pull per prior_interval_s, not how far people deviate.
    double unusual_rad = 0.3, unlearnt_rad = 0.4;
    /// Accelerometers without any gyroscope count as though boards rode on flesh by this share: as levels,
    /// the less the more they were shaken lately.
    double all_blind_flesh_share = 0.15;
};

class ManifoldFilter : public Estimator {
public:
    /// What one step of the filter observes.
    struct StepInput {
        std::vector<RootMeasurement> roots;
        std::vector<InertialMeasurement> inertial;
        std::vector<DistanceMeasurement> distances;
        /// After a silence of the whole suit: the states before and at the end of the step, as readings up to
        /// relocation.window_s later tell them. The step is linearised about these, not about the estimate.
        struct About {
            BodyState from, to;
        };
        std::optional<About> about;
    };
    /// Everything that a step changes: with it and the inputs that followed, any stretch can be filtered
    /// again, to the bit.
    struct Memory {
        BodyState state;
        JointGive give;
        Covariance P;
        MotionNoise motion_noise;
        std::vector<double> heard_s;            ///< per board, of the last step with its turning
        std::vector<double> mean_square_rates;  ///< per link, of one axis, while they are seen
        MotionState fitted;                     ///< the motion that P's errors are those of
        /// While steps are linearised about another state than the estimate, `state` is that other one, and
        /// this error added to it gives the estimate.
        std::optional<Eigen::VectorXd> apart;
        bool lost = false;             ///< the whole suit fell silent, and most of it still is
        std::optional<double> back_s;  ///< since then: when its first board was heard
        double relocated_s = -1e9;
        int64_t step_index = 0;
        std::vector<BoardNoise> board_noise;
        std::vector<LimbAlignment> alignments;  ///< per board
        std::vector<LimbRanging> rangings;      ///< per link
        std::vector<VelocityGain> gains;        ///< per board
        GroundContacts ground;
        double gated_share = 0;  ///< running, over about 60 distances
        int resets = 0;
    };

    ManifoldFilter(const Skeleton& skeleton, SuitModel suit, const ManifoldParameters& parameters);

    void start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) override;
    void add(const InertialMeasurement& measurement) override;
    void add(const DistanceMeasurement& measurement) override;
    void add(const RootMeasurement& measurement) override;
    void advanceTo(double time_s) override;
    void end() override { ended_ = true; }
    std::vector<TimedPose> takePoses() override { return std::exchange(poses_, {}); }
    std::vector<DistanceDecision> takeDecisions() override { return std::exchange(decisions_, {}); }
    std::vector<FootContacts> contacts() const override { return contacts_.feet(); }
    int resets() const override { return now_.resets; }

    /// For smoothers, which drive the filter by steps: advanceTo() is `while (isDue(t)) step(nextInput())`.
    /// The first step after a silence of the whole suit waits for relocation.window_s of readings.
    bool isDue(double time_s);
    double stepSeconds() const { return step_s_; }
    StepInput nextInput();
    void step(const StepInput& input);
    /// What the following steps do goes to `tape`, too; null: nowhere.
    void setTape(FilterTape* tape) { tape_ = tape; }
    const Memory& memory() const { return now_; }
    const Eigen::VectorXd& accelerationDecay() const { return acceleration_decay_; }
    /// What a step adds to the variances of what is constant over a take; zero for all else.
    const Eigen::VectorXd& wander() const { return wander_; }
    /// A block that the filter taped, again: of the same readings with the same variances, but about another
    /// state `at_s`. `input` is that of its step.
    ObservationBlock again(const ObservationBlock& taped, const StepInput& input, const BodyState& state,
                           double at_s);
    void recall(const Memory& memory) { now_ = memory; }
    /// The estimate now, to stand for these times.
    TapedFrame frame(std::vector<int64_t> times_ns) const;
    /// The pose of a frame after its coordinates' error has been found and taken off: `covariance` is what
    /// remains.
    TimedPose poseOf(const TapedFrame& frame, int64_t time_ns, const Eigen::VectorXd& error,
                     const Eigen::MatrixXd& covariance) const;

    const StateLayout& layout() const { return layout_; }
    const BodyState& state() const { return now_.state; }
    /// Time of state().
    double seconds() const { return static_cast<double>(now_.step_index) * step_s_; }
    const Eigen::MatrixXd& covariance() const { return now_.P.dense(); }
    const KinematicTree& tree() const { return tree_; }

    /// For estimates of several bodies together (joint_filter.h), whose readings concern this state and
    /// others. An update of all was made: P := P - x^T x, x of m rows, and the state moves by `correction`.
    void conditionJointly(const Eigen::MatrixXd& x, const Eigen::VectorXd& correction);
    /// Errors are those of the present estimate from here on: before what is read is read of a joint state,
    /// or readings seem to tell what nobody sees.
    void refit() { fitErrors(); }
    /// Nothing is known yet of where a free root stands on the floor and where it faces.
    void loosenRoot(double place_m, double heading_rad);
    const SuitModel& suit() const { return suit_; }
    const ManifoldParameters& parameters() const { return parameters_; }
    double fleshShare() const { return now_.give.fleshShare(); }
    /// A pose is wanted at the present step.
    bool isAtFrame() const { return now_.step_index % parameters_.steps_per_frame == 0; }
    TimedPose poseNow() const { return estimateAt(seconds()); }

private:
    StepInput takeInput();
    struct Hearing {
        size_t worn = 0, heard = 0;
    };
    /// Of the boards on the body that have ever been heard: those that were within so many seconds, or are
    /// now.
    Hearing hearing(double within_s, const std::vector<InertialMeasurement>& now = {}) const;
    bool speaks(const InertialMeasurement& measurement) const;
    /// Nothing has been heard for relocation.silence_s.
    bool isSilent() const;
    void noteSilence();
    bool findsTheBody(const StepInput& input) const;
    void holdInSilence();
    void predictAbout(const StepInput::About& about);
    void linearise(const BodyState& state);
    void returnToEstimate();
    Eigen::VectorXd estimatedAccel() const;
    void initialise(const Pose& rest_pose);
    void expectUsualPose(const Pose& rest_pose);
    GroundParameters groundParameters() const;
    void settle(const RestReadings& rest, const RootMeasurement* root);
    void predict(double dt_s);
    std::vector<bool> clippedLinks(const std::vector<InertialMeasurement>& measurements) const;
    void allowForClipping(const std::vector<InertialMeasurement>& measurements);
    void updateRoot(const std::vector<RootMeasurement>& measurements);
    void updateTriads(const std::vector<InertialMeasurement>& measurements, bool gyro);
    void believeBeyond(ObservationBlock& block, const TriadReading& reading, double mean_excess) const;
    void updateVelocityGains(const std::vector<InertialMeasurement>& measurements);
    bool knowsVelocityOf(const MountedBoard& board) const;
    int referenceOfGains() const;
    ObservationBlock observeGainOf(int board, int reference);
    /// Of zero variance; `target`: the packed windows of the board and of the reference, if there is one.
    ObservationBlock gainOf(int board, const Eigen::VectorXd& target, const BodyState& state) const;
    void alignLimbs(const std::vector<InertialMeasurement>& measurements);
    void loosen(int link, double sigma_rad);
    void turnLimb(int link, const LimbAlignment::Found& found);
    using LimbTarget = Eigen::Matrix<double, 8, 1>;
    void watchLimbs(const std::vector<InertialMeasurement>& measurements);
    void noteForLimbs(const DistanceMeasurement& measurement);
    void noteEnd(const ChainMotion& chain, int link, const Vector3d& p_end_m, int other_link,
                 const Vector3d& p_other_m, const DistanceMeasurement& measurement);
    void searchLimbs();
    /// That a limb turns like this against its parent, along the axes of another frame; of zero variance.
    /// `target`: both quaternions, x y z w.
    ObservationBlock turnOf(int link, const LimbTarget& target, const MotionState& motion) const;
    void updateDistances(const std::vector<DistanceMeasurement>& measurements);
    bool judgeDistance(const DistanceMeasurement& known, ObservationBlock& block, DistanceDecision& decision);
    void useCarrier(DistanceMeasurement& measurement, ObservationBlock& block) const;
    void updateGround(const std::vector<InertialMeasurement>& measurements);
    void updatePriors();
    void holdUnseenRates(const std::vector<bool>& clipped_links);
    void observe(std::vector<ObservationBlock> blocks);
    const ManifoldParameters::Blind& blindness() const {
        return parameters_.sensors.gyroscopes ? parameters_.blind : parameters_.all_blind;
    }
    bool isBlind(const Link& link) const { return !gyroscope_joints_[static_cast<size_t>(link.joint)]; }
    void noteHeard(const std::vector<InertialMeasurement>& measurements);
    /// Per link: its boards are silent, as most of the suit is.
    std::vector<bool> silentLinks() const;
    double valueOf(const BodyState& state, int column) const;
    void correct(const Eigen::VectorXd& delta);
    void widen(int first, int count, double sigma);
    void noteGating(bool gated);
    void beginAnew(int link);
    void bringBackRunaways();
    /// Gyroscopes alone would lose at every onset of a motion what nothing gives back to them.
    bool learnsMotion() const {
        const SensorSelection& sensors = parameters_.sensors;
        return sensors.gyroscopes && (sensors.accelerometers || sensors.distances);
    }
    /// Nobody else knows the root.
    bool isFree() const { return tree_.link(0).type == LinkType::kFree && !parameters_.root_given; }
    /// Makes P fit the corrected estimate, so that what no reading tells stays so. A step begins with the
    /// same: predict() carries the limbs' part in one pass with its own.
    void fitErrors();
    void fitHeading();
    LinkTransitions shiftOfLimbs() const;
    template <class Shift>
    void carryErrors(Shift shift);
    TimedPose estimateAt(double time_s) const;
    void emitRestPoses(const RestReadings& rest);

    ManifoldParameters parameters_;
    Skeleton skeleton_;
    std::vector<bool> gyroscope_joints_;  ///< whose segments carry a gyroscope in use
    std::vector<bool> turning_joints_;    ///< with which one turns, on theirs or farther out
    KinematicTree tree_;
    SuitModel suit_;
    std::vector<Matrix3d> mounting_rad2_;  ///< as in jointSigmas()
    StateLayout layout_;
    ObservationModel observations_;
    Memory now_;                          ///< the state's time is step_index * step_s_
    MotionState usual_;                   ///< for the pose prior
    Eigen::VectorXd usual_variance_;      ///< of each coordinate about it, rad^2
    Eigen::VectorXd acceleration_decay_;  ///< per velocity index, for one step
    Eigen::VectorXd wander_;
    double step_s_ = 0;
    ReadingGrid inertial_;
    bool ended_ = false;
    std::deque<StepInput> ahead_;  ///< inputs of the next steps, as far as they were looked at
    TimeQueue<DistanceMeasurement> distances_;
    TimeQueue<RootMeasurement> roots_;
    FilterTape* tape_ = nullptr;
    std::vector<TimedPose> poses_;
    std::vector<DistanceDecision> decisions_;
    ContactLog contacts_;
};

}  // namespace noctule
