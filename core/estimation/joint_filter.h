// SPDX-License-Identifier: Apache-2.0
// One estimate of several bodies from all ranges of a take: each body's filter goes on as it would alone,
// ranges between bodies and to anchors of the room correct all states together (joint_covariance.h).
//
// The common state: per suit but the first one the error of its clock (m, m/s), per anchor the error of its
// surveyed place, per source of the room its constant error. Without a room the common place and heading of
// all bodies are those the first one began with, as unsure as for a body alone.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "core/estimation/excess_noise.h"
#include "core/estimation/joint_covariance.h"
#include "core/estimation/rest_alignment.h"

namespace noctule {

struct JointParameters {
    double share = 1;        ///< of the ranges between members that are used, most informative first
    double anchor_m = 0.01;  ///< survey error of a housing, per axis
    double unknown_place_m = 1, unknown_heading_rad = 0.5;  ///< before the rest's ranges are used
    double unknown_clock_m = 2, unknown_rate_m_per_s = 0.01;
    /// Beyond the clocks' lines, per sqrt(s): 0.5 us of wander, 0.05 ppm of the rate's.
    double clock_wander_m = 1.7e-4, rate_wander_m_per_s = 1.7e-5;
    bool clocks_shared = false;
    double gate_sigma = 5, huber_sigma = 2.5;
    double flesh_m = 0.007;  ///< of a microphone or source on soft tissue, as in BoardNoiseParameters
    ExcessNoiseParameters excess{20};
};

/// What a body starts with.
struct JointBody {
    Skeleton skeleton;
    SuitModel suit;
    ManifoldParameters parameters;
    bool clock_known = false;  ///< its line is good to some microseconds
};

class JointFilter {
public:
    /// `clocks`: per body, then of the room. `room`: its anchors at their surveyed places, empty: none is
    /// used. `housings`: per source of the room the board that shares its housing, -1: none. `distances` of
    /// the whole take.
    struct Room {
        SuitModel suit;
        std::vector<int> housings;
        bool clock_known = false;
    };
    JointFilter(std::vector<JointBody> bodies, std::optional<Room> room, std::vector<ClockLine> clocks,
                std::vector<JointDistance> distances, const JointParameters& parameters);

    // For one body; times are those of its suit.
    void start(size_t body, const Pose& rest_pose, const RestReadings& rest);
    ManifoldFilter& filter(size_t body) { return *bodies_[body].filter; }
    const ManifoldFilter& filter(size_t body) const { return *bodies_[body].filter; }
    void promise(size_t body, double time_s) { bodies_[body].given_s = time_s; }
    /// Nothing more comes of it: the others go on without it.
    void end(size_t body);
    std::vector<TimedPose> takePoses(size_t body) { return std::exchange(bodies_[body].poses, {}); }

    /// Goes as far as all bodies' data allow. Nothing happens before each has started. `ended`: what has been
    /// given is all, whatever is due comes out.
    void advance(bool ended = false);

    std::vector<JointDecision> takeDecisions() { return std::exchange(decisions_, {}); }
    const RestAlignment& alignment() const { return alignment_; }
    /// As corrected at the start; how the estimate then moves them is in clockErrors().
    const std::vector<ClockLine>& clocks() const { return alignment_.clocks; }
    /// The line a body's clock keeps to now.
    ClockLine clockNow(size_t member) const;
    double clockSigma_s(size_t member) const;
    bool hasBegun() const { return begun_; }
    /// Anchors (boards of the room) whose ranges contradict the others.
    std::vector<int> movedAnchors() const;
    /// At rest fewer than three anchors agreed. In movement some contradict the others still, or nobody could
    /// be placed.
    bool roomContradicts() const;

    /// Of the vector from a joint of one body to a joint of another, in the frame of the first one's root,
    /// m^2.
    Matrix3d relativeCovariance(size_t body, int joint, size_t other, int other_joint);
    /// Common time that all bodies have reached; those that are over stay where they ended.
    double reached_s() const;

    /// For judging: covariances between bodies and the place of each member's states.
    const JointCovariance& covariance() const { return covariance_; }

private:
    static constexpr double kLeastConfidence = 0.05;  ///< of a range that is used
    struct Body {
        std::unique_ptr<ManifoldFilter> filter;
        std::unique_ptr<ObservationModel> model;
        JointBody made_of;
        KinematicTree tree{};  ///< of the skeleton without laxity
        std::optional<Pose> rest_pose{};
        RestReadings rest{};
        double given_s = 0;
        bool joined = false;  ///< ranges concern it
        bool ended = false;   ///< all of it has been given
        bool shown = true;    ///< the pose of the present step has come out
        std::vector<TimedPose> poses{};
    };
    struct Tally {
        int64_t tried = 0, gated = 0, off = 0;      ///< ranges while it counted
        int64_t left_out = 0, left_out_lately = 0;  ///< while it seemed moved; since it last did
        double off_share = 0;                       ///< of the last ranges, those that are plainly off
        bool moved = false;  ///< it seems so, and is left out until its ranges fit again
    };

    size_t room() const { return bodies_.size(); }
    double now_s(size_t body) const;  ///< common time
    bool isOver(size_t body) const;   ///< all of it has been given, and its last step was made
    void layOut();
    void begin();
    std::vector<RestingMember> restingMembers() const;
    void startBodies();
    void useRest();
    void stepBody(size_t body);
    void refit();
    void show(Body& body);
    void carryCommon(double time_s);
    void useDistances(double until_s);
    std::optional<JointRow> rowOf(const JointDistance& distance, double offset_s, JointDecision& decision);
    Vector3d anchorError(int first) const;
    void observe(std::vector<JointRow> rows, std::vector<JointDecision> decisions);
    std::vector<Eigen::Index> judge(const Eigen::MatrixXd& HPH, std::vector<JointRow>& rows,
                                    std::vector<JointDecision>& decisions);
    std::vector<Eigen::Index> mostInformative(Eigen::MatrixXd HPH, const std::vector<JointRow>& rows,
                                              std::vector<Eigen::Index> among);
    bool isJoined(const JointDistance& distance) const;
    bool isMoved(int anchor) const;
    int anchorOf(const JointDistance& distance) const;
    void noteAnchor(int anchor, bool gated, bool is_off);

    JointParameters parameters_;
    std::vector<Body> bodies_;
    std::optional<Room> room_;
    std::vector<JointDistance> distances_;
    std::vector<size_t> order_;  ///< of distances, by arrival on common time
    size_t next_ = 0;
    RestAlignment alignment_;
    JointCovariance covariance_;
    Eigen::VectorXd common_;                                    ///< the common state
    std::vector<int> clock_at_;                                 ///< per member; -1: none
    std::vector<int> board_at_, source_at_, source_offset_at_;  ///< of the room
    double common_s_ = 0;
    bool begun_ = false;
    double owed_ = 0;  ///< ranges that the share has not used yet
    std::map<std::array<int, 4>, std::pair<ExcessNoise, Eigen::VectorXd>> excess_;  ///< per pair
    std::map<int, Tally> anchors_;
    std::vector<JointDecision> decisions_;
    FilterTape tape_;
};

}  // namespace noctule
